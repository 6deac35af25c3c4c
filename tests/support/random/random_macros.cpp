#include "support/random/random_macros.h"

#include <fmt/format.h>

#include <array>
#include <vector>

#include "base/random.h"

namespace clearcut::test_support {
namespace {

class MacroWriter {
 public:
  explicit MacroWriter(std::uint64_t seed) : random_(seed), interrupts_(chance(0.5)) {}

  std::string program() {
    line("G21 G17 G90 G91.1 G94 G40 G49 G80 F200");
    line("G0 X0 Y0 Z5");
    for (int n = 1; n <= 12; ++n) line(fmt::format("#{} = {}", n, number()));
    line("#<a> = 3");
    line("#<_g> = [#1 + 0.5]");
    const int subs = any(4);
    for (int k = 0; k < subs; ++k) sub(k);
    is_main_ = true;
    subs_ = subs;
    for (int k = 4 + any(6); k > 0; --k) statement(0);
    line("G1 X60 Y61 Z62");
    line("M2");
    return text_;
  }

 private:
  bool chance(double p) { return random_.unit() < p; }
  int any(int n) { return static_cast<int>(random_.below(static_cast<std::uint64_t>(n))); }
  template <std::size_t n>
  std::string one_of(const std::array<const char*, n>& list) {
    return list[static_cast<std::size_t>(any(static_cast<int>(n)))];
  }
  void line(const std::string& words) {
    text_ += std::string(static_cast<std::size_t>(depth_) * 2, ' ') + words + "\n";
  }
  std::string number() { return fmt::format("{:.2f}", any(2000) / 100.0 - 10); }

  std::string parameter() {
    switch (any(8)) {
      case 0:
        return "#<_g>";
      case 1:
        return "#<a>";
      case 2:
        return "#[1 + 1]";
      case 3:
        return sets_ ? "#7" : "#5420";
      case 4:
        return one_of<3>({sets_ ? "#8" : "#<_x>", "#<_metric>", "#<_call_level>"});
      default:
        return fmt::format("#{}", 1 + any(12));
    }
  }

  std::string value(int depth) {
    if (depth <= 0 || chance(0.25)) return chance(0.5) ? number() : (chance(0.1) ? "-" : "") + parameter();
    switch (any(10)) {
      case 0:
        return fmt::format("{}[{}]", one_of<4>({"abs", "fix", "fup", "round"}), sum(depth - 1));
      case 1:
        return fmt::format("{}[{}]", one_of<2>({"sin", "cos"}), sum(depth - 1));
      case 2:
        return fmt::format("atan[{}]/[{}]", sum(depth - 1), sum(depth - 1));
      case 3:
        return fmt::format("sqrt[abs[{}]]", sum(depth - 1));
      case 4:
        return fmt::format("ln[abs[{}] + 1]", sum(depth - 1));
      case 5:
        return fmt::format("exp[[{}] mod 3]", sum(depth - 1));
      case 6:
        return fmt::format("EXISTS[#<{}>]", chance(0.5) ? "a" : "nowhere");
      default:
        return "[" + sum(depth - 1) + "]";
    }
  }

  /// Terms without brackets around them: the order of operators matters.
  std::string sum(int depth) {
    std::string text = value(depth);
    for (int k = any(3); k > 0; --k) {
      const int which = any(12);
      if (which < 5) {
        text += one_of<3>({" + ", " - ", "*"}) + value(depth - 1);
      } else if (which < 6) {
        text += fmt::format(" / [abs[{}] + 1]", sum(depth - 1));
      } else if (which < 7) {
        text += fmt::format(" mod {}", 2 + any(7));
      } else if (which < 8) {
        text = fmt::format("[[{}] mod 4] ** {} ** {}", text, 1 + any(2), 1 + any(2));
      } else if (which < 10) {
        text += one_of<6>({" gt ", " ge ", " lt ", " le ", " eq ", " ne "}) + value(depth - 1);
      } else {
        text += one_of<3>({" and ", " or ", " xor "}) + value(depth - 1);
      }
    }
    return text;
  }
  /// LinuxCNC takes 252 characters a line.
  std::string short_sum(int depth) {
    std::string text;
    do text = sum(depth);
    while (text.size() > 34);
    return text;
  }
  /// Off the multiples of 50, where the last bit of a sine would decide.
  std::string place() { return fmt::format("[[{} + 0.003] mod 50]", "[" + short_sum(2) + "]"); }
  std::string condition() { return fmt::format("[{}]", short_sum(2)); }

  void move() {
    std::string words = one_of<3>({"G1", "G0", "G1"});
    for (const char axis : {'X', 'Y', 'Z'})
      if (chance(0.6)) words += fmt::format(" {}{}", axis, place());
    if (words.size() == 2) words += fmt::format(" X{}", place());
    if (chance(0.15)) words += fmt::format(" #{} = {}", 1 + any(12), kept_place());
    line(words);
  }
  void arc() {
    line(fmt::format("G1 X{} Y{}", place(), place()));
    line(fmt::format("G{} X[#5420 + 6] I3 J0", 2 + any(2)));
  }
  /// Without the place where the tool is: in a loop it would blow the last bit of a sine up to millimetres.
  std::string kept_place() {
    sets_ = true;
    std::string text = place();
    sets_ = false;
    return text;
  }
  void assignment() {
    switch (any(4)) {
      case 0:
        return line(fmt::format("#<_g> = {}", kept_place()));
      case 1:
        return line(fmt::format("#<a> = {}", kept_place()));
      default:
        return line(fmt::format("#{} = {}", 1 + any(12), kept_place()));
    }
  }

  void body(int depth) {
    ++depth_;
    for (int k = 1 + any(3); k > 0; --k) statement(depth + 1);
    --depth_;
  }

  void statement(int depth) {
    const int which = depth > 2 ? any(8) : any(16);
    if (which < 4) return move();
    if (which < 6) return assignment();
    if (which < 7) return arc();
    if (which < 8) return polar();
    if (which < 10) return branch(depth);
    if (which < 13) return loop(depth);
    if (is_main_ && subs_ > 0) return call();
    move();
  }

  void polar() {
    line(fmt::format("G1 @[{} + 1] ^{}", place(), place()));
    if (chance(0.5)) line(fmt::format("G1 @{}", place()));
  }

  void branch(int depth) {
    const int label = ++labels_;
    line(fmt::format("o{} if {}", label, condition()));
    body(depth);
    for (int k = any(3); k > 0; --k) {
      line(fmt::format("o{} elseif {}", label, condition()));
      body(depth);
    }
    if (chance(0.5)) {
      line(fmt::format("o{} else", label));
      body(depth);
    }
    line(fmt::format("o{} endif", label));
  }

  void interrupt(int label, int depth) {
    const int inner = ++labels_;
    line(fmt::format("o{} if {}", inner, condition()));
    body(depth + 2);
    line(fmt::format("  o{} {}", label, chance(0.5) ? "continue" : "break"));
    line(fmt::format("o{} endif", inner));
  }

  void loop(int depth) {
    const int label = ++labels_;
    const std::string counter = fmt::format("<c{}>", label);  // nothing else sets it: every loop ends
    ++depth_;
    switch (any(interrupts_ ? 2 : 3)) {
      case 0:
        --depth_;
        line(fmt::format("o{} repeat [{}]", label, any(16) / 4.0));
        ++depth_;
        body(depth);
        --depth_;
        line(fmt::format("o{} endrepeat", label));
        return;
      case 1:
        --depth_;
        line(fmt::format("#{} = 0", counter));
        line(fmt::format("o{} while [#{} lt {}]", label, counter, any(4)));
        ++depth_;
        line(fmt::format("#{} = [#{} + 1]", counter, counter));
        if (interrupts_ && chance(0.3)) interrupt(label, depth);
        body(depth);
        --depth_;
        line(fmt::format("o{} endwhile", label));
        return;
      default:
        --depth_;
        line(fmt::format("#{} = 0", counter));
        line(fmt::format("o{} do", label));
        ++depth_;
        line(fmt::format("#{} = [#{} + 1]", counter, counter));
        body(depth);
        --depth_;
        line(fmt::format("o{} while [#{} lt {}]", label, counter, any(4)));
    }
  }

  static std::string sub_name(int k) {
    return k % 2 == 0 ? fmt::format("<part {}>", k) : fmt::format("{}", 900 + k);
  }

  void sub(int k) {
    is_main_ = false;
    line(fmt::format("o{} sub", sub_name(k)));
    ++depth_;
    line("#<a> = #2");
    for (int n = 1 + any(3); n > 0; --n) statement(1);
    if (k > 0 && chance(0.5)) line(fmt::format("o{} call [{}] [2]", sub_name(any(k)), number()));
    if (chance(0.3)) {
      const int label = ++labels_;
      line(fmt::format("o{} if {}", label, condition()));
      line(fmt::format("o{} return [{}]", sub_name(k), short_sum(1)));
      line(fmt::format("o{} endif", label));
    }
    --depth_;
    line(fmt::format("o{} endsub{}", sub_name(k), chance(0.5) ? fmt::format(" [{}]", short_sum(1)) : ""));
  }

  void call() {
    std::string words = fmt::format("o{} call", sub_name(any(subs_)));
    for (int k = any(4); k > 0; --k) words += fmt::format(" [{}]", short_sum(1));
    line(words);
    if (chance(0.3)) line("G1 X[[#<_value>] mod 50] Y#<_value_returned>");
  }

  Random random_;
  std::string text_;
  int labels_ = 100;
  int depth_ = 0;
  int subs_ = 0;
  bool is_main_ = false;
  bool sets_ = false;  ///< a parameter is set
  /// With break or continue in a program the interpreter (2.9) goes astray in its DO loops: a program has one or the other.
  bool interrupts_;
};

}  // namespace

std::string random_macro_program(std::uint64_t seed) {
  return MacroWriter(seed).program();
}

}  // namespace clearcut::test_support
