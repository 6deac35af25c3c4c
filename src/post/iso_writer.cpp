#include "post/iso_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/text.h"
#include "base/units.h"
#include "post/blocks.h"
#include "post/words/between_steps.h"
#include "post/words/comment.h"
#include "post/words/drill_cycle.h"
#include "post/words/iso_dialect.h"
#include "post/words/steps.h"

namespace clearcut::post {

namespace {

/// A cycle not ended yet: blocks with only a place repeat it.
struct OpenCycle {
  DrillBlock hole;
  std::string word;
};

bool is_same_cycle(const DrillBlock& a, const DrillBlock& b) {
  return a.form == b.form && a.bottom.z == b.bottom.z && a.clear == b.clear && a.above == b.above &&
         a.peck == b.peck && a.feed == b.feed;
}

/// State of the control. Modal words are cleared at a tool change, so that all are written again.
struct Held {
  Ticks at;
  bool plan = false;    ///< x and y of `at` are known
  bool height = false;  ///< z of `at` is known
  int motion = -1;
  long long feed = -1;
  int tool = 0;
  double spindle = 0;  ///< rpm, negative counter-clockwise, 0 stopped
  Coolant coolant = Coolant::kOff;
  bool length_due = false;  ///< the tool's length comes with the next approach
};

/// Numbers of subprograms begin here, below those from 8000 on that controls protect; in the other thousand where the program itself has
/// such a number.
constexpr int kFirstSubprogram = 7001, kOtherFirstSubprogram = 6001, kThousand = 1000;

/// A subprogram, and where it ends: x and y from its start, z as it is.
struct Body {
  std::string lines;
  Ticks end;
};

class IsoWriter {
 public:
  IsoWriter(const Part& part, const PostOptions& options, const IsoDialect& dialect, double safe_z)
      : part_(part),
        options_(options),
        dialect_(dialect),
        rules_(rules_for(options, dialect)),
        feed_grid_(options.inch, options.inch ? 3 : 2),
        safe_z_(rules_.grid.ticks(safe_z)),
        out_(dialect, options.block_numbers),
        stops_(part) {}

  std::string program(const Toolpath& toolpath);

 private:
  static StepRules rules_for(const PostOptions& options, const IsoDialect& dialect);

  void begin_program();
  void find_shared(const Toolpath& toolpath);
  int first_subprogram() const;
  void write_body(const Section& section, int number);
  void call_body(const Section& section, int number);
  std::string with_bodies(const std::string& head);
  void set_path_control(bool first);
  void set_rounding(CutLevel level, double rounding);
  void write_section(const Section& section, int subprogram, double rounding);
  bool repeats_cycle(const Section& section, bool new_tool);
  void end_cycle();
  void write_moves(std::span<const Move> run, const Section& section, const Tool* tap);
  void write_stops(const std::vector<ProgramStop>& stops);
  void end_program();

  void change_tool(int number);
  void load_by_changer(int number);
  void load_by_hand(int number);
  void home(bool with_table = false);
  void set_spindle(const Section& section);
  void dwell(double seconds);
  void set_coolant(Coolant wanted);

  void approach(const Move& first);
  void approach_above(const Move& first);
  void descend_with_length(const Ticks& start);
  void take_length_above(const Ticks& start);
  void retract();
  void rapid_to_plan(const Ticks& to);
  void rapid_to_height(long long z);
  void end_rapid();

  std::optional<DrillBlock> hole_at(std::span<const Move> moves, double at_floor) const;
  void call_cycle(const CycleCall& call);
  void write_hole(const DrillBlock& hole, const Tool* tap);
  void write_tap_move(const Move& move, const Section& section);
  bool is_compensated(const Section& section) const;
  void compensate(std::span<const Move> moves, std::size_t i, const Section& section);
  void begin_compensation(const Move& lead, const Move& next, const Section& section);
  [[noreturn]] void refuse_compensation(const Section& section, const std::string& why) const;
  void write_move(const Move& move);
  void write_rapid(const Ticks& to);
  void write_feed(const Step& step, MmPerMin feed);
  void motion_word(int code);
  void feed_word(MmPerMin feed);
  /// Within a subprogram X, Y and Z count from where the tool stands.
  void axis_word(char letter, long long ticks) {
    if (in_body_ && letter == 'X') ticks -= held_.at.x;
    if (in_body_ && letter == 'Y') ticks -= held_.at.y;
    if (in_body_ && letter == 'Z') ticks -= held_.at.z;
    out_.word(letter, ticks, rules_.grid);
  }

  /// Whether a program can be entered at the tool change that comes now: it states all modes again.
  bool states_modes_again() const { return dialect_.entered_at_tools && held_.tool != 0; }
  bool changes_tools() const { return dialect_.changer && options_.tool_changer; }
  LengthOffset length_offset() const {
    return options_.length_offset && changes_tools() ? dialect_.length_offset : LengthOffset::kNone;
  }

  const Part& part_;
  const PostOptions& options_;
  const IsoDialect& dialect_;
  StepRules rules_;
  PrintGrid feed_grid_;
  long long safe_z_;
  BlockPrinter out_;
  Held held_;
  std::vector<Step> steps_;
  Stops stops_;
  int sections_ = 0;  ///< written so far
  bool compensates_ = false;
  std::optional<OpenCycle> open_;
  CutLevel level_ = CutLevel::kMedium;
  double rounding_ = 0;         ///< mm; the last stated rounding of corners
  std::vector<int> changes_;    ///< tools in the order of their changes
  std::size_t changed_ = 0;     ///< number of tool changes so far
  std::vector<int> called_;     ///< of each section the number of its subprogram; 0: none
  std::map<int, Body> bodies_;  ///< by number
  std::string written_;         ///< of the program before the lines that out_ holds
  bool in_body_ = false;
};

StepRules IsoWriter::rules_for(const PostOptions& options, const IsoDialect& dialect) {
  const int decimals = options.decimals.value_or(options.inch ? dialect.inch_decimals : dialect.mm_decimals);
  return step_rules(options, decimals, dialect.largest_radius);
}

std::string IsoWriter::program(const Toolpath& toolpath) {
  changes_ = tool_changes_of(toolpath);
  const auto first = std::find_if(toolpath.sections.begin(), toolpath.sections.end(),
                                  [](const Section& section) { return !section.moves.empty(); });
  if (first != toolpath.sections.end()) level_ = level_of(*first, part_);
  rounding_ = options_.corner_tolerance_of(static_cast<std::size_t>(first - toolpath.sections.begin()));
  begin_program();
  find_shared(toolpath);
  const std::string head = out_.take();
  for (std::size_t i = 0; i < toolpath.sections.size(); ++i) {
    const Section& section = toolpath.sections[i];
    if (!section.moves.empty())
      write_section(section, called_.empty() ? 0 : called_[i], options_.corner_tolerance_of(i));
  }
  end_program();
  return with_bodies(head);
}

int IsoWriter::first_subprogram() const {
  if (dialect_.program_digits == 0) return kFirstSubprogram;
  const int own =
      options_.program_number.value_or(program_number(options_.program_name)) + options_.programs_before;
  return own / kThousand == kFirstSubprogram / kThousand ? kOtherFirstSubprogram : kFirstSubprogram;
}

/// Sections that are called: two or more make the same moves, which are no holes by cycles, taps or compensated passes.
void IsoWriter::find_shared(const Toolpath& toolpath) {
  const auto& sections = toolpath.sections;
  if (dialect_.subprograms == SubprogramForm::kNone || options_.subprograms.size() != sections.size()) return;
  called_ = shared_subprograms(options_.subprograms, [&](std::size_t i) {
    const Section& section = sections[i];
    if (section.moves.empty() || tap_of(section, part_) || is_compensated(section)) return false;
    const std::vector<Move> joined = with_lines_joined(section.moves, rules_.grid);
    const std::span<const Move> moves(joined);
    for (std::size_t k = 0; k < moves.size(); ++k)
      if (hole_at(moves.subspan(k), dwell_of(section, part_))) return false;
    return true;
  });
  for (int& number : called_)
    if (number > 0) number += first_subprogram() - 1;
}

/// The moves of the section from the safe height above their start and back to it, counted from there: G91.
void IsoWriter::write_body(const Section& section, int number) {
  written_ += out_.take();
  const Held before = held_;
  const Move& first = section.moves.front();
  const Ticks start = rules_.grid.ticks(first.path.from, first.z_from);
  out_.line("G91");
  in_body_ = true;
  held_.at = {start.x, start.y, safe_z_};
  held_.motion = -1;
  held_.feed = -1;
  rapid_to_height(start.z);
  for (const MoveRun& run : runs_of(section)) {
    write_moves(run.moves, section, nullptr);
    if (run.dwell_s > 0) dwell(run.dwell_s);
  }
  retract();
  in_body_ = false;
  out_.line("G90");
  bodies_[number] = {out_.take(), {held_.at.x - start.x, held_.at.y - start.y, held_.at.z}};
  held_ = before;
}

void IsoWriter::call_body(const Section& section, int number) {
  approach_above(section.moves.front());
  const bool is_first = !bodies_.contains(number);
  const std::string label = fmt::format("COPY{}", number);
  if (is_first && dialect_.subprograms == SubprogramForm::kRepeats) out_.line(label + ":");
  if (is_first) write_body(section, number);
  switch (dialect_.subprograms) {
    case SubprogramForm::kNone:
      break;
    case SubprogramForm::kOWords:
      out_.line(fmt::format("o{} call", number));
      break;
    case SubprogramForm::kPrograms:
      out_.line(fmt::format("M98 P{}", number));
      break;
    case SubprogramForm::kBlocks:
      out_.line(fmt::format("M97 P{}", number));
      break;
    case SubprogramForm::kRepeats:
      if (is_first) written_ += bodies_.at(number).lines;
      out_.line(is_first ? label + "_END:" : fmt::format("REPEAT {} {}_END", label, label));
  }
  const Ticks& end = bodies_.at(number).end;
  held_.at = {held_.at.x + end.x, held_.at.y + end.y, end.z};
  held_.motion = -1;
  held_.feed = -1;
}

/// The whole program: what O words define stands before its calls, programs and blocks stand behind the end, and repeated parts where they are
/// first run.
std::string IsoWriter::with_bodies(const std::string& head) {
  if (dialect_.subprograms == SubprogramForm::kRepeats) return head + written_ + out_.take();
  const bool before = dialect_.subprograms == SubprogramForm::kOWords;
  std::string definitions;
  for (const auto& [number, body] : bodies_) {
    if (before)
      definitions += fmt::format("o{} sub\n{}o{} endsub\n", number, body.lines, number);
    else
      definitions += fmt::format("{}{}\n{}M99\n", dialect_.subprograms == SubprogramForm::kBlocks ? 'N' : 'O',
                                 number, body.lines);
  }
  std::string rest = written_ + out_.take();
  if (before || bodies_.empty()) return head + definitions + rest;
  // The last line of a tape is its end.
  constexpr std::string_view kTapeEnd = "%\n";
  const bool ends_tape = dialect_.tape && rest.ends_with(kTapeEnd);
  if (ends_tape) rest.resize(rest.size() - kTapeEnd.size());
  return head + rest + definitions + (ends_tape ? std::string(kTapeEnd) : "");
}

void IsoWriter::begin_program() {
  if (dialect_.tape) out_.line("%");
  std::string number;
  if (dialect_.program_digits > 0) {
    const int first = options_.program_number.value_or(program_number(options_.program_name));
    number = fmt::format("O{:0{}}", first + options_.programs_before, dialect_.program_digits);
  }
  out_.title(number, options_.program_name);
  for (const std::string& text : options_.header) out_.comment(text);
  if (dialect_.named_in_header) out_.comment("FOR " + std::string(dialect_.name));
  out_.comment(options_.inch ? "UNITS: INCH" : "UNITS: MM");
  const std::string_view units = options_.inch ? dialect_.inches : dialect_.metric;
  if (!units.empty()) out_.line(units);
  for (const std::string& block : mode_blocks(dialect_, options_.work_offset)) out_.line(block);
  set_path_control(true);
}

/// Q0: no merging of lines, which would use the same tolerance again.
void IsoWriter::set_path_control(bool first) {
  if (options_.exact_stop) {
    if (!dialect_.exact_stop.empty()) out_.line(dialect_.exact_stop);
    return;
  }
  const double blend = rounding_ / (options_.inch ? kMmPerInch : 1);
  if (dialect_.path_control == PathControl::kTolerance)
    out_.line(fmt::format("G64 P{} Q0", trimmed(blend, 6)));
  if (dialect_.path_control == PathControl::kCornerRounding)
    out_.line(fmt::format("G187 P{} E{}", static_cast<int>(level_), trimmed(blend, 6)));
  if (dialect_.path_control == PathControl::kContour) out_.line("G642 CTOL=" + trimmed(blend, 6));
  if (dialect_.path_control != PathControl::kExactStop) return;
  // Written in the program, because a shop would ask why the machine stops at every corner.
  if (first && !options_.continuous)
    out_.comment("EXACT STOP: G64 ROUNDS CORNERS BY NO STATED BOUND, --ACCEPT BLENDING GIVES IT");
  out_.line(options_.continuous ? "G64" : dialect_.exact_stop);
}

/// Level of the cut, for controls that have a word for it, and rounding of corners, mm, from here on.
void IsoWriter::set_rounding(CutLevel level, double rounding) {
  const bool has_level = dialect_.path_control == PathControl::kCornerRounding,
             is_bounded = has_level || dialect_.path_control == PathControl::kTolerance ||
                          dialect_.path_control == PathControl::kContour;
  const bool changes = (has_level && level != level_) || (is_bounded && rounding != rounding_);
  level_ = level;
  rounding_ = rounding;
  if (changes && !options_.exact_stop) set_path_control(false);
}

/// Halts with the tool above the work and the spindle standing.
void IsoWriter::write_stops(const std::vector<ProgramStop>& stops) {
  if (halts(stops)) {
    if (held_.height) retract();
    set_coolant(Coolant::kOff);
    set_spindle({});
  }
  for (const ProgramStop& stop : stops) {
    out_.comment(stop_comment(stop));
    if (stop.kind == StopKind::kMessage) continue;
    out_.line(stop.kind == StopKind::kOptional && dialect_.optional_stop ? "M1" : "M0");
    held_.motion = -1;
    held_.feed = -1;
  }
}

/// Whether the section is one more hole of the open cycle. Its place is written then.
bool IsoWriter::repeats_cycle(const Section& section, bool new_tool) {
  if (!open_ || new_tool || section.coolant != held_.coolant || !section.dwells.empty()) return false;
  if ((section.spindle_clockwise ? section.spindle_rpm : -section.spindle_rpm) != held_.spindle) return false;
  const double at_floor = dwell_of(section, part_);
  const std::vector<Move> joined = with_lines_joined(section.moves, rules_.grid);
  const auto hole = hole_at(joined, at_floor);
  if (!hole || hole->moves != joined.size() || !is_same_cycle(*hole, open_->hole)) return false;
  if (cycle_word(*hole, tap_of(section, part_), dialect_) != open_->word) return false;
  if (held_.at.same_plan(hole->bottom)) return false;
  out_.comment(operation_comment(section.workingstep >= 0 ? ++sections_ : 0, section.label));
  axis_word('X', hole->bottom.x);
  axis_word('Y', hole->bottom.y);
  out_.end_block();
  held_.at = {hole->bottom.x, hole->bottom.y, hole->above};
  return true;
}

void IsoWriter::end_cycle() {
  if (!open_) return;
  open_.reset();
  out_.line("G80");
}

void IsoWriter::write_section(const Section& section, int subprogram, double rounding) {
  const std::vector<ProgramStop> stops = stops_.before(section);
  const bool new_tool = section.tool_number > 0 && section.tool_number != held_.tool;
  if (stops.empty() && repeats_cycle(section, new_tool)) return;
  end_cycle();
  write_stops(stops);
  // Without a tool length in force a height means nothing: the first tool change comes before any motion.
  if (new_tool && held_.height) retract();
  out_.comment(operation_comment(section.workingstep >= 0 ? ++sections_ : 0, section.label));
  held_.motion = -1;  // written again, so that the program can be entered here
  if (new_tool) {
    level_ = level_of(section, part_);
    if (states_modes_again()) rounding_ = rounding;
    change_tool(section.tool_number);
  }
  set_rounding(level_of(section, part_), rounding);
  set_spindle(section);
  set_coolant(section.coolant);
  if (subprogram > 0) return call_body(section, subprogram);
  approach(section.moves.front());
  const Tool* tap = tap_of(section, part_);
  if (tap) refuse_tap(*tap, dialect_.tapping, dialect_.name);
  for (const MoveRun& run : runs_of(section)) {
    write_moves(run.moves, section, tap);
    if (run.dwell_s > 0) dwell(run.dwell_s);
  }
}

void IsoWriter::write_moves(std::span<const Move> run, const Section& section, const Tool* tap) {
  const double at_floor = dwell_of(section, part_);
  const std::vector<Move> joined = with_lines_joined(run, rules_.grid);
  const std::span<const Move> moves(joined);
  for (std::size_t i = 0; i < moves.size(); ++i) {
    end_cycle();
    const bool taps_by_words = tap && dialect_.tapping == Tapping::kByWords;
    const auto hole = taps_by_words ? std::nullopt : hole_at(moves.subspan(i), at_floor);
    if (hole && held_.height && held_.at.z == hole->above) {
      if (dialect_.cycles == CycleForm::kCalls)
        call_cycle({*hole, tap, std::llround(section.spindle_rpm), section.spindle_clockwise, at_floor});
      else
        write_hole(*hole, tap);
      i += hole->moves - 1;
    } else if (tap) {
      write_tap_move(moves[i], section);
    } else {
      if (is_compensated(section)) compensate(moves, i, section);
      write_move(moves[i]);
      if (at_floor > 0 && ends_at_floor(moves[i], section)) dwell(at_floor);
    }
  }
}

/// The hole at the beginning of `moves`, if the control has a cycle for it.
std::optional<DrillBlock> IsoWriter::hole_at(std::span<const Move> moves, double at_floor) const {
  if (dialect_.cycles == CycleForm::kNone) return std::nullopt;
  if (dialect_.cycles == CycleForm::kWords && at_floor > 0) return std::nullopt;
  const auto hole = drill_block(moves, rules_.grid);
  const bool is_there = hole && (dialect_.cycles == CycleForm::kWords || has_cycle(*hole, at_floor));
  return is_there ? hole : std::nullopt;
}

/// The cycle is called at the end of the block with the place; a second MCALL ends it.
void IsoWriter::call_cycle(const CycleCall& call) {
  held_.feed = -1;
  feed_word(call.hole.feed);
  out_.end_block();
  out_.line(cycle_call(call, rules_.grid, options_.inch));
  motion_word(0);
  axis_word('X', call.hole.bottom.x);
  axis_word('Y', call.hole.bottom.y);
  out_.end_block();
  out_.line("MCALL");
  held_.at = {call.hole.bottom.x, call.hole.bottom.y, call.hole.above};
  held_.motion = -1;
  held_.feed = -1;
}

/// G98: back to the height before the cycle, as the moves do. G33.1 moves from the height at which feeding begins and
/// back, synchronised with the spindle.
void IsoWriter::write_hole(const DrillBlock& hole, const Tool* tap) {
  const std::string_view word = cycle_word(hole, tap, dialect_);
  if (word == "G33.1") {
    rapid_to_height(hole.clear);
    out_.word(word);
    axis_word('Z', hole.bottom.z);
    out_.word('K', PrintGrid(options_.inch, 6).ticks(tap->pitch), PrintGrid(options_.inch, 6));
    out_.end_block();
    held_.motion = -1;
    held_.feed = -1;
    return rapid_to_height(hole.above);
  }
  if (tap && !tap->floating && dialect_.tapping == Tapping::kRigidByM29)
    out_.line(fmt::format("M29 S{}", std::llround(std::abs(held_.spindle))));
  out_.word("G98");
  out_.word(word);
  axis_word('X', hole.bottom.x);
  axis_word('Y', hole.bottom.y);
  axis_word('Z', hole.bottom.z);
  axis_word('R', hole.clear);
  if (hole.peck > 0) axis_word('Q', hole.peck);
  held_.feed = -1;
  feed_word(hole.feed);
  out_.end_block();
  open_ = OpenCycle{hole, std::string(word)};
  if (!dialect_.modal_cycles) end_cycle();
  held_.at = {hole.bottom.x, hole.bottom.y, hole.above};
  held_.motion = -1;
  held_.feed = -1;
}

/// With a floating holder: the spindle turns back at the bottom, and forward again once the tap is out.
void IsoWriter::write_tap_move(const Move& move, const Section& section) {
  const bool out = !is_rapid(move.kind) && move.z_to > move.z_from;
  const auto speed = std::llround(section.spindle_rpm);
  if (out) out_.line(fmt::format("M{} S{}", section.spindle_clockwise ? 4 : 3, speed));
  write_move(move);
  if (!out) return;
  out_.line(fmt::format("M{} S{}", section.spindle_clockwise ? 3 : 4, speed));
  dwell(options_.spindle_wait ? options_.spindle_wait->seconds() : dialect_.spindle_wait);
}

void IsoWriter::end_program() {
  end_cycle();
  if (held_.height) retract();
  set_coolant(Coolant::kOff);
  set_spindle({});
  // The last retract has left the tool at the safe height.
  const EndPosition& end = options_.end;
  if (end.kind == EndPosition::Kind::kPlace && held_.height) rapid_to_plan(rules_.grid.ticks(end.place, 0));
  if (end.kind == EndPosition::Kind::kHome) {
    for (const std::string& block : home_blocks(dialect_)) out_.line(block);
  } else if (end.kind != EndPosition::Kind::kStay) {
    home(end.kind != EndPosition::Kind::kPlace && dialect_.table_forward);
  }
  if (dialect_.end.empty()) {
    out_.comment(kEndComment);
  } else {
    out_.line(dialect_.end);
  }
  if (dialect_.tape) out_.line("%");
}

void IsoWriter::change_tool(int number) {
  set_coolant(Coolant::kOff);
  set_spindle({});
  ++changed_;
  if (dialect_.numbers_tools) out_.number_next(static_cast<int>(changed_));
  home();
  if (options_.optional_stop && held_.tool != 0) out_.line("M1");
  out_.comment(tool_change_comment(part_, number, options_.inch));
  if (changes_tools()) {
    load_by_changer(number);
  } else {
    load_by_hand(number);
  }
  if (states_modes_again()) {
    for (const std::string& block : later_mode_blocks(dialect_, options_.work_offset)) out_.line(block);
    set_path_control(false);
  }
  held_.tool = number;
  held_.plan = held_.height = false;
  held_.motion = -1;
  held_.feed = -1;
}

void IsoWriter::load_by_changer(int number) {
  out_.line(fmt::format("T{} M6", number));
  // The magazine turns while this tool works.
  if (dialect_.preselects && changed_ < changes_.size()) out_.line(fmt::format("T{}", changes_[changed_]));
  if (length_offset() == LengthOffset::kPlain) out_.line("G43");
  if (length_offset() == LengthOffset::kNumbered)
    out_.line(fmt::format("{} H{}", dialect_.length_word, number));
  held_.length_due = length_offset() == LengthOffset::kWithApproach || length_offset() == LengthOffset::kEdge;
  // The first edge counts from the change on, unless a word states another one.
  if (dialect_.length_offset == LengthOffset::kEdge && !held_.length_due) out_.line("D0");
  // Without lengths each tool is touched off after loading. The first one may have been touched off before the start.
  const bool has_lengths = dialect_.length_offset != LengthOffset::kNone;
  if (!has_lengths || options_.length_offset || held_.tool == 0) return;
  out_.comment("TOUCH OFF Z WITH THIS TOOL");
  out_.line("M0");
}

/// The first tool is in the spindle when the program starts. Other tools have other lengths, unknown to controls
/// without lengths.
void IsoWriter::load_by_hand(int number) {
  if (dialect_.tool_word) out_.line(fmt::format("T{}", number));
  if (held_.tool == 0) return;
  out_.comment("TOUCH OFF Z WITH THIS TOOL");
  // The text must not contain a P or S with a number: it would be read as a dwell time.
  out_.line(dialect_.pause_says_tool ? fmt::format("M0 INSERT T{}, TOUCH OFF Z", number) : "M0");
}

/// Z to its home, `with_table` Y after it.
void IsoWriter::home(bool with_table) {
  if (dialect_.home == HomeForm::kSafeHeight || dialect_.home == HomeForm::kSwitches ||
      dialect_.home == HomeForm::kHomePosition)
    return;
  if (dialect_.home == HomeForm::kMachineZero) {
    out_.line("G53 G0 Z0.");
    if (with_table) out_.line("G53 G0 Y0.");
  } else if (dialect_.home == HomeForm::kSuppressed) {
    out_.line("SUPA G0 Z0 D0");
    held_.motion = -1;
  } else {
    out_.line("G91 G28 Z0.");
    if (with_table) out_.line("G28 Y0.");
    out_.line("G90");
  }
  held_.height = false;
}

void IsoWriter::set_spindle(const Section& section) {
  const double rpm = section.spindle_clockwise ? section.spindle_rpm : -section.spindle_rpm;
  if (rpm == held_.spindle) return;
  held_.spindle = rpm;
  if (rpm == 0) return out_.line("M5");
  out_.line(fmt::format("M{} S{}", rpm > 0 ? 3 : 4, std::max(1LL, std::llround(std::abs(rpm)))));
  dwell(options_.spindle_wait ? options_.spindle_wait->seconds() : dialect_.spindle_wait);
}

void IsoWriter::dwell(double seconds) {
  if (seconds <= 0) return;
  const char letter = "PXSF"[static_cast<int>(dialect_.dwell)];
  out_.word("G4");
  out_.word(letter, PrintGrid(false, 2).ticks(seconds), PrintGrid(false, 2));
  out_.end_block();
}

void IsoWriter::set_coolant(Coolant wanted) {
  for (const std::string_view word : coolant_words(held_.coolant, wanted, dialect_.mist)) out_.line(word);
  held_.coolant = wanted;
}

/// To the first move's start at the safe height, then down.
void IsoWriter::approach(const Move& first) {
  const Ticks start = rules_.grid.ticks(first.path.from, first.z_from);
  if (held_.length_due) return descend_with_length(start);
  const bool above = held_.plan && held_.at.same_plan(start);
  if (above && held_.height && held_.at.z == start.z) return;
  if (!above) {
    retract();
    rapid_to_plan(start);
  }
  rapid_to_height(start.z);
}

/// The spindle is at its upper end after a tool change: first the move in plan, then the tool's length during the
/// descent.
void IsoWriter::descend_with_length(const Ticks& start) {
  take_length_above(start);
  rapid_to_height(start.z);
}

void IsoWriter::take_length_above(const Ticks& start) {
  rapid_to_plan(start);
  out_.word(dialect_.length_offset == LengthOffset::kEdge ? "D1" : fmt::format("G43 H{}", held_.tool));
  axis_word('Z', safe_z_);
  out_.end_block();
  held_.at.z = safe_z_;
  held_.height = true;
  held_.length_due = false;
}

/// To the safe height above the first move's start.
void IsoWriter::approach_above(const Move& first) {
  const Ticks start = rules_.grid.ticks(first.path.from, first.z_from);
  if (held_.length_due) return take_length_above(start);
  if (!held_.plan || !held_.at.same_plan(start)) {
    retract();
    rapid_to_plan(start);
  }
  rapid_to_height(safe_z_);
}

void IsoWriter::retract() {
  if (!held_.height || held_.at.z < safe_z_) rapid_to_height(safe_z_);
}

void IsoWriter::rapid_to_plan(const Ticks& to) {
  motion_word(0);
  axis_word('X', to.x);
  axis_word('Y', to.y);
  held_.at.x = to.x;
  held_.at.y = to.y;
  held_.plan = true;
  end_rapid();
}

void IsoWriter::rapid_to_height(long long z) {
  if (held_.height && held_.at.z == z) return;
  motion_word(0);
  axis_word('Z', z);
  held_.at.z = z;
  held_.height = true;
  end_rapid();
}

/// The first feed move after a rapid states its feed again.
void IsoWriter::end_rapid() {
  held_.feed = -1;
  if (dialect_.rapid_feed) feed_word(options_.rapid);
  held_.feed = -1;
  out_.end_block();
}

bool IsoWriter::is_compensated(const Section& section) const {
  return options_.wear && options_.wear->shifts(section.workingstep);
}

void IsoWriter::refuse_compensation(const Section& section, const std::string& why) const {
  throw InputError("--compensation", "the passes along the walls of '" + section.label + "' " + why);
}

/// The words before move i: compensation is on along a pass, begins with the line that leads in and ends with the one that leads out.
void IsoWriter::compensate(std::span<const Move> moves, std::size_t i, const Section& section) {
  const Move& move = moves[i];
  const bool cuts_next = i + 1 < moves.size() && moves[i + 1].kind == MoveKind::kCut;
  if (move.kind == MoveKind::kLeadIn && cuts_next) {
    begin_compensation(move, moves[i + 1], section);
  } else if (move.kind == MoveKind::kLeadOut && compensates_) {
    if (move.path.is_arc())
      refuse_compensation(section, "end with an arc; give --lead-angle, so that they end with a line");
    out_.word("G40");
    compensates_ = false;
  } else if (move.kind == MoveKind::kCut && !compensates_) {
    refuse_compensation(
        section, "begin without a line of their own; give a shorter --lead, or leave out --compensation");
  } else if (move.kind != MoveKind::kCut && compensates_) {
    refuse_compensation(
        section, "end without a line of their own; give a shorter --lead, or leave out --compensation");
  }
}

/// Away from the wall is where the lead comes from: there a D above 0 shifts the path.
void IsoWriter::begin_compensation(const Move& lead, const Move& next, const Section& section) {
  if (lead.path.is_arc())
    refuse_compensation(section, "begin with an arc; give --lead-angle, so that they begin with a line");
  if (lead.path.length() <= 2 * options_.wear->range)
    refuse_compensation(
        section,
        "begin with a line of " + trimmed(lead.path.length(), 3) +
            " mm, which is less than twice the range of wear; give a longer --lead (in the slot of a "
            "profile, more --finish-stock) or a smaller --wear-range");
  const bool is_left = cross(next.path.tangent_at(0), lead.path.from - lead.path.to) > 0;
  out_.word(is_left ? "G41" : "G42");
  if (dialect_.radius == RadiusWord::kNumbered) out_.word(fmt::format("D{}", held_.tool));
  compensates_ = true;
}

void IsoWriter::write_move(const Move& move) {
  steps_.clear();
  StepRules rules = rules_;
  const bool rapid = is_rapid(move.kind);
  if (rapid) rules.arcs = false;
  append_steps(move, held_.at, rules, steps_);
  for (const Step& step : steps_) {
    if (rapid) {
      write_rapid(step.to);
    } else {
      write_feed(step, move.feed);
    }
  }
}

void IsoWriter::write_rapid(const Ticks& to) {
  if (dialect_.dogleg_rapids && to.z != held_.at.z && !to.same_plan(held_.at)) {
    Ticks corner = to;  // the place beside or above: up first, down last
    if (to.z < held_.at.z) {
      corner.z = held_.at.z;
    } else {
      corner = {held_.at.x, held_.at.y, to.z};
    }
    write_rapid(corner);
  }
  motion_word(0);
  if (to.x != held_.at.x) axis_word('X', to.x);
  if (to.y != held_.at.y) axis_word('Y', to.y);
  if (to.z != held_.at.z) axis_word('Z', to.z);
  held_.at = to;
  end_rapid();
}

/// Arcs say X, Y, I and J always: some controls want one in-plane word of each pair, none minds both.
void IsoWriter::write_feed(const Step& step, MmPerMin feed) {
  const bool arc = step.turn != Turn::kStraight;
  motion_word(!arc ? 1 : step.turn == Turn::kClockwise ? 2 : 3);
  if (arc || step.to.x != held_.at.x) axis_word('X', step.to.x);
  if (arc || step.to.y != held_.at.y) axis_word('Y', step.to.y);
  if (step.to.z != held_.at.z) axis_word('Z', step.to.z);
  if (arc) {
    axis_word('I', step.i);
    axis_word('J', step.j);
  }
  held_.at = step.to;
  feed_word(feed);
  out_.end_block();
}

void IsoWriter::motion_word(int code) {
  if (code == held_.motion && !dialect_.repeats_motion) return;
  held_.motion = code;
  constexpr std::string_view kWords[] = {"G0", "G1", "G2", "G3"};
  out_.word(kWords[code]);
}

void IsoWriter::feed_word(MmPerMin feed) {
  const long long ticks = std::max(1LL, feed_grid_.ticks(feed.mm_per_min()));
  if (ticks == held_.feed) return;
  held_.feed = ticks;
  std::string word = "F";
  append_number(word, ticks, feed_grid_.decimals(), dialect_.always_point);
  // If the block would be too long for senders, the feed is written in its own block before.
  const bool is_long =
      dialect_.packed_length > 0 && out_.packed_size() + word.size() > dialect_.packed_length;
  if (is_long) return out_.line(word);
  out_.word('F', ticks, feed_grid_);
}

}  // namespace

std::string write_iso(const Toolpath& toolpath, const Part& part, const PostOptions& options,
                      const IsoDialect& dialect) {
  return IsoWriter(part, options, dialect, safe_height(toolpath, part)).program(toolpath);
}

}  // namespace clearcut::post
