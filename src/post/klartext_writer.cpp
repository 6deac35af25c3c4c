// Cycles 200 (drilling), 201 (reaming), 206 (tapping in a floating holder) and 207 (rigid tapping). Pecks are written
// as moves: how far above the last depth a cycle feeds again is the same number there as its distance from the
// surface.
#include "post/klartext_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "base/elementary.h"
#include "base/text.h"
#include "base/units.h"
#include "post/words/between_steps.h"
#include "post/words/comment.h"
#include "post/words/drill_cycle.h"
#include "post/words/iso_dialect.h"
#include "post/words/steps.h"

namespace clearcut::post {
namespace {

constexpr int kPitchDecimals = 4;
constexpr double kPitchShare = 1e-3;  // of a pitch; permitted error of its printed digits

/// One line of a definition.
struct Parameter {
  int number;
  std::string value;
  const char* meaning;
};

std::string definition(const std::string& cycle, std::initializer_list<Parameter> parameters) {
  std::string text = "CYCL DEF " + cycle;
  for (const Parameter& one : parameters)
    text += " ~\n  Q" + std::to_string(one.number) + "=" + one.value + " ;" + one.meaning;
  return text;
}

PrintGrid pitch_grid(bool inch) {
  return {inch, kPitchDecimals};
}

/// Lengths stated by all cycles.
struct Heights {
  std::string above_surface, depth, surface, above;
};

Heights heights_of(const DrillBlock& hole, long long surface, const PrintGrid& grid) {
  const auto text = [&](long long ticks) { return signed_number(ticks, grid.decimals()); };
  return {text(hole.clear - surface), text(hole.bottom.z - surface), text(surface),
          text(hole.above - surface)};
}

std::string drilling(const Heights& at, const std::string& feed) {
  return definition("200 DRILLING", {{200, at.above_surface, "SET-UP CLEARANCE"},
                                     {201, at.depth, "DEPTH"},
                                     {206, feed, "FEED RATE FOR PLNGNG"},
                                     {202, "+" + at.depth.substr(1), "PLUNGING DEPTH"},
                                     {210, "+0", "DWELL TIME AT TOP"},
                                     {203, at.surface, "SURFACE COORDINATE"},
                                     {204, at.above, "2ND SET-UP CLEARANCE"},
                                     {211, "+0", "DWELL TIME AT DEPTH"}});
}

/// A retract feed of 0 means the feed on the way in.
std::string reaming(const Heights& at, const std::string& feed) {
  return definition("201 REAMING", {{200, at.above_surface, "SET-UP CLEARANCE"},
                                    {201, at.depth, "DEPTH"},
                                    {206, feed, "FEED RATE FOR PLNGNG"},
                                    {211, "+0", "DWELL TIME AT DEPTH"},
                                    {208, "+0", "RETRACTION FEED RATE"},
                                    {203, at.surface, "SURFACE COORDINATE"},
                                    {204, at.above, "2ND SET-UP CLEARANCE"}});
}

std::string floating_tapping(const Heights& at, const std::string& feed) {
  return definition("206 TAPPING NEW", {{200, at.above_surface, "SET-UP CLEARANCE"},
                                        {201, at.depth, "DEPTH OF THREAD"},
                                        {206, feed, "FEED RATE FOR PLNGNG"},
                                        {211, "+0", "DWELL TIME AT DEPTH"},
                                        {203, at.surface, "SURFACE COORDINATE"},
                                        {204, at.above, "2ND SET-UP CLEARANCE"}});
}

/// The pitch of a left-hand thread is negative.
std::string rigid_tapping(const Heights& at, const Tool& tap, bool inch) {
  const long long pitch = pitch_grid(inch).ticks(tap.pitch);
  return definition("207 RIGID TAPPING NEW",
                    {{200, at.above_surface, "SET-UP CLEARANCE"},
                     {201, at.depth, "DEPTH OF THREAD"},
                     {239, signed_number(tap.left_hand ? -pitch : pitch, kPitchDecimals), "THREAD PITCH"},
                     {203, at.surface, "SURFACE COORDINATE"},
                     {204, at.above, "2ND SET-UP CLEARANCE"}});
}

}  // namespace

std::string hole_cycle(const DrillBlock& hole, double surface, const Tool* tap, const PrintGrid& grid,
                       bool inch) {
  const Heights at = heights_of(hole, grid.ticks(surface), grid);
  if (tap && !tap->floating) return taps_rigidly(*tap, inch) ? rigid_tapping(at, *tap, inch) : "";
  const std::string feed = signed_number(klartext_feed(hole.feed, inch), kKlartextFeedDecimals);
  if (tap) return floating_tapping(at, feed);
  if (hole.form == DrillForm::kAtOnce) return drilling(at, feed);
  return hole.form == DrillForm::kFeedsOut ? reaming(at, feed) : "";
}

bool taps_rigidly(const Tool& tap, bool inch) {
  const PrintGrid grid = pitch_grid(inch);
  return std::abs(grid.mm(grid.ticks(tap.pitch)) - tap.pitch) <= kPitchShare * tap.pitch;
}

// Blocks are numbered from 0 without gaps; the centre of an arc is absolute and modal (CC); a helix is polar
// (CP).

namespace {

constexpr int kAngleDecimals = 4;
constexpr double kAngleSteps = 1e4;  // in a degree
constexpr std::size_t kLineLength = 80;
/// mm; a wider helix would miss its end by more than 0.2 um, because its angle is printed with four decimals.
constexpr double kWidestHelix = 200;
constexpr double kLargestRadius = 10000;   // mm
constexpr double kFinestTolerance = 1e-5;  // mm or inch, of cycle 32
constexpr double kAboveSurface =
    1;  // mm; assumed distance from the height at which feeding begins down to an
        // unknown surface
constexpr std::size_t kNameLength = 24;  // characters of a file's name shown by TNCs

std::string program_name(const std::string& wanted) {
  std::string name;
  for (const char c : wanted) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 128 && (std::isalnum(byte) || c == '-' || c == '_')) {
      name += static_cast<char>(std::toupper(byte));
    } else if (!name.empty() && name.back() != '_') {
      name += '_';  // words do not run together
    }
  }
  name = name.substr(0, kNameLength);
  while (!name.empty() && name.back() == '_') name.pop_back();
  return name.empty() ? "CLEARCUT" : name;
}

struct ControlState {
  Ticks at;
  bool plan = false;
  bool height = false;
  Vec2 off_grid;                ///< displacement of the tool from `at` after a helix, in steps
  std::optional<Ticks> center;  ///< CC
  long long feed = -1;
  int tool = 0;
  double rpm = 0;
  int spindle = 5;  ///< 3, 4, 5 as in M3, M4, M5
  Coolant coolant = Coolant::kOff;
  std::string cycle;  ///< last definition for the tool
};

Vec2 in_steps(const Ticks& at) {
  return {static_cast<double>(at.x), static_cast<double>(at.y)};
}

const char* turn_text(Turn turn) {
  return turn == Turn::kCounterClockwise ? " DR+" : " DR-";
}

/// A subprogram (LBL), in the coordinates of the first place that it is called for.
struct LabelBody {
  std::vector<std::string> blocks;  ///< without their numbers
  Ticks start, end;
};

class KlartextWriter {
 public:
  KlartextWriter(const Part& part, const PostOptions& options, double safe_z)
      : part_(part),
        options_(options),
        rules_(step_rules(
            options, options.decimals.value_or(options.inch ? kKlartextInchDecimals : kKlartextMmDecimals),
            kLargestRadius)),
        safe_z_(rules_.grid.ticks(safe_z)),
        stops_(part),
        name_(program_name(options.program_name)) {}

  std::string program(const Toolpath& toolpath);

 private:
  void begin_program(const Toolpath& toolpath);
  double first_rounding(const Toolpath& toolpath) const;
  void set_rounding(double rounding);
  void blank_form(const Toolpath& toolpath);
  void find_shared(const Toolpath& toolpath);
  void write_section(const Section& section, int subprogram, double rounding);
  void write_body(const Section& section, int number);
  void call_body(const Section& section, int number);
  void shift_datum(long long x, long long y);
  void write_bodies();
  void write_runs(const Section& section, const Tool* tap);
  void write_moves(std::span<const Move> run, const Section& section, const Tool* tap);
  void write_stops(const std::vector<ProgramStop>& stops);
  void dwell(double seconds);
  void end_program();
  void go_to_end();
  void call_tool(const Section& section);
  void set_spindle(int m);
  void set_coolant(Coolant wanted);
  void approach(const Move& first);
  void retract();
  void rapid_to_plan(const Ticks& to);
  void rapid_to_height(long long z);
  bool write_hole(const DrillBlock& hole, const Tool* tap, const Section& section);
  double surface_over(const DrillBlock& hole, const Section& section) const;
  void write_tap_move(const Move& move, const Section& section);
  void end_rapid();
  void write_move(const Move& move);
  void write_line(const Ticks& to, bool rapid, MmPerMin feed);
  void write_arc(const Step& step, MmPerMin feed);
  void write_helix(const Step& step, const Ticks& center, MmPerMin feed);

  void block(const std::string& text) {
    if (body_ != nullptr)
      body_->blocks.push_back(text);
    else
      out_ += fmt::format("{} {}\n", number_++, text);
  }
  void comment(std::string_view text);
  std::string coordinate(std::string_view name, long long ticks) const;
  std::string feed_text(MmPerMin feed);
  const char* unit() const { return options_.inch ? "INCH" : "MM"; }

  const Part& part_;
  const PostOptions& options_;
  StepRules rules_;
  long long safe_z_;
  Stops stops_;
  std::string name_;
  std::string out_;
  int number_ = 0;
  ControlState held_;
  double rounding_ = -1;  ///< mm; the last stated rounding of corners; negative: none
  std::vector<Step> steps_;
  int sections_ = 0;         ///< written so far
  std::vector<int> called_;  ///< of each section; 0: it is written where it stands
  std::map<int, LabelBody> bodies_;
  LabelBody* body_ = nullptr;  ///< that is written now
};

std::string KlartextWriter::program(const Toolpath& toolpath) {
  begin_program(toolpath);
  find_shared(toolpath);
  for (std::size_t i = 0; i < toolpath.sections.size(); ++i) {
    const Section& section = toolpath.sections[i];
    if (!section.moves.empty())
      write_section(section, called_.empty() ? 0 : called_[i], options_.corner_tolerance_of(i));
  }
  end_program();
  return std::move(out_);
}

void KlartextWriter::begin_program(const Toolpath& toolpath) {
  block(fmt::format("BEGIN PGM {} {}", name_, unit()));
  for (const std::string& text : options_.header) comment(text);
  comment(options_.inch ? "UNITS: INCH" : "UNITS: MM");
  blank_form(toolpath);
  set_rounding(first_rounding(toolpath));
}

/// mm; rounding of corners in the first section that moves.
double KlartextWriter::first_rounding(const Toolpath& toolpath) const {
  const auto first = std::find_if(toolpath.sections.begin(), toolpath.sections.end(),
                                  [](const Section& section) { return !section.moves.empty(); });
  return options_.corner_tolerance_of(static_cast<std::size_t>(first - toolpath.sections.begin()));
}

/// Rounding of corners, mm, from here on.
void KlartextWriter::set_rounding(double rounding) {
  if (rounding == rounding_) return;
  rounding_ = rounding;
  block("CYCL DEF 32.0 TOLERANCE");
  const double tolerance = rounding / (options_.inch ? kMmPerInch : 1);
  block("CYCL DEF 32.1 T" + trimmed(std::max(kFinestTolerance, tolerance), 5));
}

/// The stock, or the extent of the tool's centre if no stock is known.
void KlartextWriter::blank_form(const Toolpath& toolpath) {
  Box plan = part_.stock ? part_.stock->plan : Box{};
  double bottom = part_.stock ? part_.stock->z_bottom : -1, top = part_.stock ? part_.stock->z_top : 0;
  if (!part_.stock) {
    for (const Section& section : toolpath.sections) {
      for (const Move& move : section.moves) {
        plan.add(move.path.box());
        bottom = std::min(bottom, move.z_to);
      }
    }
    if (plan.empty()) plan.add(Vec2{});
    plan = plan.grown(1);
  }
  const Ticks low = rules_.grid.ticks(plan.min, bottom), high = rules_.grid.ticks(plan.max, top);
  block("BLK FORM 0.1 Z" + coordinate(" X", low.x) + coordinate(" Y", low.y) + coordinate(" Z", low.z));
  block("BLK FORM 0.2" + coordinate(" X", high.x) + coordinate(" Y", high.y) + coordinate(" Z", high.z));
}

/// Halts with the tool above the work and the spindle standing.
void KlartextWriter::write_stops(const std::vector<ProgramStop>& stops) {
  if (halts(stops)) {
    if (held_.height) retract();
    set_coolant(Coolant::kOff);
    set_spindle(5);
  }
  for (const ProgramStop& stop : stops) {
    comment(stop_comment(stop));
    if (stop.kind == StopKind::kMessage) continue;
    block(stop.kind == StopKind::kOptional ? "M1" : "M0");
    end_rapid();
  }
}

void KlartextWriter::dwell(double seconds) {
  block("CYCL DEF 9.0 DWELL TIME");
  block("CYCL DEF 9.1 DWELL " + trimmed(seconds, 3));
}

/// Sections that are called: two or more make the same moves, which are no holes by cycles or taps.
void KlartextWriter::find_shared(const Toolpath& toolpath) {
  const auto& sections = toolpath.sections;
  if (options_.subprograms.size() != sections.size()) return;
  called_ = shared_subprograms(options_.subprograms, [&](std::size_t i) {
    const Section& section = sections[i];
    if (section.moves.empty() || tap_of(section, part_)) return false;
    const std::vector<Move> joined = with_lines_joined(section.moves, rules_.grid);
    const std::span<const Move> moves(joined);
    for (std::size_t k = 0; k < moves.size(); ++k)
      if (drill_block(moves.subspan(k), rules_.grid)) return false;
    return true;
  });
}

/// The way to the section from wherever the tool stands, its moves, and the way up.
void KlartextWriter::write_body(const Section& section, int number) {
  const ControlState before = held_;
  LabelBody& body = bodies_[number];
  body_ = &body;
  body.start = rules_.grid.ticks(section.moves.front().path.from, section.moves.front().z_from);
  held_.plan = held_.height = false;
  end_rapid();
  approach(section.moves.front());
  write_runs(section, nullptr);
  retract();
  body.end = held_.at;
  body_ = nullptr;
  held_ = before;
}

/// At another place than the first the datum is shifted meanwhile.
void KlartextWriter::call_body(const Section& section, int number) {
  if (!bodies_.contains(number)) write_body(section, number);
  const LabelBody& body = bodies_.at(number);
  const Ticks start = rules_.grid.ticks(section.moves.front().path.from, section.moves.front().z_from);
  const long long x = start.x - body.start.x, y = start.y - body.start.y;
  const bool is_elsewhere = x != 0 || y != 0;
  if (is_elsewhere) shift_datum(x, y);
  block(fmt::format("CALL LBL {}", number));
  if (is_elsewhere) shift_datum(0, 0);
  held_.at = {body.end.x + x, body.end.y + y, body.end.z};
  held_.plan = held_.height = true;
  held_.off_grid = {};
  end_rapid();
}

void KlartextWriter::shift_datum(long long x, long long y) {
  block("CYCL DEF 7.0 DATUM SHIFT");
  block("CYCL DEF 7.1" + coordinate(" X", x));
  block("CYCL DEF 7.2" + coordinate(" Y", y));
}

/// Behind the end of the program, where nothing runs into them.
void KlartextWriter::write_bodies() {
  for (const auto& [number, body] : bodies_) {
    block(fmt::format("LBL {}", number));
    for (const std::string& text : body.blocks) block(text);
    block("LBL 0");
  }
}

void KlartextWriter::write_section(const Section& section, int subprogram, double rounding) {
  write_stops(stops_.before(section));
  const bool new_tool = section.tool_number > 0 && section.tool_number != held_.tool;
  if (new_tool && held_.height) retract();
  comment(operation_comment(section.workingstep >= 0 ? ++sections_ : 0, section.label));
  if (new_tool) {
    set_coolant(Coolant::kOff);
    set_spindle(5);
    if (options_.optional_stop && held_.tool != 0) block("M1");
    comment(tool_change_comment(part_, section.tool_number, options_.inch));
  }
  call_tool(section);
  set_spindle(section.spindle_rpm <= 0 ? 5 : section.spindle_clockwise ? 3 : 4);
  set_coolant(section.coolant);
  set_rounding(rounding);
  if (subprogram > 0) return call_body(section, subprogram);
  approach(section.moves.front());
  const Tool* tap = tap_of(section, part_);
  if (tap)
    refuse_tap(*tap, taps_rigidly(*tap, options_.inch) ? Tapping::kRigid : Tapping::kByWords, "heidenhain");
  write_runs(section, tap);
}

void KlartextWriter::write_runs(const Section& section, const Tool* tap) {
  for (const MoveRun& run : runs_of(section)) {
    write_moves(run.moves, section, tap);
    if (run.dwell_s > 0) dwell(run.dwell_s);
  }
}

void KlartextWriter::write_moves(std::span<const Move> run, const Section& section, const Tool* tap) {
  const double at_floor = dwell_of(section, part_);
  const std::vector<Move> joined = with_lines_joined(run, rules_.grid);
  const std::span<const Move> moves(joined);
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const auto hole = at_floor > 0 ? std::nullopt : drill_block(moves.subspan(i), rules_.grid);
    if (hole && write_hole(*hole, tap, section)) {
      i += hole->moves - 1;
    } else if (tap) {
      write_tap_move(moves[i], section);
    } else {
      write_move(moves[i]);
      if (at_floor > 0 && ends_at_floor(moves[i], section)) dwell(at_floor);
    }
  }
}

/// The top of the drilled material; if the feature does not state it, 1 mm below the height at which feeding begins.
/// Between bottom and clearance.
double KlartextWriter::surface_over(const DrillBlock& hole, const Section& section) const {
  const double clear = rules_.grid.mm(hole.clear), bottom = rules_.grid.mm(hole.bottom.z);
  const auto step = static_cast<std::size_t>(std::max(section.workingstep, 0));
  const bool known = section.workingstep >= 0 && step < part_.workplan.size();
  const double top = known ? feature_of(part_, part_.workplan[step]).top_z : clear;
  return top > bottom && top < clear ? top : std::max(clear - kAboveSurface, (clear + bottom) / 2);
}

/// Equal holes share one definition. Returns whether a cycle makes the hole from the tool's position.
bool KlartextWriter::write_hole(const DrillBlock& hole, const Tool* tap, const Section& section) {
  const bool over = held_.height && held_.at.z == hole.above && held_.at.same_plan(hole.bottom);
  if (!over || held_.off_grid != Vec2{}) return false;
  const std::string cycle = hole_cycle(hole, surface_over(hole, section), tap, rules_.grid, options_.inch);
  if (cycle.empty()) return false;
  if (cycle != held_.cycle) block(cycle);
  held_.cycle = cycle;
  block("CYCL CALL");
  if (tap && !tap->floating) held_.spindle = 5;  // rigid tapping leaves the spindle stopped
  end_rapid();
  return true;
}

/// With a floating holder the spindle turns back at the bottom, and forward again once the tap is out.
void KlartextWriter::write_tap_move(const Move& move, const Section& section) {
  const bool out = !is_rapid(move.kind) && move.z_to > move.z_from;
  if (out) block(section.spindle_clockwise ? "M4" : "M3");
  write_move(move);
  if (!out) return;
  held_.spindle = section.spindle_clockwise ? 4 : 3;
  set_spindle(section.spindle_clockwise ? 3 : 4);
}

void KlartextWriter::end_program() {
  if (held_.height) retract();
  set_coolant(Coolant::kOff);
  set_spindle(5);
  go_to_end();
  block("M30");
  write_bodies();
  block(fmt::format("END PGM {} {}", name_, unit()));
}

/// From the safe height, reached by the last retract; Z first.
void KlartextWriter::go_to_end() {
  const EndPosition& end = options_.end;
  if (end.kind == EndPosition::Kind::kPlace && held_.height) rapid_to_plan(rules_.grid.ticks(end.place, 0));
  if (end.kind != EndPosition::Kind::kHome) return;
  block("L Z+0 R0 FMAX M91");
  block("L X+0 Y+0 R0 FMAX M91");
}

/// A call without a number changes only the speed. The length comes from the control's own table.
void KlartextWriter::call_tool(const Section& section) {
  const bool new_tool = section.tool_number > 0 && section.tool_number != held_.tool;
  const bool new_speed = section.spindle_rpm > 0 && section.spindle_rpm != held_.rpm;
  if (!new_tool && !new_speed) return;
  std::string text = "TOOL CALL";
  if (new_tool) text += fmt::format(" {}", section.tool_number);
  text += " Z";
  if (section.spindle_rpm > 0) text += fmt::format(" S{}", std::max(1LL, std::llround(section.spindle_rpm)));
  block(text);
  held_.rpm = section.spindle_rpm;
  if (!new_tool) return;
  held_.tool = section.tool_number;
  held_.plan = held_.height = false;
  held_.cycle.clear();
  end_rapid();
}

void KlartextWriter::set_spindle(int m) {
  if (m == held_.spindle) return;
  held_.spindle = m;
  block(fmt::format("M{}", m));
  const double wait = options_.spindle_wait ? options_.spindle_wait->seconds() : 0;
  if (m == 5 || wait <= 0) return;
  dwell(wait);
}

void KlartextWriter::set_coolant(Coolant wanted) {
  for (const std::string_view word : coolant_words(held_.coolant, wanted, {})) block(std::string(word));
  held_.coolant = wanted;
}

void KlartextWriter::approach(const Move& first) {
  const Ticks start = rules_.grid.ticks(first.path.from, first.z_from);
  const bool above = held_.plan && held_.at.same_plan(start);
  if (above && held_.height && held_.at.z == start.z) return;
  if (!above) {
    retract();
    rapid_to_plan(start);
  }
  rapid_to_height(start.z);
}

void KlartextWriter::retract() {
  if (!held_.height || held_.at.z < safe_z_) rapid_to_height(safe_z_);
}

void KlartextWriter::rapid_to_plan(const Ticks& to) {
  block("L" + coordinate(" X", to.x) + coordinate(" Y", to.y) + " R0 FMAX");
  held_.at.x = to.x;
  held_.at.y = to.y;
  held_.off_grid = {};
  held_.plan = true;
  end_rapid();
}

void KlartextWriter::rapid_to_height(long long z) {
  if (held_.height && held_.at.z == z) return;
  block("L" + coordinate(" Z", z) + " R0 FMAX");
  held_.at.z = z;
  held_.height = true;
  end_rapid();
}

/// The next cut states its feed and its centre again, so that the program can be entered there.
void KlartextWriter::end_rapid() {
  held_.feed = -1;
  held_.center.reset();
}

void KlartextWriter::write_move(const Move& move) {
  const bool rapid = is_rapid(move.kind);
  const bool wide_helix = move.path.is_arc() && move.z_from != move.z_to && move.path.radius() > kWidestHelix;
  StepRules rules = rules_;
  if (rapid || wide_helix) rules.arcs = false;
  steps_.clear();
  append_steps(move, held_.at, rules, steps_);
  for (const Step& step : steps_) {
    if (step.turn == Turn::kStraight) {
      write_line(step.to, rapid, move.feed);
    } else {
      write_arc(step, move.feed);
    }
  }
}

/// After a helix ending off the grid, a line in plan removes the difference; on vertical moves the difference is
/// kept.
void KlartextWriter::write_line(const Ticks& to, bool rapid, MmPerMin feed) {
  std::string text = "L";
  if (!to.same_plan(held_.at)) {
    const bool off_grid = held_.off_grid != Vec2{};
    if (off_grid || to.x != held_.at.x) text += coordinate(" X", to.x);
    if (off_grid || to.y != held_.at.y) text += coordinate(" Y", to.y);
    held_.off_grid = {};
  }
  if (to.z != held_.at.z) text += coordinate(" Z", to.z);
  held_.at = to;
  if (rapid) end_rapid();
  block(text + (rapid ? " R0 FMAX" : feed_text(feed)));
}

/// Signed angle about the origin in degrees, from `start` to `end` in the sense of its turn.
double swept_degrees(Vec2 start, Vec2 end, Turn turn) {
  const double side = turn == Turn::kCounterClockwise ? 1 : -1;
  const double angle = side * base::atan2(cross(start, end), dot(start, end));
  return side * (angle > 0 ? angle : angle + 2 * kPi) * 180 / kPi;
}

void KlartextWriter::write_arc(const Step& step, MmPerMin feed) {
  const Ticks center{held_.at.x + step.i, held_.at.y + step.j, 0};
  if (held_.center != center) {
    block("CC" + coordinate(" X", center.x) + coordinate(" Y", center.y));
    held_.center = center;
  }
  if (step.to.z == held_.at.z) {
    held_.at = step.to;
    held_.off_grid = {};
    block("C" + coordinate(" X", step.to.x) + coordinate(" Y", step.to.y) + turn_text(step.turn) +
          feed_text(feed));
  } else {
    write_helix(step, center, feed);
  }
}

/// A helix ends at the place given by its angle, off the grid: the difference is stored, so that a run of helices
/// does not drift, and removed when it exceeds a share of a step.
void KlartextWriter::write_helix(const Step& step, const Ticks& center, MmPerMin feed) {
  const Vec2 middle = in_steps(center), end = in_steps(step.to) - middle;
  const Vec2 start = in_steps(held_.at) + held_.off_grid - middle;
  const double degrees = std::round(swept_degrees(start, end, step.turn) * kAngleSteps) / kAngleSteps;
  std::string text = degrees > 0 ? "CP IPA+" : "CP IPA";
  append_number(text, std::llround(degrees * kAngleSteps), kAngleDecimals, false);
  block(text + coordinate(" IZ", step.to.z - held_.at.z) + turn_text(step.turn) + feed_text(feed));
  held_.at = step.to;
  held_.off_grid = rotated(start, Radians::of_degrees(degrees).radians()) - end;
  if (norm(held_.off_grid) <= kKlartextDrift) return;
  held_.off_grid = {};
  block("L" + coordinate(" X", step.to.x) + coordinate(" Y", step.to.y));
}

/// Too long comments continue in a separate block.
void KlartextWriter::comment(std::string_view text) {
  constexpr std::size_t kRoom = kLineLength - 12;
  for (const std::string& piece : comment_pieces(text, kRoom)) block("; " + piece);
}

std::string KlartextWriter::coordinate(std::string_view name, long long ticks) const {
  return std::string(name) + signed_number(ticks, rules_.grid.decimals());
}

std::string KlartextWriter::feed_text(MmPerMin feed) {
  const long long steps = klartext_feed(feed, options_.inch);
  if (steps == held_.feed) return "";
  held_.feed = steps;
  std::string text = " F";
  append_number(text, steps, kKlartextFeedDecimals, false);
  return text;
}

}  // namespace

long long klartext_feed(MmPerMin feed, bool inch) {
  return std::max(1LL, std::llround(feed.mm_per_min() * (inch ? 10 / kMmPerInch : 1) * 100));
}

std::string write_klartext(const Toolpath& toolpath, const Part& part, const PostOptions& options) {
  return KlartextWriter(part, options, safe_height(toolpath, part)).program(toolpath);
}

}  // namespace clearcut::post
