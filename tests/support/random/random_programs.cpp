#include "support/random/random_programs.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "base/random.h"
#include "base/units.h"

namespace clearcut::test_support {
namespace {

constexpr std::array<const char*, 5> kComments{"(END OF PROGRAM)", "(TOOL CHANGE T9: D3)", "(OPERATION 2: B)",
                                               "(M2 G0 Z-50)", "; END OF PROGRAM"};

class Writer {
 public:
  explicit Writer(std::uint64_t seed) : random_(seed) {}

  std::string program(int blocks) {
    line("G21 G17 G90 G91.1 G94 G40 G49 G80 F200");
    line("S1000 M3");
    for (int k = 0; k < blocks; ++k) block();
    line("M2");
    return text_;
  }

 private:
  static constexpr std::array<std::array<int, 3>, 3> kPlanes{{{0, 1, 2}, {2, 0, 1}, {1, 2, 0}}};

  bool chance(double p) { return random_.unit() < p; }
  int any(int n) { return static_cast<int>(random_.below(static_cast<std::uint64_t>(n))); }
  /// A number of the program, in its units; about 60 mm at most.
  double number(double size = 50) { return std::round(random_.between(-size, size) / unit_ * 1e3) / 1e3; }
  double positive(double low, double high) {
    return std::round(random_.between(low, high) / unit_ * 1e3) / 1e3 + 0.001;
  }
  static std::string word(char letter, double value) { return fmt::format(" {}{:.5f}", letter, value); }

  void line(const std::string& words) {
    ++lines_;
    const std::string deleted = chance(0.01) ? "/" : "";
    std::string text = fmt::format("{}N{} {}", deleted, lines_, words);
    if (chance(0.05)) text += std::string(" ") + kComments[static_cast<std::size_t>(any(5))];
    text_ += text + "\n";
  }

  void block() {
    switch (any(20)) {
      case 0:
        return modes();
      case 1:
        return offsets();
      case 2:
        return reference();
      case 3:
        return lengths();
      case 4:
        return still();
      case 5:
      case 6:
      case 7:
      case 8:
      case 9:
        return arc();
      case 10:
      case 11:
      case 12:
        return cycle();
      default:
        return straight();
    }
  }

  std::string axes(bool some) {
    std::string words;
    for (int axis = 0; axis < 3; ++axis) {
      if (!chance(0.5)) continue;
      words += word("XYZ"[axis], number(absolute_ ? 50 : 15));
    }
    if (words.empty() && some) words = word('X', number(15));
    return words;
  }

  void straight() {
    const bool rapid = chance(0.4);
    const bool repeat = straight_ && motion_ == (rapid ? 0 : 1) && chance(0.5);
    std::string words = repeat ? "" : rapid ? "G0" : "G1";
    const bool machine = absolute_ && chance(0.1);
    if (machine) words = std::string("G53 ") + (rapid ? "G0" : "G1");
    if (!machine && chance(0.1)) words += " G4 P0.1";
    if (chance(0.1)) words += fmt::format(" F{}", 10 + any(900));
    motion_ = rapid ? 0 : 1;
    straight_ = true;
    line(words + axes(true));
  }

  void modes() {
    switch (any(6)) {
      case 0:
        plane_ = any(3);
        return line(fmt::format("G{}", 17 + plane_));
      case 1:
        unit_ = chance(0.5) ? 25.4 : 1;
        line("G49");  // the interpreter alone, without a machine, keeps lengths in the unit they were said in
        return line(unit_ == 1 ? "G21" : "G20");
      case 2:
        absolute_ = chance(0.6);
        return line(absolute_ ? "G90" : "G91");
      case 3:
        absolute_centers_ = chance(0.5);
        return line(absolute_centers_ ? "G90.1" : "G91.1");
      case 4:
        return line(chance(0.5) ? "G61" : "G64 P0.01 Q0.01");
      default:
        save();
    }
  }

  void save() {
    const double unit = unit_;
    const int plane = plane_;
    const bool absolute = absolute_, centers = absolute_centers_;
    line("G49");
    line("M70");
    const int between = any(4);
    for (int k = 0; k < between; ++k) chance(0.5) ? straight() : quick_mode();
    line("M72");
    unit_ = unit;
    plane_ = plane;
    absolute_ = absolute;
    absolute_centers_ = centers;
  }
  void quick_mode() {
    constexpr std::array<const char*, 6> kWords{"G91", "G20", "G18", "G55", "G90.1", "G98"};
    const int which = any(6);
    if (which == 0) absolute_ = false;
    if (which == 1) unit_ = 25.4;
    line(kWords[static_cast<std::size_t>(which)]);
  }

  void offsets() {
    constexpr std::array<const char*, 9> kSystems{"G54", "G55",   "G56",   "G57",  "G58",
                                                  "G59", "G59.1", "G59.2", "G59.3"};
    switch (any(6)) {
      case 0:
        return line(fmt::format("G10 L2 P{}", any(10)) + axes(true));
      case 1:
        return line(fmt::format("G10 L20 P{}", any(10)) + axes(true));
      case 2:
        shifted_ = true;
        return line("G92" + axes(true));
      case 3:
        // G92.3 restores what an earlier G92 has shifted by: nothing states what ran before the program.
        return line(fmt::format("G92.{}", 1 + any(shifted_ ? 3 : 2)));
      case 4:
        return line("G52" + axes(true));
      default:
        return line(kSystems[static_cast<std::size_t>(any(9))]);
    }
  }

  void reference() {
    const std::string g = chance(0.5) ? "G28" : "G30";
    if (chance(0.3)) return line(g + ".1");
    line(chance(0.3) ? g : g + axes(true));
  }

  void lengths() {
    switch (any(4)) {
      case 0:
        return line("G43.1" + word('Z', number(10)));
      case 1:
        return line("G49");
      case 2:
        return line(fmt::format("G43 H{}", 1 + any(9)));
      default:
        // Without a machine, a tool change forgets where the tool is.
        line("G49");
        line(fmt::format("T{} M6", 1 + any(9)));
        stand();
    }
  }

  void still() {
    constexpr std::array<const char*, 9> kWords{
        "M7", "M8", "M9", "M48", "G4 P0.2", "M49", "M1", "F99", "(OPERATION 7: Q)"};
    line(kWords[static_cast<std::size_t>(any(9))]);
  }

  /// States where the tool is, so that the ends of an arc can be said absolutely.
  std::array<double, 3> stand() {
    std::array<double, 3> at{number(), number(), number()};
    line(std::string(chance(0.5) ? "G0" : "G1") + " G90" + word('X', at[0]) + word('Y', at[1]) +
         word('Z', at[2]));
    absolute_ = true;
    if (!chance(0.3)) return at;
    absolute_ = false;
    line("G91");
    return at;
  }

  void arc() {
    const auto at = stand();
    const auto& axes = kPlanes[static_cast<std::size_t>(plane_)];
    const auto first = static_cast<std::size_t>(axes[0]), second = static_cast<std::size_t>(axes[1]),
               across = static_cast<std::size_t>(axes[2]);
    const double radius = positive(1, 30), from = random_.between(0, 2 * kPi);
    const bool left = chance(0.5), full = chance(0.15), by_radius = !full && chance(0.3);
    const double sweep = full ? 2 * kPi : random_.between(0.1, by_radius ? 2.8 : 6.1);
    const double to = from + (left ? sweep : -sweep);
    const double centers[2]{at[first] - radius * std::cos(from), at[second] - radius * std::sin(from)};
    const double end[2]{full ? at[first] : centers[0] + radius * std::cos(to),
                        full ? at[second] : centers[1] + radius * std::sin(to)};
    const double base[2]{absolute_ ? 0 : at[first], absolute_ ? 0 : at[second]};
    std::string words = left ? "G3" : "G2";
    if (!full || chance(0.5)) {
      words += word("XYZ"[first], end[0] - base[0]) + word("XYZ"[second], end[1] - base[1]);
    }
    if (chance(0.4)) words += word("XYZ"[across], number(absolute_ ? 50 : 9));
    if (by_radius) {
      words += word('R', radius);
    } else {
      words += word("IJK"[first], absolute_centers_ ? centers[0] : centers[0] - at[first]) +
               word("IJK"[second], absolute_centers_ ? centers[1] : centers[1] - at[second]);
      if (chance(0.2)) words += fmt::format(" P{}", 1 + any(3));
    }
    straight_ = false;
    line(words);
  }

  void cycle() {
    constexpr std::array<int, 8> kCodes{73, 81, 82, 83, 84, 85, 86, 89};
    // Tapping outside the XY plane mixes the axes up in LinuxCNC.
    const int chosen = kCodes[static_cast<std::size_t>(any(8))],
              code = chosen == 84 && plane_ != 0 ? 81 : chosen;
    if (chance(0.7)) stand();
    if (code == 84 || code == 86) line("M3");
    const auto& axes = kPlanes[static_cast<std::size_t>(plane_)];
    double bottom = absolute_ ? number(20) : -positive(1, 9);
    double r = absolute_ ? bottom + positive(0, 12) : number(9);
    std::string words = fmt::format("G{}", code);
    if (chance(0.5)) words = (chance(0.5) ? "G98 " : "G99 ") + words;
    words += place(axes) + word("XYZ"[axes[2]], bottom) + word('R', r);
    // Never a whole number of pecks: rounding would decide about one more, of no depth.
    if (code == 73 || code == 83) words += word('Q', positive(0.5, 4) + 0.00037);
    const bool dwells = code == 82 || code == 89 || code == 86 || code == 84;
    if (dwells) words += " P0.1";
    if (chance(0.2)) words += fmt::format(" L{}", 1 + any(3));
    line(words);
    for (int more = any(4); more > 0; --more) {
      std::string next = chance(0.2) ? (chance(0.5) ? "G98 " : "G99 ") : "";
      next += place(axes);
      if (chance(0.2)) {
        bottom -= positive(0, 3);
        next += word("XYZ"[axes[2]], bottom);
      }
      if (chance(0.2)) {
        r = chance(0.5) && absolute_ ? bottom + positive(0, 12) : r + positive(0, 3);
        next += word('R', r);
      }
      if (dwells) next += " P0.1";
      line(next);
    }
    straight_ = false;
    if (chance(0.7)) line("G80");
  }
  std::string place(const std::array<int, 3>& axes) {
    std::string words;
    if (chance(0.7)) words += word("XYZ"[axes[0]], number(absolute_ ? 50 : 9));
    if (chance(0.7) || words.empty()) words += word("XYZ"[axes[1]], number(absolute_ ? 50 : 9));
    return words;
  }

  Random random_;
  bool shifted_ = false;  ///< by a G92
  std::string text_;
  int lines_ = 0;
  double unit_ = 1;
  bool absolute_ = true, absolute_centers_ = false;
  bool straight_ = false;
  int plane_ = 0, motion_ = 0;
};

}  // namespace

std::string random_program(std::uint64_t seed, int blocks) {
  return Writer(seed).program(blocks);
}

}  // namespace clearcut::test_support
