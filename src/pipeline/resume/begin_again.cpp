// Order of the lines: modes, work offset, path control; up; tool; spindle; over the place; length; coolant; down; modes of the motion.
#include "pipeline/resume/begin_again.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "base/tolerances.h"
#include "read/gcode/sinumerik/words.h"

namespace clearcut::pipeline {
namespace {

using read::gcode::FeedMode;
using read::gcode::HeldState;
using read::gcode::HeldWords;

/// With a decimal point: "X10.", as every control takes it.
std::string place_word(char letter, double value, int digits = 6) {
  std::string text = trimmed(value, digits);
  if (text.find('.') == std::string::npos) text += '.';
  return letter + text;
}

class BeginWriter {
 public:
  BeginWriter(const HeldState& held, const read::gcode::DialectRules& rules, const WayIn& way)
      : held_(held), words_(held.words), rules_(rules), way_(way) {}

  std::string text(int line) {
    add_comment(fmt::format("RESUMED BEFORE LINE {}", line));
    number_tools();
    write_modes();
    if (way_.is_needed) {
      write_drive();
      if (is_placed())
        write_way();
      else
        write_unplaced();
    } else {
      write_until_change();
    }
    write_modes_of_motion();
    return out_;
  }

 private:
  void add(const std::string& line) {
    if (!line.empty()) out_ += line + "\n";
  }
  void add_words(std::initializer_list<std::string> words) {
    std::string line;
    for (const std::string& word : words)
      if (!word.empty()) line += (line.empty() ? "" : " ") + word;
    add(line);
  }
  bool is_sinumerik() const { return rules_.language == read::gcode::Language::kSinumerik; }
  void add_comment(const std::string& said) {
    add(way_.semicolons || is_sinumerik() ? "; " + said : "(" + said + ")");
  }
  bool is_placed() const { return held_.position[0] && held_.position[1] && held_.position[2]; }
  std::string at(std::size_t axis, double place) const {
    return place_word("XYZ"[axis], (place - held_.shift[axis]) / held_.modes.unit);
  }
  std::string at(std::size_t axis) const { return at(axis, *held_.position[axis]); }
  std::string feed_word(double feed) const {
    return "F" + trimmed(feed / (words_.feeds_in_mm ? 1 : held_.modes.unit), 6);
  }

  /// States the number of each named tool: names are otherwise numbered in the order of their calls, and the resumed program may not call
  /// all of them.
  void number_tools() {
    if (words_.tool_numbers.size() < 2) return;
    for (const auto& [name, number] : words_.tool_numbers)
      add_comment(read::gcode::tool_comment(name, number));
  }

  void write_modes() {
    add_words({words_.plane, words_.units, words_.compensation, words_.cycle_end, "G90", words_.centers,
               held_.modes.feed_mode == FeedMode::kPerMinute ? words_.feed_mode
               : words_.feed_mode.empty()                    ? ""
                                                             : "G94",
               words_.level});
    for (const std::string& zero : words_.zeros) add(zero);
    add(words_.offset);
    if (words_.local_shift) add_words({"G52", shift_word(0), shift_word(1), shift_word(2)});
    add(words_.path);
    add(words_.smoothing);
    for (const std::string& way : words_.ways) add(way);
  }
  std::string shift_word(std::size_t axis) const {
    return place_word("XYZ"[axis], held_.local[axis] / held_.modes.unit);
  }

  void write_drive() {
    if (!words_.home.empty()) {
      add(words_.home);
      if (words_.home.starts_with("G91")) add("G90");
    }
    if (held_.tool_said) {
      add_words({tool_word(words_.tool_name, held_.tool), held_.changer ? "M6" : ""});
      call_next_tool();
    }
    if (way_.tools_by_comments && held_.tool > 0) add_comment(fmt::format("TOOL CHANGE T{}", held_.tool));
    const std::string speed = held_.modes.speed > 0 ? "S" + trimmed(held_.modes.speed, 6) : "";
    const bool turns = held_.modes.spindle != 5;
    add_words({speed, turns ? fmt::format("M{}", held_.modes.spindle) : ""});
    if (turns && held_.spindle_wait > 0) add(dwell());
  }

  static std::string tool_word(const std::string& name, int number) {
    return name.empty() ? fmt::format("T{}", number) : name;
  }
  void call_next_tool() {
    if (held_.next_tool != held_.tool) add(tool_word(words_.next_tool_name, held_.next_tool));
  }

  /// As the control counts it.
  std::string dwell() const {
    if (rules_.osp_words) return "G4 " + place_word('F', held_.spindle_wait, 3);
    if (is_sinumerik()) return "G4 F" + trimmed(held_.spindle_wait, 3);
    if (rules_.dwell_in_ms) return "G4 P" + trimmed(std::ceil(held_.spindle_wait * 1000), 0);
    return "G4 P" + trimmed(held_.spindle_wait, 3);
  }

  std::string length_words() const {
    if (is_sinumerik()) return words_.length;
    const ToolLength& length = held_.modes.length;
    switch (length.kind) {
      case LengthKind::kNumbered:
        return fmt::format("{} H{}", rules_.length_on, length.h);
      case LengthKind::kOfTool:
        return "G43";
      case LengthKind::kStatedHeight:
        return "G43.1 " + place_word('Z', length.stated_mm / held_.modes.unit);
      case LengthKind::kOff:
        return std::string(rules_.length_off);
      default:
        return "";
    }
  }

  /// The way: up, across, down. Where a word of the program leads up to the machine's own top the cutter crosses there.
  void write_way() {
    const double z = *held_.position[2];
    const bool stays_up = held_.at_home && !words_.home.empty();
    const bool crosses_first = !words_.home.empty();
    if (crosses_first) add_words({"G0", over(0), over(1)});
    write_length(std::max(way_.safe_z, z), stays_up);
    if (!crosses_first) add_words({"G0", over(0), over(1)});
    for (const std::string& word : words_.coolant) add(word);
    if (stays_up) return;
    const WayDown down = way_down(held_, way_);
    if (down.rapid_to) add_words({"G0", at(2, *down.rapid_to)});
    if (!down.feed_to) return;
    add_words({"G1", at(2, *down.feed_to), feed_word(way_.plunge)});
    if (way_.beside) add_words({"G1", at(0), at(1), feed_word(lead_feed())});
  }
  /// mm/min; into the place from beside it.
  double lead_feed() const {
    const bool is_held = held_.modes.feed_mode == FeedMode::kPerMinute && held_.modes.feed > 0;
    return is_held ? held_.modes.feed : way_.plunge;
  }
  /// The place over which the cutter comes down. Beside the path it needs no more digits than any control takes.
  std::string over(std::size_t axis) const {
    if (!way_.beside) return at(axis);
    const double place = axis == 0 ? way_.beside->x : way_.beside->y;
    const int digits = held_.modes.unit == 1 ? 3 : 4;
    return place_word("XYZ"[axis], (place - held_.shift[axis]) / held_.modes.unit, digits);
  }

  /// What holds until the next tool comes in, and behind it.
  void write_until_change() {
    if (held_.tool_said) call_next_tool();
    if (held_.modes.speed > 0) add("S" + trimmed(held_.modes.speed, 6));
    write_unplaced();
  }

  /// Before the program has said where the cutter is nothing moves.
  void write_unplaced() {
    add(length_words());
    for (const std::string& word : words_.coolant) add(word);
  }

  /// A length that the program states itself comes in a block of its own; the others with the height.
  void write_length(double up, bool stays_up) {
    const std::string length = length_words();
    const bool alone = stays_up || held_.modes.length.kind == LengthKind::kStatedHeight ||
                       held_.modes.length.kind == LengthKind::kOff;
    if (alone) add(length);
    if (stays_up) return;
    add_words({"G0", alone ? "" : length, at(2, up)});
  }

  /// The feed word stands in a block with the height of the cutter, since some controls refuse a block of F alone; if the cutter stays
  /// up, the feed word has a block of its own.
  void write_modes_of_motion() {
    const bool comes_down = way_.is_needed && is_placed() && !(held_.at_home && !words_.home.empty());
    const FeedMode mode = held_.modes.feed_mode;
    if (mode != FeedMode::kPerMinute) add(words_.feed_mode);
    const bool is_held = mode != FeedMode::kInverseTime && held_.modes.feed > 0;
    const bool is_last = comes_down && mode == FeedMode::kPerMinute && held_.modes.feed == last_feed();
    if (is_held && !is_last) add_words({comes_down ? "G1 " + at(2) : "", feed_word(held_.modes.feed)});
    if (comes_down && held_.motion == 0) add_words({"G0", at(2)});
    if (!held_.modes.absolute) add("G91");
  }
  /// mm/min; that of the way down, 0 where there was none.
  double last_feed() const {
    const double z = *held_.position[2];
    if (z >= std::min(way_.entry_z, way_.safe_z) - kSamePlaceMm) return 0;
    return way_.beside ? lead_feed() : way_.plunge;
  }

  const HeldState& held_;
  const HeldWords& words_;
  const read::gcode::DialectRules& rules_;
  const WayIn& way_;
  std::string out_;
};

}  // namespace

WayDown way_down(const read::gcode::HeldState& held, const WayIn& way) {
  const double z = *held.position[2];
  if (z >= way.safe_z - kSamePlaceMm) return {};
  if (z >= way.entry_z - kSamePlaceMm || way.plunge <= 0) return {z, std::nullopt};
  if (way.entry_z < way.safe_z - kSamePlaceMm) return {way.entry_z, z};
  return {std::nullopt, z};
}

std::string lines_that_begin_again(const read::gcode::HeldState& held, const read::gcode::DialectRules& rules,
                                   const WayIn& way, int line) {
  if (rules.language == read::gcode::Language::kKlartext) return klartext_that_begins_again(held, way, line);
  return BeginWriter(held, rules, way).text(line);
}

}  // namespace clearcut::pipeline
