#include "read/board/excellon_reader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include "base/error.h"
#include "base/text.h"
#include "base/units.h"
#include "read/board/drawn.h"
#include "read/common/text.h"

namespace clearcut::read {
namespace {

constexpr std::size_t kMostHoles = 1'000'000;
constexpr double kMostRepeatedHoles = 10000;
/// Least radius as a share of half the distance of an arc's ends: radii are rounded.
constexpr double kLeastRadius = 0.99;

/// One move; absent coordinates are unchanged.
struct DrillMove {
  GerberMove to;
  std::optional<double> radius;  ///< mm; radius of a routed arc
};

class ExcellonReader {
 public:
  ExcellonReader(const std::string& file, const ReadOptions& options, Diagnostics& diagnostics)
      : file_(file), diagnostics_(diagnostics) {
    if (options.unit) set_unit(require_unit(*options.unit, "unit"), true);
  }

  std::map<int, DrillTool> read(std::string_view text) {
    const char line_end = line_end_of(text);
    for (std::size_t at = 0; at < text.size() && !ended_;) {
      const std::size_t end = std::min(text.find(line_end, at), text.size());
      std::string_view line = text.substr(at, end - at);
      while (!line.empty() && static_cast<unsigned char>(line.back()) <= ' ') line.remove_suffix(1);
      ++line_;
      if (!line.empty()) take(line);
      at = end + 1;
    }
    if (!ended_) fail("the file ends without M30: it is cut short; export it again");
    finish_route();
    say_what_was_assumed();
    return std::move(tools_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(file_ + ":" + std::to_string(line_), what);
  }
  [[noreturn]] void not_understood(std::string_view line) const {
    fail("'" + printable(line) +
         "' is not understood; export the drill file again (Excellon, decimal numbers, no patterns)");
  }

  void say_what_was_assumed() const {
    if (assumed_ && has_digits_)
      diagnostics_.warn(
          file_, "the file does not say how its numbers are written: " + std::to_string(format_.decimals) +
                     " digits after the point assumed; compare the size");
    if (taken_for_down_ > 0)
      diagnostics_.warn(file_, "G01 without M15, which lowers the tool: taken for slots; compare them");
    if (above_ > 0)
      diagnostics_.warn(file_, std::to_string(above_) +
                                   (above_ == 1 ? " move at the feed is" : " moves at the feed are") +
                                   " above the board (no M15 before): nothing is cut there");
  }

  void take(std::string_view line) {
    if (line[0] == ';') return comment(line);
    if (line == "%" || line == "M95") return void(in_header_ = false);
    if (line == "M48") return void(in_header_ = true);
    in_header_ ? header(line) : body(line);
  }

  /// ";FILE_FORMAT=2:4".
  void comment(std::string_view line) {
    const std::size_t at = line.find("FILE_FORMAT=");
    if (at == std::string_view::npos) return;
    const std::string_view digits = line.substr(at + 12);
    if (digits.size() < 3 || digits[1] != ':') return;
    set_digits(digits[0] - '0', digits[2] - '0');
  }

  void set_digits(int whole, int decimals) {
    if (whole < 0 || whole > 6 || decimals < 0 || decimals > 6) return;
    format_.whole = whole;
    format_.decimals = decimals;
    assumed_ = false;
    stated_digits_ = true;
  }

  void set_unit(double mm, bool overrules) {
    if (unit_overruled_ && !overrules) return;
    mm_ = mm;
    unit_overruled_ = overrules;
    has_unit_ = true;
    if (!stated_digits_)
      format_.whole = mm == kMmPerInch ? 2 : 3, format_.decimals = mm == kMmPerInch ? 4 : 3;
  }

  /// "METRIC,TZ,000.000", "INCH,LZ".
  void unit(std::string_view line) {
    set_unit(line.starts_with("METRIC") ? 1 : kMmPerInch, false);
    for (std::size_t at = line.find(','); at != std::string_view::npos; at = line.find(',', at + 1)) {
      const std::string_view field = line.substr(at + 1, line.find(',', at + 1) - at - 1);
      if (field == "LZ") format_.trailing_omitted = true, assumed_ = false;
      if (field == "TZ") format_.trailing_omitted = false, assumed_ = false;
      const std::size_t point = field.find('.');
      if (point != std::string_view::npos && field.find_first_not_of("0.") == std::string_view::npos)
        set_digits(static_cast<int>(point), static_cast<int>(field.size() - point - 1));
    }
  }

  void header(std::string_view line) {
    if (line.starts_with("METRIC") || line.starts_with("INCH")) return unit(line);
    if (line == "M71") return set_unit(1, false);
    if (line == "M72") return set_unit(kMmPerInch, false);
    if (line[0] == 'T' && line.find('C') != std::string_view::npos) return define_tool(line);
    if (line == "ICI,ON") incremental_ = true;
    for (const std::string_view known :
         {"FMAT", "VER", "DETECT", "ATC", "ICI", "G90", "R,", "T", "TCST", "AFS", "CCW", "CP"})
      if (line.starts_with(known)) return;
    diagnostics_.warn(file_ + ":" + std::to_string(line_),
                      "'" + printable(line) + "' in the header is not used");
  }

  /// "T1C0.8", "T01F85S300C.0118".
  void define_tool(std::string_view line) {
    const auto words = words_of(line);
    if (!words || words->empty()) not_understood(line);
    const auto number = code_number(words->front().second);
    for (const auto& [letter, digits] : *words) {
      if (letter != 'C' || !number) continue;
      const auto diameter = plain_number(digits);
      if (!diameter || !(*diameter > 0)) not_understood(line);
      tools_[*number].diameter = *diameter * mm_;
    }
  }

  void body(std::string_view line) {
    // Messages to the operator.
    if (line.starts_with("M47") || line.starts_with("M45")) return;
    if (line[0] == 'T' && line.find('C') != std::string_view::npos) {
      define_tool(line);
      line = line.substr(0, line.find_first_not_of("0123456789", 1));
    }
    if (const std::size_t slot = line.find("G85"); slot != std::string_view::npos) return slotted(line, slot);
    const auto words = words_of(line);
    if (!words) not_understood(line);
    DrillMove move;
    double repeats = 0;
    for (const auto& [letter, digits] : *words) {
      if (std::string_view("XYIJ").find(letter) != std::string_view::npos)
        move.to.set(letter, length(digits, line));
      if (letter == 'A') move.radius = length(digits, line);
      if (letter == 'R') repeats = plain_number(digits).value_or(-1);
      if (letter == 'T') choose(digits, line);
      if (letter == 'G') general(digits, line);
      if (letter == 'M') machine(digits, line);
      if (std::string_view("XYIJARTGMFSN").find(letter) == std::string_view::npos) not_understood(line);
    }
    if (std::exchange(sets_zero_, false)) return set_zero(move.to.end({}, true));
    if (repeats != 0) return repeat(repeats, move.to.end({}, true), line);
    if (move.to.any()) operate(move, line);
  }

  void set_zero(Vec2 zero) const {
    if (zero != Vec2{}) fail("G93 moves the zero of what follows: export the drill file again with one zero");
  }

  void choose(std::string_view digits, std::string_view line) {
    // T0102 is tool 1 with the compensation 2.
    if (digits.size() >= 4) digits = digits.substr(0, digits.size() / 2);
    const auto number = code_number(digits);
    if (!number) not_understood(line);
    finish_route();
    tool_ = *number;
  }

  void general(std::string_view digits, std::string_view line) {
    switch (code_number(digits).value_or(-1)) {
      case 0:
        finish_route();
        return void(mode_ = Mode::kMove);
      case 1:
        turn_ = Turn::kStraight;
        return void(mode_ = Mode::kRoute);
      case 2:
        turn_ = Turn::kClockwise;
        return void(mode_ = Mode::kRoute);
      case 3:
        turn_ = Turn::kCounterClockwise;
        return void(mode_ = Mode::kRoute);
      case 5:
      case 81:
        finish_route();
        return void(mode_ = Mode::kDrill);
      case 40:
        return;
      case 93:
        return void(sets_zero_ = true);
      case 90:
        return void(incremental_ = false);
      case 91:
        return void(incremental_ = true);
      default:
        not_understood(line);
    }
  }

  void machine(std::string_view digits, std::string_view line) {
    switch (code_number(digits).value_or(-1)) {
      case 14:
      case 15:
        says_down_ = true;
        return void(is_down_ = true);
      case 16:
      case 17:
        finish_route();
        return void(is_down_ = false);
      case 30:
      case 0:
        return void(ended_ = true);
      case 71:
        return set_unit(1, false);
      case 72:
        return set_unit(kMmPerInch, false);
      case 9:
      case 95:
        return;
      default:
        not_understood(line);
    }
  }

  double length(std::string_view digits, std::string_view line) {
    if (!has_unit_) fail("the file does not say its unit (METRIC or INCH); give it as --unit");
    const auto value = coordinate(digits, format_);
    if (!value) not_understood(line);
    has_digits_ = has_digits_ || digits.find('.') == std::string_view::npos;
    return *value * mm_;
  }

  DrillTool& tool() {
    const auto found = tools_.find(tool_);
    if (found == tools_.end() || found->second.diameter == 0)
      fail("tool T" + std::to_string(tool_) + " has no diameter; add a line like T" + std::to_string(tool_) +
           "C0.8 to the header");
    return found->second;
  }

  void operate(const DrillMove& move, std::string_view line) {
    const Vec2 from = at_;
    at_ = move.to.end(from, incremental_);
    if (mode_ == Mode::kDrill) return drill(at_);
    if (mode_ == Mode::kMove) return void(has_moved_ = true);
    if (!is_down_) {
      if (says_down_) return void(++above_);
      if (!has_moved_)
        fail(
            "G01 without G00 and M15 before does not say whether holes or slots are meant; export the drill "
            "file again");
      ++taken_for_down_;
    }
    std::optional<Path> edge = gerber_edge(from, at_, center_offset(move, from), turn_, false);
    if (!edge) not_understood(line);
    route_.insert(route_.end(), edge->begin(), edge->end());
  }

  /// From the start to the centre of a routed arc: as written, or for an arc of at most half a turn with the radius
  /// A.
  Vec2 center_offset(const DrillMove& move, Vec2 from) const {
    if (!move.radius || at_ == from) return move.to.center_offset();
    const Vec2 half = (at_ - from) / 2;
    const double radius = *move.radius, apart = norm(half);
    if (radius < apart * kLeastRadius) fail("the radius is too small for an arc between its ends");
    const Vec2 aside = left_of(half) * (std::sqrt(std::max(0.0, radius * radius - apart * apart)) / apart);
    return turn_ == Turn::kCounterClockwise ? half + aside : half - aside;
  }

  void drill(Vec2 at) {
    tool().holes.push_back(at);
    if (++count_ > kMostHoles) fail("more than 1 million holes; give the board in parts");
  }

  void finish_route() {
    if (route_.empty()) return;
    tool().slots.push_back(std::move(route_));
    route_.clear();
  }

  void slotted(std::string_view line, std::size_t at) {
    const auto begin = words_of(line.substr(0, at)), end = words_of(line.substr(at + 3));
    if (!begin || !end) not_understood(line);
    const auto go = [&](const Words& words) {
      GerberMove move;
      for (const auto& [letter, digits] : words) {
        if (letter != 'X' && letter != 'Y') not_understood(line);
        move.set(letter, length(digits, line));
      }
      return at_ = move.end(at_, incremental_);
    };
    const Vec2 from = go(*begin), to = go(*end);
    if (from == to) return drill(from);
    tool().slots.push_back({Edge::line(from, to)});
  }

  void repeat(double times, Vec2 by, std::string_view line) {
    if (!(times >= 1 && times <= kMostRepeatedHoles && times == std::floor(times)) || mode_ != Mode::kDrill)
      not_understood(line);
    for (int i = 0; i < static_cast<int>(times); ++i) {
      at_ = at_ + by;
      drill(at_);
    }
  }

  enum class Mode { kDrill, kMove, kRoute };

  const std::string& file_;
  Diagnostics& diagnostics_;
  int line_ = 0;
  bool in_header_ = false, ended_ = false;
  CoordinateFormat format_;
  bool assumed_ = true, stated_digits_ = false, has_digits_ = false;
  double mm_ = 1;
  bool has_unit_ = false, unit_overruled_ = false, incremental_ = false;
  std::map<int, DrillTool> tools_;
  int tool_ = 0;
  Mode mode_ = Mode::kDrill;
  Turn turn_ = Turn::kStraight;  ///< turn of the routed path
  bool is_down_ = false, says_down_ = false, has_moved_ = false, sets_zero_ = false;
  std::size_t above_ = 0, taken_for_down_ = 0;  ///< moves at the feed above the board; as if M15 came before
  Vec2 at_;
  Path route_;
  std::size_t count_ = 0;
};

}  // namespace

Part read_excellon(std::string_view text, const std::string& file_name, const ReadOptions& options) {
  Part part;
  part.name = std::filesystem::path(file_name).stem().string();
  part.source_file = file_name;
  const auto tools = ExcellonReader(file_name, options, part.diagnostics).read(text);
  std::vector<DrawnGroup> groups = drilled_groups(tools, file_name, options, part.diagnostics);
  question_size(groups, file_name, options);
  add_drawn_features(part, std::move(groups), options);
  return part;
}

}  // namespace clearcut::read
