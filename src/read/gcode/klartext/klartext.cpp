#include "read/gcode/klartext/klartext.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/elementary.h"
#include "base/error.h"
#include "base/text.h"
#include "base/tolerances.h"
#include "base/units.h"
#include "read/gcode/control/compensation_words.h"
#include "read/gcode/control/held_state.h"
#include "read/gcode/klartext/approach.h"
#include "read/gcode/klartext/words.h"
#include "read/gcode/motion/arc.h"
#include "read/gcode/motion/corner.h"
#include "read/gcode/motion/cycle.h"
#include "read/gcode/program/program.h"
#include "read/gcode/words/lines.h"

namespace clearcut::read::gcode {

namespace {

constexpr double kMostTurns = 10000;
constexpr double kLargestRadius = 1e6;  // mm
constexpr std::size_t kMostCallsOfLabels = 19;
/// Lines of loops and subprograms that may be executed again.
constexpr std::size_t kMostRepeated = 500'000;
constexpr int kFirstOfCycles = 200;  // Q parameters below it are the programmer's own
constexpr int kSurface = 203;        // height of the surface in cycles for holes

class Reader {
 public:
  Reader(const CompensationValues& compensation, ToolpathBuilder& builder)
      : compensation_(compensation), builder_(builder) {}

  bool read(std::string_view text);
  /// As scan_stops(), up to the first block that computes or calls.
  StopScan scan(std::string_view text, int line);

 private:
  void take_lines(std::string_view text);
  bool next(Words& words);
  void execute(Words& words);
  StopBlock stop_at(const std::vector<std::string>& words);
  Hindrance hindrance_at(const std::vector<std::string>& words) const;
  HeldState held();
  void keep(const std::vector<std::string>& words);
  bool flow(const std::vector<std::string>& words);
  void call_label(const std::vector<std::string>& words);
  void tell_calls();
  void go_to_label(const std::string& label);
  void block(const Words& block);
  void path_block(const std::string& kind, const std::vector<std::string>& words);
  bool corner_follows() const;
  void round_corner(const std::vector<std::string>& words);
  void tool_call(const std::vector<std::string>& words);
  void define_tool(const std::vector<std::string>& words);
  void say_length_of_definition();
  void cycle(const std::vector<std::string>& words);
  void define_hole(const std::vector<std::string>& words, std::size_t first);
  double cycle_value(const std::string& text) const;
  void call_cycle(const std::vector<std::string>& words);
  void call_hole();
  void switch_coolant(int m);
  void m_word(int m);
  void refuse_if_it_changes_moves(int m) const;
  void set_drive();
  void set_length(double longer);
  void retract(double up);
  void check_blending();
  void machine_frame(const PathWords& words);

  /// Side and radius of a compensation.
  struct ToolOffset {
    CompensationSide side = CompensationSide::kLeft;
    double radius = 0;  ///< mm
  };
  /// APPR, which is made as soon as the first element of the contour is known.
  struct Approach {
    ContactWords contact;
    Vec2 place;  ///< of the contour's beginning
    double z = 0;
    double length = 0, angle = 0, radius = 0;  ///< mm, radians, mm: LEN, CCA, R
    std::optional<ToolOffset> offset;
    PathWords::Radius said = PathWords::Radius::kNone;
    bool rapid_before = false;  ///< of the block before it
    double feed_before = 0;
    int line = 0;
  };

  /// What the program itself says of a tool, mm.
  struct ToolDefinition {
    std::optional<double> length, radius;
    int line = 0;
  };

  void compensate(PathWords::Radius wanted);
  void refuse_other_radius(double radius) const;
  double radius_of_tool() const;
  ToolOffset offset_by(PathWords::Radius wanted) const;
  void begin_offset(const ToolOffset& offset);
  void end_offset();
  void take_feed(const PathWords& words);
  void approach(const std::vector<std::string>& block_words);
  void make_approach(Vec2 along);
  void approach_by_arc(const Approach& now, const Contact& contact);
  void go_to_contour(const Approach& now, Vec2 to);
  void depart(const std::vector<std::string>& block_words);
  void depart_by(const ContactWords& contact, const Contact& from, const PathWords& words);
  double size_in(const std::optional<std::string>& text, const std::string& name) const;
  double sweep_in(const ContactWords& contact) const;
  double radius_in(const PathWords& words, const ContactWords& contact, const Contact& at) const;
  void say_height_of_contact();
  void line(const PathWords& words, bool polar);
  void shift_datum(const std::vector<std::string>& words, std::size_t first);
  void turn_about_datum(const std::vector<std::string>& words);
  void transform(const std::vector<std::string>& words);
  PathWords placed(PathWords words);
  void circle_center(const PathWords& words);
  void circle(const PathWords& words);
  void circle_by_radius(const PathWords& words);
  void tangent_circle(const PathWords& words, bool polar);
  void polar_circle(const PathWords& words);
  void arc(const ArcShape& shape, double z_to);
  Vec2 plan_target(const PathWords& words);
  double height_target(const PathWords& words);
  Vec2 here();
  double at(std::size_t axis);
  Vec2 polar_target(const PathWords& words);
  RadiusRule radius_rule() const;
  std::string place() const { return builder_.place(line_); }

  double number(std::string_view text) const { return number_in(text, builder_, line_); }
  [[noreturn]] void refuse(const std::string& what) const { throw InputError(place(), what); }
  [[noreturn]] void refuse_open_approach() const {
    refuse(
        "APPR in line " + std::to_string(approach_->line) +
        " is not followed by the first element of its contour, which decides how it comes there; correct it");
  }
  [[noreturn]] void refuse_block(const std::string& first) const {
    refuse("block '" + first.substr(0, 20) +
           "' is not read; post the program with L, C, CR, CP, CT, RND, CHF, APPR and DEP blocks only");
  }

  const CompensationValues& compensation_;
  ToolpathBuilder& builder_;
  std::vector<std::string_view> lines_;
  bool has_corners_ = false;                   ///< RND or CHF stands somewhere
  std::map<std::string, std::size_t> labels_;  ///< where they stand in lines_
  std::size_t next_ = 0;                       ///< in lines_
  std::vector<std::size_t> returns_;           ///< where LBL 0 goes back to
  std::vector<std::string> calls_;             ///< "LBL 5 called in part.h:12", of each of those
  std::map<std::size_t, long long> repeats_;   ///< left of CALL LBL REP, by its place in lines_
  std::size_t executed_ = 0;
  QParameters parameters_;
  int line_ = 0;
  double unit_ = 1;
  double feed_ = 0;
  double tool_feed_ = 0;  ///< mm/min, F of TOOL CALL
  double speed_ = 0;
  int spindle_ = 5;
  std::map<int, ToolDefinition> definitions_;  ///< of TOOL DEF, by the number of the tool
  double wider_ = 0;                           ///< DR, mm: the tool counts as that much larger
  std::array<double, 3> datum_{};              ///< mm, by cycle 7 and TRANS DATUM
  double turned_ = 0;                          ///< degrees, by cycle 10
  bool chooses_datum_ = false;                 ///< cycle 247 was defined
  double longer_ = 0;                          ///< DL, mm: every height is that much off
  std::optional<Vec2> pole_;
  std::optional<HoleCycle> hole_;  ///< as last defined; CYCL CALL and M99 make it
  std::optional<Approach> approach_;
  std::optional<ToolOffset> offset_;  ///< while radius compensation is on
  std::optional<Vec2> heading_;       ///< in plan, at the end of the last move
  bool last_rapid_ = false;           ///< the last block that moves is one of FMAX
  bool ended_ = false;
  HeldWords held_words_;               ///< while stops are scanned
  std::string* definition_ = nullptr;  ///< of those, to which lines of parameters belong
};

/// "LBL 5", "LBL "NAME"": what stands behind LBL.
std::string label_in(const std::vector<std::string>& words, std::size_t first) {
  std::string label;
  for (std::size_t k = first; k < words.size() && words[k].rfind("REP", 0) != 0; ++k) label += words[k];
  return label;
}

/// Whether values of Q parameters may stand in the words of the block.
bool takes_values(const std::vector<std::string>& words) {
  constexpr std::string_view kFirst[] = {"L",   "LP",   "C",   "CC",   "CR",    "CP",  "CT",
                                         "CTP", "APPR", "DEP", "CYCL", "TRANS", "RND", "CHF"};
  return std::find(std::begin(kFirst), std::end(kFirst), words[0]) != std::end(kFirst) ||
         words[0][0] == 'Q' || (words[0] == "TOOL" && words.size() > 1 && words[1] == "CALL");
}

bool is_corner(const std::string& word) {
  return word == "RND" || word == "CHF";
}

/// Whether the line may be such a block: looked for once, since to look ahead of each block costs as much as to read it.
bool has_corner(std::string_view line) {
  constexpr std::string_view kNames[] = {"RND", "CHF"};
  return std::any_of(std::begin(kNames), std::end(kNames), [&](std::string_view name) {
    return std::search(line.begin(), line.end(), name.begin(), name.end(), [](char a, char b) {
             return std::toupper(static_cast<unsigned char>(a)) == b;
           }) != line.end();
  });
}

void Reader::take_lines(std::string_view text) {
  Lines lines(text);
  for (std::string_view line; lines.next(line);) {
    lines_.push_back(line);
    has_corners_ = has_corners_ || has_corner(line);
  }
}

bool Reader::read(std::string_view text) {
  take_lines(text);
  for (Words words; next(words);) execute(words);
  if (approach_) refuse_open_approach();
  return ended_;
}

/// The next block with words; false where the program ends.
bool Reader::next(Words& words) {
  while (!ended_ && next_ < lines_.size()) {
    const std::string_view line = lines_[next_++];
    line_ = static_cast<int>(next_);
    if (++executed_ > lines_.size() + kMostRepeated)
      refuse("over " + std::to_string(kMostRepeated) +
             " lines are repeated up to here; a loop that never ends, or too long a program");
    words = words_of(line);
    read_marker(words.comment, builder_);
    if (!words.words.empty()) return true;
  }
  return false;
}

void Reader::execute(Words& words) {
  if (flow(words.words)) return;
  if (takes_values(words.words)) parameters_.put_values(words.words, place());
  block(words);
}

/// Labels, their calls and FN functions; whether the block is one of them.
bool Reader::flow(const std::vector<std::string>& words) {
  if (words[0] == "LBL") {
    if (label_in(words, 1) == "0" && !returns_.empty()) {
      next_ = returns_.back();
      returns_.pop_back();
      calls_.pop_back();
      tell_calls();
    }
    return true;
  }
  if (words[0].rfind("FN", 0) == 0 && (words[0].size() == 2 || is_digit(words[0][2]))) {
    if (const FnBlock done = parameters_.execute(words, place()); done.jump) go_to_label(*done.jump);
    return true;
  }
  if (parameters_.assign(words, place())) return true;
  if (words[0] != "CALL" || words.size() < 3 || words[1] != "LBL") return false;
  call_label(words);
  return true;
}

/// With REP what stands between the label and here is run so many times more; else up to LBL 0.
void Reader::call_label(const std::vector<std::string>& words) {
  const std::size_t here = next_ - 1;
  const auto rep = std::find_if(words.begin() + 2, words.end(),
                                [](const std::string& word) { return word.rfind("REP", 0) == 0; });
  if (rep == words.end()) {
    if (returns_.size() >= kMostCallsOfLabels)
      refuse(
          "over 19 subprograms within each other, at which the control stops; one may call itself without "
          "end");
    returns_.push_back(next_);
    calls_.push_back("LBL " + label_in(words, 2) + " called in " + place());
    go_to_label(label_in(words, 2));
    return tell_calls();
  }
  std::string times = rep->substr(3);
  if (times.empty()) times = rep + 1 == words.end() ? "1" : *(rep + 1);
  times = times.substr(0, times.find('/'));  // "REP 2/2" of old controls: 2 of 2 are left
  const auto known = repeats_.emplace(here, static_cast<long long>(number(times))).first;
  if (known->second-- > 0) return go_to_label(label_in(words, 2));
  repeats_.erase(known);
}

/// The moves that follow come from subprograms: who called them, the last call first.
void Reader::tell_calls() {
  constexpr std::size_t kMostCallsTold = 3;
  std::string text;
  for (std::size_t k = calls_.size(); k-- > 0 && calls_.size() - k <= kMostCallsTold;)
    text += (text.empty() ? "" : ", ") + calls_[k];
  builder_.set_calls(text);
}

void Reader::go_to_label(const std::string& label) {
  if (labels_.empty()) {
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      const std::vector<std::string> words = words_of(lines_[k]).words;
      if (words.size() > 1 && words[0] == "LBL") labels_.emplace(label_in(words, 1), k);
    }
  }
  const auto found = labels_.find(label);
  if (found == labels_.end() || label == "0") refuse("there is no LBL " + label + "; correct the call");
  next_ = found->second + 1;
}

void Reader::block(const Words& found) {
  const auto& words = found.words;
  const std::string& first = words[0];
  const std::string second = words.size() > 1 ? words[1] : "";
  if (first[0] == '*') return;  // a heading of the program's structure
  constexpr std::string_view kElements[] = {"L", "LP", "C", "CC", "CR", "CP", "CT", "CTP"};
  const bool is_element = std::find(std::begin(kElements), std::end(kElements), first) != std::end(kElements);
  if (approach_ && !is_element) refuse_open_approach();
  if (first == "BEGIN" || first == "END") {
    ended_ = first == "END";
    unit_ = words.back() == "INCH" ? kMmPerInch : 1;
    builder_.say_units(unit_ != 1, line_);
  } else if (first == "TOOL" && second == "CALL") {
    tool_call(words);
  } else if (first == "TOOL" && second == "DEF") {
    define_tool(words);
  } else if (first == "CYCL" && second == "CALL") {
    call_cycle(words);
  } else if (first == "CYCL") {
    cycle(words);
  } else if (first == "TRANS") {
    transform(words);
  } else if (first.rfind("Q339", 0) == 0 && chooses_datum_) {
    // The number of the datum, behind cycle 247.
  } else if (first[0] == 'Q' && hole_) {
    define_hole(words, 0);
  } else if (first == "BLK" || first == "TOOL" || first == "STOP" || first == "FUNCTION") {
    if (first == "FUNCTION" && second != "MODE")
      refuse("FUNCTION " + second + " is not read; post without it");
  } else if (is_element) {
    path_block(first, words);
  } else if (first == "APPR") {
    approach(words);
  } else if (first == "DEP") {
    depart(words);
  } else if (is_corner(first)) {
    round_corner(words);
  } else if (first[0] == 'M' && first.size() > 1 && is_digit(first[1])) {
    for (const std::string& word : words) m_word(static_cast<int>(number(word.substr(1))));
  } else {
    refuse_block(first);
  }
}

/// Whether the next block rounds or chamfers the corner at the end of this one.
bool Reader::corner_follows() const {
  if (!has_corners_) return false;
  for (std::size_t k = next_; k < lines_.size(); ++k) {
    const std::vector<std::string> words = words_of(lines_[k]).words;
    if (!words.empty()) return is_corner(words[0]);
  }
  return false;
}

/// RND R5, CHF 5: between the element before it and the one behind it. F holds for the corner alone.
void Reader::round_corner(const std::vector<std::string>& words) {
  Corner corner;
  corner.kind = words[0] == "RND" ? CornerKind::kRounding : CornerKind::kChamfer;
  corner.line = line_;
  for (std::size_t k = 1; k < words.size(); ++k) {
    const std::string& word = words[k];
    if (word[0] == 'F' && word.size() > 1)
      corner.feed = MmPerMin::of(number(std::string_view(word).substr(1)) * feed_unit(unit_));
    else
      corner.size =
          number(std::string_view(word).substr(corner.kind == CornerKind::kRounding && word[0] == 'R')) *
          unit_;
  }
  builder_.round_corner(corner);
  heading_.reset();
}

/// Executes TOOL CALL. Without a tool it states a new spindle speed; with a tool the changer puts the tool in and leaves the
/// spindle stopped. The word DL makes the tool longer than its length in the table.
void Reader::tool_call(const std::vector<std::string>& words) {
  heading_.reset();
  double longer = 0;
  bool changed = false;
  wider_ = 0;
  for (std::size_t k = 2; k < words.size(); ++k) {
    const std::string& word = words[k];
    if (k == 2 && (is_digit(word[0]) || word[0] == '"')) {
      changed = true;
      m_word(5);
      builder_.change_tool(is_digit(word[0]) ? static_cast<int>(number(word)) : 0, false, line_);
      if (word[0] == '"') builder_.warn(line_, "tools called by name have no number here");
    } else if (word.size() == 1 && word != "Z" &&
               std::string_view("XYUVW").find(word) != std::string_view::npos) {
      refuse("the tool stands along " + word + "; it is read along Z alone");
    } else if (word[0] == 'S') {
      speed_ = std::abs(number(word.substr(1)));
      builder_.say_speed();
    } else if (word.rfind("DR", 0) == 0 && word.rfind("DR2", 0) != 0) {
      wider_ = number(word.substr(2)) * unit_;
    } else if (word.rfind("DL", 0) == 0) {
      longer = number(word.substr(2)) * unit_;
    } else if (word[0] == 'F') {
      feed_ = tool_feed_ = number(word.substr(1)) * feed_unit(unit_);
    }
  }
  if (changed || longer != 0) set_length(longer);
  if (changed) say_length_of_definition();
  set_drive();
}

/// TOOL DEF states length and radius of a tool in the program; with a number alone it only has the changer bring the tool
/// near.
void Reader::define_tool(const std::vector<std::string>& words) {
  if (words.size() < 4 || !is_digit(words[2][0])) return;
  ToolDefinition tool;
  tool.line = line_;
  for (std::size_t k = 3; k < words.size(); ++k) {
    const std::string& word = words[k];
    if (word.size() < 2 || (word[0] != 'L' && word[0] != 'R'))
      refuse("TOOL DEF with '" + word.substr(0, 20) +
             "' is not read; it states L and R of a tool, such as L+0 R+3");
    (word[0] == 'L' ? tool.length : tool.radius) = number(word.substr(1)) * unit_;
  }
  if (tool.radius && *tool.radius < 0) refuse("TOOL DEF with a radius below 0; correct it");
  definitions_[static_cast<int>(number(words[2]))] = tool;
}

/// Heights count from a length that the program states, so that the zero is to be touched off with it.
void Reader::say_length_of_definition() {
  const auto found = definitions_.find(builder_.drive.tool);
  if (found == definitions_.end() || !found->second.length) return;
  builder_.condition("tool-length-def", line_,
                     "TOOL DEF in line " + std::to_string(found->second.line) + " states the length of T" +
                         std::to_string(found->first) + ", " + trimmed(*found->second.length, 4) +
                         " mm: heights are right where the zero was touched off with this length");
}

void Reader::set_length(double longer) {
  longer_ = longer;
  builder_.length = {longer == 0 ? LengthKind::kOfTool : LengthKind::kStatedHeight, builder_.drive.tool,
                     longer};
  if (longer == 0) return;
  builder_.condition(
      "tool-length-dl", line_,
      "the tool is as long as its table says, so that DL" + trimmed(longer, 4) + " moves its tip by as much");
}

/// The parameters of a hole's cycle, "Q200=+2", from the word `first` on.
void Reader::define_hole(const std::vector<std::string>& words, std::size_t first) {
  for (std::size_t k = first; k < words.size(); ++k) {
    const std::size_t equals = words[k].find('=');
    if (words[k][0] != 'Q' || equals == std::string::npos) continue;
    const int parameter = static_cast<int>(number(words[k].substr(1, equals - 1)));
    if (parameter < kFirstOfCycles) refuse_block(words[k]);
    const bool parted = equals + 1 == words[k].size() && k + 1 < words.size();
    hole_->parameters[parameter] = cycle_value(parted ? words[k + 1] : words[k].substr(equals + 1));
  }
}

/// MAX and FMAX are the rapid, FAUTO is the feed in force.
double Reader::cycle_value(const std::string& text) const {
  if (text == "MAX" || text == "FMAX") return HUGE_VAL;
  return text == "FAUTO" ? feed_ / feed_unit(unit_) : number(text);
}

/// CYCL CALL where the tool stands, CYCL CALL POS at a place: there by its feed or the rapid, above the surface.
void Reader::call_cycle(const std::vector<std::string>& words) {
  const std::string kind = words.size() > 2 ? words[2] : "";
  if (kind == "PAT")
    refuse("CYCL CALL PAT calls the cycle at the places of a pattern, which is not read; post M99 at each");
  if (kind != "POS") {
    for (std::size_t k = 2; k < words.size(); ++k) m_word(static_cast<int>(number(words[k].substr(1))));
    return call_hole();
  }
  const PathWords place =
      placed(path_words({words.begin() + 2, words.end()}, {unit_, longer_}, builder_, line_));
  if (!hole_) refuse("a cycle is called before one is defined; correct it");
  const Target& to = place.absolute;
  if (!to[0] || !to[1] || !to[2])
    refuse("CYCL CALL POS asks for X, Y and Z, counted from the datum; give all three");
  if (place.machine_frame || place.retract || place.turn || place.compensation)
    refuse("CYCL CALL POS with M91, M92, M140, DR or compensation is not read; post the program without it");
  if (std::abs(*to[2] - datum_[2] - longer_) > kSamePlaceMm)
    refuse(
        "CYCL CALL POS moves the surface of its cycle by Z, which is read as Z+0 alone; state Q203 instead");
  const auto surface = hole_->parameters.find(kSurface);
  const double top = (surface == hole_->parameters.end() ? 0 : surface->second * unit_) + datum_[2];
  if (builder_.known(2, line_) < top)
    refuse("CYCL CALL POS begins below the surface of its cycle (Q203); go up before");
  const double feed = feed_;
  take_feed(place);
  for (const int m : place.m) m_word(m);
  if (!place.rapid) check_blending();
  if (place.rapid)
    builder_.rapid({to[0], to[1], std::nullopt}, line_);
  else
    builder_.feed({to[0], to[1], std::nullopt}, MmPerMin::of(feed_), line_);
  feed_ = feed;
  call_hole();
}

/// Rigid tapping turns the spindle by itself, as the sign of its pitch says, and leaves it stopped.
void Reader::call_hole() {
  heading_.reset();
  if (builder_.compensates())
    refuse("a cycle is called while radius compensation is on; end it by R0 before");
  if (!hole_) refuse("a cycle is called before one is defined; correct it");
  check_blending();
  const int turns = turning_of(*hole_);
  if (turns != 0) m_word(turns);
  HoleCycle hole = *hole_;
  if (const auto surface = hole.parameters.find(kSurface); surface != hole.parameters.end())
    surface->second += datum_[2] / unit_;
  if (needs_radius(hole)) hole.tool_radius = radius_of_tool();
  make_hole(hole, unit_, builder_, line_);
  if (turns != 0) m_word(5);
}

/// Cycle 7 and TRANS DATUM AXIS: X+10 is where the datum lies from now on, IX+10 shifts it further.
void Reader::shift_datum(const std::vector<std::string>& words, std::size_t first) {
  if (builder_.compensates())
    refuse("the datum is shifted while radius compensation is on; end it by R0 before");
  for (std::size_t k = first; k < words.size(); ++k) {
    const std::string& word = words[k];
    const bool adds = word[0] == 'I';
    const char axis = word.size() > (adds ? 2U : 1U) ? word[adds ? 1 : 0] : '\0';
    if (axis < 'X' || axis > 'Z') {
      if (words[2].find(".0") != std::string::npos) return;  // the cycle's name
      refuse("'" + word.substr(0, 20) +
             "' shifts the datum by a table or another axis, which is not read; post X, Y and Z");
    }
    if (turned_ != 0)
      refuse("the datum is shifted while cycle 10 turns the axes, which is not read; shift it before");
    double& place = datum_[static_cast<std::size_t>(axis - 'X')];
    const double value = number(std::string_view(word).substr(adds ? 2 : 1)) * unit_;
    place = value + (adds ? place : 0);
    pole_.reset();
  }
}

/// Cycle 10: the axes in plan are turned about the datum by so many degrees.
void Reader::turn_about_datum(const std::vector<std::string>& words) {
  if (builder_.compensates())
    refuse("the axes are turned while radius compensation is on; end it by R0 before");
  for (std::size_t k = 3; k < words.size(); ++k) {
    const bool adds = words[k].rfind("IROT", 0) == 0;
    if (!adds && words[k].rfind("ROT", 0) != 0) continue;
    const std::string_view angle = std::string_view(words[k]).substr(adds ? 4 : 3);
    if (angle.empty() || (!is_digit(angle.back()) && angle.back() != '.'))
      continue;  // ROTATION, the cycle's name
    turned_ = number(angle) + (adds ? turned_ : 0);
    pole_.reset();
  }
}

/// TRANS DATUM AXIS X+10 Y+5, TRANS DATUM RESET.
void Reader::transform(const std::vector<std::string>& words) {
  const std::string kind = words.size() > 2 && words[1] == "DATUM" ? words[2] : "";
  if (kind == "AXIS") return shift_datum(words, 3);
  if (kind != "RESET")
    refuse("TRANS is read as TRANS DATUM AXIS and TRANS DATUM RESET alone; post the program with these");
  if (builder_.compensates())
    refuse("the datum is shifted while radius compensation is on; end it by R0 before");
  if (turned_ != 0)
    refuse("the datum is shifted while cycle 10 turns the axes, which is not read; shift it before");
  datum_ = {};
  pole_.reset();
}

/// The words of a block, counted from the datum in axes that are turned, as places and angles of the work.
PathWords Reader::placed(PathWords words) {
  if (words.machine_frame) return words;
  if (words.absolute[2]) *words.absolute[2] += datum_[2];
  if (turned_ == 0) {
    for (const std::size_t axis : {0U, 1U})
      if (words.absolute[axis]) *words.absolute[axis] += datum_[axis];
    return words;
  }
  const double angle = Radians::of_degrees(turned_).radians();
  if (words.polar_angle) *words.polar_angle += turned_;
  if (!words.absolute[0] && !words.absolute[1] && !words.incremental[0] && !words.incremental[1])
    return words;
  const Vec2 zero{datum_[0], datum_[1]}, now = rotated(here() - zero, -angle);
  const auto along = [&](std::size_t axis, double is_at) {
    return words.incremental[axis] ? is_at + *words.incremental[axis] : words.absolute[axis].value_or(is_at);
  };
  const Vec2 to = zero + rotated(Vec2{along(0, now.x), along(1, now.y)}, angle);
  words.absolute[0] = to.x;
  words.absolute[1] = to.y;
  words.incremental[0] = words.incremental[1] = std::nullopt;
  return words;
}

/// Dwell, tolerance and the choice of a datum; cycle 247 takes the work's zero from the preset table.
void Reader::cycle(const std::vector<std::string>& words) {
  const std::string number_word = words.size() > 2 ? words[2] : "";
  const std::string cycle = number_word.substr(0, number_word.find('.'));
  const std::string& last = words.back();
  const int hole =
      !cycle.empty() && cycle.size() < 5 && is_digit(cycle[0]) ? static_cast<int>(number(cycle)) : 0;
  if (words.size() > 2 && words[1] == "DEF" && is_hole_cycle(hole)) {
    hole_ = HoleCycle{hole, {}};
    return define_hole(words, 3);
  }
  if (words.size() >= 3 && words[1] == "DEF" && cycle == "7") return shift_datum(words, 3);
  if (words.size() >= 3 && words[1] == "DEF" && cycle == "10") return turn_about_datum(words);
  if (words.size() < 3 || words[1] != "DEF" || (cycle != "9" && cycle != "32" && cycle != "247")) {
    refuse("cycle " + cycle.substr(0, 20) +
           std::string(cycle == "204" ? kBoresFromBelow : " is not read; post its moves one by one"));
  }
  if (number_word == "9.1") {
    const std::size_t digits =
        last.find_first_of("+-.0123456789", last.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ."));
    const double seconds = digits == std::string::npos ? 0 : number(last.substr(digits));
    add_dwell(builder_, line_, seconds, false);
  } else if (number_word == "32.0") {
    builder_.path_control = {};
  } else if (number_word == "32.1" && words.size() > 3 && words[3][0] == 'T') {
    // T0 states none: the control then keeps to what it was set up with.
    const double tolerance = number(words[3].substr(1)) * unit_;
    if (tolerance > 0) builder_.path_control = {PathMode::kTolerance, tolerance, std::nullopt};
  } else if (cycle == "247") {
    chooses_datum_ = true;
    builder_.condition("datum-247", line_, "the datum that cycle 247 chooses lies where the work's zero is");
  }
}

/// M7 is no word of the control itself, but what builders give mist.
void Reader::switch_coolant(int m) {
  Coolant& coolant = builder_.drive.coolant;
  if (m == 8 || m == 13 || m == 14) coolant = coolant_of(true, has_mist(coolant));
  if (m == 9) coolant = Coolant::kOff;
  if (m != 7) return;
  coolant = coolant_of(has_flood(coolant), true);
  builder_.condition("m7", line_, "what M7 does is the machine builder's choice; it switches the mist on");
}

/// M words that change where or how fast the blocks behind them move.
void Reader::refuse_if_it_changes_moves(int m) const {
  struct Row {
    int m;
    std::string_view does;
  };
  constexpr Row kRows[] = {{89, "calls the cycle after each move that follows"},
                           {97, "cuts small steps of a contour otherwise"},
                           {98, "cuts open corners otherwise"},
                           {103, "feeds down by a share of the feed"},
                           {109, "feeds faster or slower along arcs"},
                           {110, "feeds slower along arcs inside"},
                           {118, "lets the handwheel move beside the path"},
                           {128, "holds the tip while rotary axes turn"},
                           {130, "takes places in axes that are not tilted"},
                           {136, "makes feeds count for a turn of the spindle"}};
  for (const Row& row : kRows)
    if (row.m == m)
      refuse("M" + std::to_string(m) + ", which " + std::string(row.does) +
             ", is not read; post the program without it");
}

/// Words that move nothing: stops, spindle, tool, coolant.
void Reader::m_word(int m) {
  constexpr int kStill[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 13, 14, 30, 91, 92};
  if (m == 3 || m == 4 || m == 13 || m == 14) builder_.set_spindle(m % 10, line_);
  if (m == 3 || m == 4 || m == 13 || m == 14 || m == 19) builder_.say_spindle();
  if (m == 5 || m == 6) builder_.set_spindle(5, line_);
  if (m <= 6 && m >= 3) spindle_ = m == 6 ? 5 : m;
  if (m == 13 || m == 14) spindle_ = m - 10;
  switch_coolant(m);
  if (m == 0 || m == 1) builder_.add_event(ControlEventKind::kPause, line_);
  if (m == 2 || m == 30) ended_ = true;
  if (m == 99) return call_hole();
  refuse_if_it_changes_moves(m);
  if (std::find(std::begin(kStill), std::end(kStill), m) == std::end(kStill)) {
    builder_.condition("m" + std::to_string(m), line_,
                       "M" + std::to_string(m) + " is unknown here and moves nothing");
  }
  set_drive();
}

void Reader::set_drive() {
  builder_.drive.spindle_rpm = spindle_ == 5 ? 0 : speed_;
  builder_.speed = speed_;
}

void Reader::take_feed(const PathWords& words) {
  if (words.feed) feed_ = *words.feed;
  if (!words.feed_of_tool) return;
  if (!(tool_feed_ > 0)) refuse("FAUTO takes the feed of TOOL CALL, which states none; add F to it");
  feed_ = tool_feed_;
}

/// M words of a block act before its motion, except the stops and the call of a cycle.
void Reader::path_block(const std::string& kind, const std::vector<std::string>& block_words) {
  const PathWords words = placed(path_words(block_words, {unit_, longer_}, builder_, line_));
  if (approach_ && (words.machine_frame || words.retract)) refuse_open_approach();
  take_feed(words);
  for (const int m : words.m) {
    if (m != 2 && m != 30 && m != 99) m_word(m);
  }
  if (words.compensation) compensate(*words.compensation);
  if (words.retract) retract(*words.retract);
  const bool is_cut = !words.rapid && !words.machine_frame && !words.retract && kind != "CC";
  if (is_cut) check_blending();
  if (is_cut && corner_follows()) builder_.expect_corner(line_);
  if (words.machine_frame) {
    machine_frame(words);
  } else if (words.retract && !words.absolute[0] && !words.absolute[1] && !words.absolute[2]) {
    // M140 alone moves up, and nothing else.
  } else if (kind == "L" || kind == "LP") {
    line(words, kind == "LP");
  } else if (kind == "CC") {
    circle_center(words);
  } else if (kind == "C") {
    circle(words);
  } else if (kind == "CR") {
    circle_by_radius(words);
  } else if (kind == "CT" || kind == "CTP") {
    tangent_circle(words, kind == "CTP");
  } else {
    polar_circle(words);
  }
  if (kind != "CC") last_rapid_ = words.rapid;
  if (std::count(words.m.begin(), words.m.end(), 99) > 0) call_hole();
  ended_ = std::any_of(words.m.begin(), words.m.end(), [](int m) { return m == 2 || m == 30; });
}

/// RL and RR hold until R0. The radius is that of the table, which DR of the call makes larger.
void Reader::compensate(PathWords::Radius wanted) {
  if (approach_) {
    if (wanted != approach_->said)
      refuse("the side of radius compensation is another than that of APPR before it; correct one of them");
    return;
  }
  if (wanted == PathWords::Radius::kNone) return end_offset();
  const ToolOffset offset = offset_by(wanted);
  if (!builder_.compensates()) return begin_offset(offset);
  if (!builder_.compensates_as(offset.side, offset.radius))
    refuse("the side of radius compensation changes while it is on; end it by R0 before");
}

/// The control compensates by what TOOL DEF states, which a radius of another tool contradicts. Both are stated in decimals,
/// which inches round.
void Reader::refuse_other_radius(double radius) const {
  const auto found = definitions_.find(builder_.drive.tool);
  if (found == definitions_.end() || !found->second.radius) return;
  if (std::abs(*found->second.radius - radius) <= kSamePlaceMm) return;
  refuse("TOOL DEF in line " + std::to_string(found->second.line) + " states a radius of " +
         trimmed(*found->second.radius, 4) + " mm for T" + std::to_string(found->first) +
         ", and radius compensation is checked with " + trimmed(radius, 4) + " mm; correct one of them");
}

/// mm; of the table, larger by DR.
double Reader::radius_of_tool() const {
  const int tool = builder_.drive.tool;
  const double of_table = compensation_of(compensation_, builder_, tool, tool, "the tool table", line_);
  refuse_other_radius(of_table);
  return of_table + wider_;
}

Reader::ToolOffset Reader::offset_by(PathWords::Radius wanted) const {
  const double radius = radius_of_tool();
  const bool is_left = (wanted == PathWords::Radius::kLeft) != (radius < 0);
  return {is_left ? CompensationSide::kLeft : CompensationSide::kRight, std::abs(radius)};
}

void Reader::begin_offset(const ToolOffset& offset) {
  builder_.begin_compensation(rules_of(dialect_of(Language::kKlartext)).compensation, offset.side,
                              offset.radius);
  offset_ = offset;
}

void Reader::end_offset() {
  builder_.end_compensation();
  offset_.reset();
}

/// M91 counts from the machine's own zero, M92 from a place of its builder: neither is known here.
void Reader::machine_frame(const PathWords& words) {
  heading_.reset();
  if (builder_.compensates()) refuse("M91 or M92 while radius compensation is on; end it by R0 before");
  const bool plan = words.absolute[0] || words.absolute[1];
  builder_.condition(
      "m91", line_,
      "moves to a place of the machine (M91, M92) that the program does not state; taken as straight up "
      "to Z " +
          trimmed(builder_.home_z(), 3) + " mm");
  if (words.absolute[2]) builder_.lift_home(line_);
  if (plan) builder_.leave_plan("m91");
}

/// M140: up along the tool by so much, or to the end of the travel.
void Reader::retract(double up) {
  if (std::isinf(up)) return builder_.lift_home(line_);
  Target target;
  target[2] = builder_.known(2, line_) + up;
  builder_.rapid(target, line_);
}

void Reader::check_blending() {
  if (builder_.path_control.mode != PathMode::kUnstated) return;
  builder_.condition(
      "blending", line_,
      "cycle 32 states no tolerance; the control keeps to the path, whatever bound it was set up with");
}

/// The place up to which blocks were read: behind APPR the beginning of the contour.
double Reader::at(std::size_t axis) {
  if (!approach_) return builder_.known(axis, line_);
  return axis == 2 ? approach_->z : axis == 1 ? approach_->place.y : approach_->place.x;
}

Vec2 Reader::here() {
  return {at(0), at(1)};
}

Vec2 Reader::polar_target(const PathWords& words) {
  if (!pole_) refuse("polar coordinates without a pole; give CC before it");
  const Vec2 arm = here() - *pole_;
  const double angle = words.polar_angle
                           ? Radians::of_degrees(*words.polar_angle).radians()
                           : angle_of(arm) + Radians::of_degrees(words.polar_step.value_or(0)).radians();
  return *pole_ + direction_of(angle) * words.polar_radius.value_or(norm(arm));
}

void Reader::line(const PathWords& words, bool polar) {
  Target to = words.absolute;
  const auto none = [](const Target& places) {
    return std::none_of(places.begin(), places.end(), [](const auto& place) { return place.has_value(); });
  };
  if (!polar && !approach_ && none(words.absolute) && none(words.incremental)) return;  // F or M alone
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (words.incremental[axis]) to[axis] = at(axis) + *words.incremental[axis];
  }
  if (polar) {
    const Vec2 end = polar_target(words);
    to[0] = end.x;
    to[1] = end.y;
  }
  if (approach_) {
    const Vec2 way = Vec2{to[0].value_or(at(0)), to[1].value_or(at(1))} - here();
    if (!(norm(way) > kSamePlaceMm)) refuse_open_approach();
    make_approach(way / norm(way));
  }
  const Target before = builder_.position();
  if (before[0] && before[1]) {
    const Vec2 way{to[0].value_or(*before[0]) - *before[0], to[1].value_or(*before[1]) - *before[1]};
    if (norm(way) > kSamePlaceMm) heading_ = way / norm(way);
  }
  if (words.rapid) {
    builder_.rapid(to, line_);
  } else {
    builder_.feed(to, MmPerMin::of(feed_), line_);
  }
}

Vec2 Reader::plan_target(const PathWords& words) {
  const Vec2 from = here();
  return {words.incremental[0] ? from.x + *words.incremental[0] : words.absolute[0].value_or(from.x),
          words.incremental[1] ? from.y + *words.incremental[1] : words.absolute[1].value_or(from.y)};
}

double Reader::height_target(const PathWords& words) {
  const double from = at(2);
  return words.incremental[2] ? from + *words.incremental[2] : words.absolute[2].value_or(from);
}

/// Without coordinates the pole is where the tool is.
void Reader::circle_center(const PathWords& words) {
  if (words.absolute[0] && words.absolute[1]) {
    pole_ = Vec2{*words.absolute[0], *words.absolute[1]};
    return;
  }
  pole_ = plan_target(words);
}

RadiusRule Reader::radius_rule() const {
  return unit_ == 1 ? RadiusRule{} : RadiusRule{0.0005 * kMmPerInch, 0.05 * kMmPerInch};
}

void Reader::circle(const PathWords& words) {
  if (!pole_ || !words.turn) refuse("arc without its centre (CC) or direction (DR); give both");
  const Vec2 from = here(), to = plan_target(words);
  arc(arc_about(from, to, *pole_, *words.turn, 1, radius_rule(), place()), height_target(words));
}

void Reader::circle_by_radius(const PathWords& words) {
  if (!words.radius || !words.turn) refuse("CR without R or DR; give both");
  const Vec2 from = here(), to = plan_target(words);
  arc(arc_of_radius(from, to, *words.radius, *words.turn, radius_rule(), place()), height_target(words));
}

/// Goes on as the element before it ends.
void Reader::tangent_circle(const PathWords& words, bool polar) {
  if (approach_ || !heading_) refuse("CT without an element before it, to which it is tangent; correct it");
  const Vec2 from = here(), to = polar ? polar_target(words) : plan_target(words), way = to - from;
  const double across = cross(*heading_, way);
  if (!(std::abs(across) > kSamePlaceMm))
    refuse("CT whose end lies on the line of the element before it is no arc; correct it");
  const double radius = dot(way, way) / (2 * across);  // > 0: to the left
  if (!(std::abs(radius) <= kLargestRadius)) refuse("arc with a radius that no machine runs; correct it");
  const Vec2 center = from + left_of(*heading_) * radius;
  const double sweep = 2 * std::abs(base::atan2(across, dot(*heading_, way)));
  arc({from, to, center, radius > 0 ? Turn::kCounterClockwise : Turn::kClockwise, sweep},
      height_target(words));
}

void Reader::polar_circle(const PathWords& words) {
  if (!pole_ || !words.turn || !(words.polar_angle || words.polar_step)) {
    refuse("CP without its pole (CC), angle or direction (DR); give all three");
  }
  const Vec2 from = here(), arm = from - *pole_;
  const double side = *words.turn == Turn::kCounterClockwise ? 1 : -1;
  double sweep = 0;
  if (words.polar_step) {
    sweep = side * Radians::of_degrees(*words.polar_step).radians();
    if (!(sweep > 0) || sweep > kMostTurns)
      refuse("CP whose angle IPA and direction DR disagree; correct it");
  } else {
    sweep =
        std::remainder(side * (Radians::of_degrees(*words.polar_angle).radians() - angle_of(arm)), 2 * kPi);
    if (sweep <= 0) sweep += 2 * kPi;
  }
  if (norm(arm) <= 1e-7) refuse("arc of radius zero; correct CC");
  const Vec2 to = *pole_ + rotated(arm, side * sweep);
  arc({from, to, *pole_, *words.turn, sweep}, height_target(words));
}

void Reader::arc(const ArcShape& shape, double z_to) {
  const auto tangent_at = [&](Vec2 place) {
    const Vec2 arm = (place - shape.center) / distance(place, shape.center);
    return left_of(arm) * (shape.turn == Turn::kCounterClockwise ? 1 : -1);
  };
  if (approach_) make_approach(tangent_at(shape.from));
  heading_ = tangent_at(shape.to);
  if (builder_.compensation_begins())
    refuse("radius compensation begins with an arc; enter along a straight line");
  builder_.arc(shape, z_to, MmPerMin::of(feed_), line_);
}

double Reader::size_in(const std::optional<std::string>& text, const std::string& name) const {
  const double size = text ? number(*text) * unit_ : 0;
  if (!(size > 0)) refuse("APPR or DEP without " + name + " above 0; correct it");
  return size;
}

double Reader::sweep_in(const ContactWords& contact) const {
  const double degrees = contact.angle ? number(*contact.angle) : 0;
  if (!(degrees > 0) || degrees > 360)
    refuse("APPR or DEP whose CCA is not from 0 to 360 degrees; correct it");
  return Radians::of_degrees(degrees).radians();
}

/// R of CT and LCT: on the tool's side its centre needs room within the arc.
double Reader::radius_in(const PathWords& words, const ContactWords& contact, const Contact& at) const {
  if (!words.radius || *words.radius == 0 || (*words.radius < 0 && contact.kind == ContactKind::kLineAndArc))
    refuse("APPR or DEP by an arc without its R above 0; correct it");
  if (*words.radius > 0 && *words.radius <= at.tool_radius)
    refuse("the arc's radius, " + trimmed(*words.radius, 4) + " mm, is not larger than that of the tool, " +
           trimmed(at.tool_radius, 4) + " mm; the control stops");
  return *words.radius;
}

void Reader::say_height_of_contact() {
  builder_.condition(
      "approach-height", line_,
      "APPR and DEP with a Z word move in the plane first and then along the tool, as controls "
      "up to the TNC 640 do");
}

/// Nothing moves yet: how the contour is reached follows from its first element.
void Reader::approach(const std::vector<std::string>& block_words) {
  const auto contact = contact_words(block_words);
  if (!contact) refuse_block("APPR " + (block_words.size() > 1 ? block_words[1] : ""));
  if (builder_.compensates()) refuse("APPR while radius compensation is on; end it by R0 or DEP before");
  const PathWords words = placed(path_words(contact->words, {unit_, longer_}, builder_, line_));
  if (words.machine_frame || words.retract || words.turn || words.rapid)
    refuse("APPR with M91, M92, M140, DR or FMAX is not read; post the program without it");
  Approach next;
  next.contact = *contact;
  next.rapid_before = last_rapid_;
  next.feed_before = feed_;
  next.line = line_;
  take_feed(words);
  for (const int m : words.m) {
    if (m == 2 || m == 30 || m == 99) refuse("M2, M30 and M99 cannot stand in an APPR block; correct it");
    m_word(m);
  }
  next.place = contact->polar ? polar_target(words) : plan_target(words);
  next.z = height_target(words);
  next.said = words.compensation.value_or(PathWords::Radius::kNone);
  if (next.said != PathWords::Radius::kNone) next.offset = offset_by(next.said);
  const bool is_line = contact->kind == ContactKind::kTangent;
  if (!next.offset && !is_line) refuse("APPR LN, CT and LCT are read with RL or RR alone; add one of them");
  if (is_line || contact->kind == ContactKind::kNormal) next.length = size_in(contact->length, "LEN");
  if (contact->kind == ContactKind::kArc) next.angle = sweep_in(*contact);
  if (contact->kind == ContactKind::kArc || contact->kind == ContactKind::kLineAndArc)
    next.radius = radius_in(words, *contact, {{}, {}, 0, next.offset->radius});
  approach_ = next;
}

/// `along`: of length 1, the direction in which the contour begins.
void Reader::make_approach(Vec2 along) {
  const Approach now = *std::exchange(approach_, std::nullopt);
  const int line = std::exchange(line_, now.line);
  check_blending();
  Contact contact{now.place, along, 0, 0};
  if (now.offset) {
    contact.side = static_cast<double>(now.offset->side);
    contact.tool_radius = now.offset->radius;
  }
  const Target first{now.place.x, now.place.y, std::nullopt};
  if (now.contact.kind == ContactKind::kTangent) {
    if (now.offset) begin_offset(*now.offset);
    go_to_contour(now, now.place - along * now.length);
    builder_.feed(first, MmPerMin::of(feed_), line_);
  } else if (now.contact.kind == ContactKind::kNormal) {
    go_to_contour(now, place_across(contact, now.length));
    begin_offset(*now.offset);
    builder_.feed(first, MmPerMin::of(feed_), line_);
  } else {
    approach_by_arc(now, contact);
  }
  line_ = line;
}

void Reader::approach_by_arc(const Approach& now, const Contact& contact) {
  std::optional<ArcShape> shape;
  if (now.contact.kind == ContactKind::kArc)
    shape = arc_to(contact, now.radius, now.angle);
  else
    shape = arc_to_from(contact, now.radius, here());
  if (!shape) refuse("APPR LCT begins within the circle of its arc; begin farther outside");
  begin_offset(*now.offset);
  go_to_contour(now, shape->from);
  if (distance(shape->from, shape->to) > kSamePlaceMm || shape->sweep > kPi) arc(*shape, now.z);
}

/// To the point from which the last line or arc leads to the contour; by the feed, or the rapid, of the block before, in LCT by its own feed.
void Reader::go_to_contour(const Approach& now, Vec2 to) {
  const bool by_own_feed = now.contact.kind == ContactKind::kLineAndArc;
  const auto move = [&](const Target& target) {
    if (now.rapid_before && !by_own_feed) return builder_.rapid(target, line_);
    builder_.feed(target, MmPerMin::of(by_own_feed ? feed_ : now.feed_before), line_);
  };
  move({to.x, to.y, std::nullopt});
  if (now.z == builder_.known(2, line_)) return;
  say_height_of_contact();
  move({std::nullopt, std::nullopt, now.z});
}

/// Leaves the contour behind its last element and ends radius compensation.
void Reader::depart(const std::vector<std::string>& block_words) {
  const auto contact = contact_words(block_words);
  if (!contact) refuse_block("DEP " + (block_words.size() > 1 ? block_words[1] : ""));
  if (!heading_) refuse("DEP without an element of a contour before it; correct it");
  const PathWords words = placed(path_words(contact->words, {unit_, longer_}, builder_, line_));
  const bool is_arc = contact->kind == ContactKind::kArc || contact->kind == ContactKind::kLineAndArc;
  if (words.machine_frame || words.retract || words.turn || (words.rapid && is_arc) ||
      words.compensation.value_or(PathWords::Radius::kNone) != PathWords::Radius::kNone)
    refuse("DEP with M91, M92, M140, DR, RL, RR or an arc at FMAX is not read; post the program without it");
  take_feed(words);
  for (const int m : words.m) {
    if (m == 99) refuse("M99 cannot stand in a DEP block; correct it");
    if (m != 2 && m != 30) m_word(m);
  }
  if (!words.rapid) check_blending();
  if (!offset_ && contact->kind != ContactKind::kTangent)
    refuse("DEP LN, CT and LCT are read while RL or RR is on alone; add one of them");
  Contact from{here(), *heading_, 0, 0};
  if (offset_) {
    from.side = static_cast<double>(offset_->side);
    from.tool_radius = offset_->radius;
  }
  depart_by(*contact, from, words);
  const double up = height_target(words);
  if (up != at(2)) {
    say_height_of_contact();
    builder_.feed({std::nullopt, std::nullopt, up}, MmPerMin::of(feed_), line_);
  }
  heading_.reset();
  last_rapid_ = words.rapid;
  ended_ = std::any_of(words.m.begin(), words.m.end(), [](int m) { return m == 2 || m == 30; });
}

void Reader::depart_by(const ContactWords& contact, const Contact& from, const PathWords& words) {
  const auto straight = [&](Vec2 to) {
    if (words.rapid) return builder_.rapid({to.x, to.y, std::nullopt}, line_);
    builder_.feed({to.x, to.y, std::nullopt}, MmPerMin::of(feed_), line_);
  };
  /// Where the centre stands on the contour's side counts as the place from then on.
  const auto end_beside = [&](Vec2 place, Vec2 along) {
    end_offset();
    const Vec2 center = place + left_of(along) * (from.side * from.tool_radius);
    builder_.place_at(0, center.x);
    builder_.place_at(1, center.y);
  };
  if (contact.kind == ContactKind::kTangent) {
    const Vec2 to = from.place + from.along * size_in(contact.length, "LEN");
    straight(to);
    return end_beside(to, from.along);
  }
  if (contact.kind == ContactKind::kNormal) {
    end_offset();
    return straight(place_across(from, size_in(contact.length, "LEN")));
  }
  const double radius = radius_in(words, contact, from);
  if (contact.kind == ContactKind::kArc) {
    const ArcShape shape = arc_from(from, radius, sweep_in(contact));
    arc(shape, at(2));
    return end_beside(shape.to, *heading_);
  }
  const Vec2 outside = contact.polar ? polar_target(words) : plan_target(words);
  const auto shape = arc_from_to(from, radius, outside);
  if (!shape) refuse("DEP LCT ends within the circle of its arc; end farther outside");
  if (distance(shape->from, shape->to) > kSamePlaceMm || shape->sweep > kPi) arc(*shape, at(2));
  end_offset();
  straight(outside);
}

/// Whether the block jumps, calls, or gives a Q parameter of the programmer's own a value.
bool computes_or_calls(const std::vector<std::string>& words) {
  if (words[0] == "CALL") return true;
  if (words[0].rfind("FN", 0) == 0 && (words[0].size() == 2 || is_digit(words[0][2]))) return true;
  if (words[0][0] != 'Q' || words[0].size() < 2 || !is_digit(words[0][1])) return false;
  return std::atoi(words[0].c_str() + 1) < kFirstOfCycles;
}

/// Whether a word of the block states a place, or calls a cycle.
bool goes_somewhere(const std::vector<std::string>& words) {
  if (words[0] == "CYCL") return words.size() > 1 && words[1] == "CALL";
  if (words[0] == "CC" || words[0] == "TRANS" || words[0] == "TOOL" || words[0] == "BLK") return false;
  return std::any_of(words.begin() + 1, words.end(),
                     [](const std::string& word) {
                       constexpr std::string_view kPlaces[] = {"X",  "Y",  "Z",  "IX",  "IY",
                                                               "IZ", "PR", "PA", "IPA", "LEN"};
                       return word == "M99" || word == "M140" ||
                              std::any_of(std::begin(kPlaces), std::end(kPlaces),
                                          [&](std::string_view place) { return word.rfind(place, 0) == 0; });
                     }) ||
         words[0] == "M99";
}

/// The number of a tool or its name stands behind TOOL CALL.
bool puts_tool_in(const std::vector<std::string>& words) {
  return words.size() > 2 && words[0] == "TOOL" && words[1] == "CALL" &&
         (is_digit(words[2][0]) || words[2][0] == '"');
}

StopScan Reader::scan(std::string_view text, int line) {
  take_lines(text);
  StopScan scan;
  for (Words words; next(words);) {
    const StopBlock stop = stop_at(words.words);
    if (computes_or_calls(words.words)) scan.macro_line = line_;
    if (scan.macro_line > 0 && (line_ < line || scan.held)) {
      scan.blocks.push_back(stop);
      break;
    }
    add_stop(
        stop, line, [this] { return held(); }, scan);
    if (scan.macro_line > 0) break;
    const Coolant before = builder_.drive.coolant;
    execute(words);
    keep(words.words);
    keep_coolant(before, builder_.drive.coolant, held_words_);
  }
  return scan;
}

StopBlock Reader::stop_at(const std::vector<std::string>& words) {
  StopBlock stop;
  stop.line = line_;
  stop.moves = goes_somewhere(words);
  stop.changes_tool = puts_tool_in(words);
  const Target& at = builder_.position();
  stop.is_placed = at[0] && at[1] && at[2];
  stop.z = at[2].value_or(0);
  stop.tool = builder_.drive.tool;
  stop.hindrance = hindrance_at(words);
  return stop;
}

Hindrance Reader::hindrance_at(const std::vector<std::string>& words) const {
  const std::string& first = words[0];
  const bool goes_on = first == "CT" || first == "CTP" || first == "DEP" || is_corner(first);
  if (builder_.compensates()) return Hindrance::kCompensation;
  if (approach_ || goes_on || builder_.waits_at_corner()) return Hindrance::kCorner;
  const bool is_shifted = std::any_of(datum_.begin(), datum_.end(), [](double mm) { return mm != 0; });
  if (turned_ != 0 || is_shifted) return Hindrance::kMap;
  const bool is_second_line = first == "CYCL" && words.size() > 2 && words[1] == "DEF" &&
                              words[2].find('.') != std::string::npos &&
                              words[2].find(".0") == std::string::npos;
  if (first[0] == 'Q' || is_second_line) return Hindrance::kDefinition;
  return Hindrance::kNone;
}

HeldState Reader::held() {
  HeldState state;
  state.modes.unit = unit_;
  state.modes.feed = feed_;
  state.modes.speed = speed_;
  state.modes.spindle = spindle_;
  state.modes.coolant = builder_.drive.coolant;
  state.modes.length = builder_.length;
  state.modes.path = builder_.path_control;
  state.tool = state.next_tool = builder_.drive.tool;
  state.tool_said = state.changer = !held_words_.tool_calls.empty();
  state.position = builder_.position();
  state.shift[2] = longer_;
  state.at_home = builder_.at_home_height();
  state.spindle_wait = wait_behind_spindle(builder_.events());
  state.words = held_words_;
  if (pole_) state.pole = *pole_;
  return state;
}

/// The text of a block without its number, as a line.
std::string unnumbered(std::string_view line) {
  while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
  std::size_t digits = 0;
  while (digits < line.size() && is_digit(line[digits])) ++digits;
  if (digits < line.size() && is_blank(line[digits])) line.remove_prefix(digits);
  while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
  while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
  return std::string(line) + "\n";
}

/// Keeps the text of an executed block whose effect lasts, so that a resumed program can repeat it.
void Reader::keep(const std::vector<std::string>& words) {
  HeldWords& kept = held_words_;
  const std::string text = unnumbered(lines_[static_cast<std::size_t>(line_) - 1]);
  const std::string second = words.size() > 1 ? words[1] : "";
  if (words[0] == "TOOL" && second == "CALL") {
    if (puts_tool_in(words)) kept.tool_calls.clear();
    kept.tool_calls += text;
  } else if (words[0] == "TOOL" && second == "DEF" && words.size() > 3) {
    kept.tool_definitions += text;
  } else if (words[0] == "CYCL" && second == "DEF" && words.size() > 2) {
    const std::string number = words[2].substr(0, words[2].find('.'));
    const bool begins = words[2].find('.') == std::string::npos || words[2].find(".0") != std::string::npos;
    std::string* const of = number == "32" ? &kept.path : number == "247" ? &kept.offset : &kept.cycle;
    definition_ = number == "7" || number == "9" || number == "10" ? nullptr : of;
    if (definition_) *definition_ = begins ? text : *definition_ + text;
  } else if (words[0][0] == 'Q') {
    if (definition_) *definition_ += text;
  } else if (words[0] == "L" && std::find(words.begin(), words.end(), "M91") != words.end()) {
    const bool is_up = std::none_of(words.begin(), words.end(), [](const std::string& word) {
      return word[0] == 'X' || word[0] == 'Y' || word.rfind("IX", 0) == 0 || word.rfind("IY", 0) == 0;
    });
    if (is_up) kept.home = text;
  }
}

}  // namespace

StopScan scan_klartext_stops(std::string_view text, const std::string& file_name,
                             const ReadControllerOptions& options, int line) {
  Diagnostics diagnostics;
  std::vector<Condition> conditions;
  ToolpathBuilder builder({file_name, options.home_z, options.safe_z}, diagnostics, conditions);
  return Reader(options.compensation, builder).scan(text, line);
}

bool read_klartext(std::string_view text, const CompensationValues& compensation, ToolpathBuilder& builder) {
  return Reader(compensation, builder).read(text);
}

}  // namespace clearcut::read::gcode
