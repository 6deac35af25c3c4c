#include "read/gcode/motion/builder.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text.h"

namespace clearcut::read::gcode {

namespace {

/// mm; beyond any machine.
constexpr double kLargestCoordinate = 1e6;
/// Cycles, turns and repeats may write at most this many moves beyond a few for each line.
constexpr long long kMostExpandedMoves = 1'000'000;
constexpr long long kMovesPerLine = 8;
/// mm; by so much the radii at the ends of an arc differ where its words are rounded to a thousandth.
constexpr double kRoundedRadii = 1.5e-3;

MoveKind guessed_kind(const Move& move, bool rapid) {
  if (rapid) return MoveKind::kRapid;
  if (move.is_vertical()) return move.z_to < move.z_from ? MoveKind::kPlunge : MoveKind::kRetract;
  return move.z_to < move.z_from ? MoveKind::kRamp : MoveKind::kCut;
}

}  // namespace

ToolpathBuilder::ToolpathBuilder(BuilderSetup setup, Diagnostics& diagnostics,
                                 std::vector<Condition>& conditions)
    : setup_(std::move(setup)), diagnostics_(diagnostics), conditions_(conditions), highest_(setup_.home_z) {
  control_.spindle_said = control_.speed_said = false;
}

void ToolpathBuilder::begin_section(std::string label, int workingstep) {
  if (defers()) return defer(SectionStart{std::move(label), workingstep});
  label_ = std::move(label);
  workingstep_ = workingstep;
  new_section_ = true;
}

/// What has moved with the tool before keeps it; the next move begins a section of the new one. Rapids that come before a
/// change under the new section's name belong to the section before.
void ToolpathBuilder::change_tool(int number, bool by_hand, int line) {
  require_no_corner(line, "a change of the tool");
  if (compensated_)
    throw InputError(place(line),
                     "the tool is changed while cutter compensation is on; end it before (G40, R0)");
  auto& sections = toolpath_.sections;
  const bool other = number != drive.tool;
  if (other && !new_section_ && !section_cuts_ && sections.size() > 1) {
    auto& before = sections[sections.size() - 2].moves;
    before.insert(before.end(), sections.back().moves.begin(), sections.back().moves.end());
    sections.pop_back();
  }
  new_section_ = new_section_ || section_cuts_ || other;
  drive.tool = number;
  if (at_[2] && *at_[2] < setup_.safe_z) {
    condition("tool-change-height", line,
              "the tool is changed while the cutter is at Z " + trimmed(*at_[2], 3) +
                  " mm, below the top of the work; the way up and back is free");
  }
  add_event(by_hand ? ControlEventKind::kToolChangeByHand : ControlEventKind::kToolChange, line);
}

void ToolpathBuilder::add_event(ControlEventKind kind, int line, double seconds) {
  require_no_corner(line, "a stop, a dwell or a change of the spindle");
  const ControlEvent event{kind, static_cast<std::size_t>(moves_), line, seconds, drive.tool};
  if (defers()) return defer(event);
  control_.events.push_back(event);
}

void ToolpathBuilder::turn_tap_back(const TapCycle& tap, int line) {
  add_event(ControlEventKind::kTapTurnsBack, line);
  control_.events.back().tap = tap;
}

void ToolpathBuilder::set_spindle(int m, int line) {
  const bool turned = drive_turns_, clockwise = drive.clockwise;
  drive_turns_ = m != 5;
  if (m != 5) drive.clockwise = m == 3;
  if (!turned && drive_turns_) add_event(ControlEventKind::kSpindleStart, line);
  if (turned && drive_turns_ && clockwise != drive.clockwise)
    add_event(ControlEventKind::kSpindleStart, line);
  if (turned && !drive_turns_) add_event(ControlEventKind::kSpindleStop, line);
}

void ToolpathBuilder::say_units(bool inch, int line) {
  int& first = inch ? control_.inch_line : control_.mm_line;
  if (first == 0) first = line;
}

void ToolpathBuilder::rapid(const Target& target, int line) {
  straight(target, true, {}, line);
}

void ToolpathBuilder::feed(const Target& target, MmPerMin feed, int line) {
  straight(target, false, feed, line);
}

void ToolpathBuilder::arc(const ArcShape& shape, double z_to, MmPerMin feed, int line, double apart) {
  const std::vector<Edge> edges = arc_edges(shape);
  const double z_from = known(2, line);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const double t = static_cast<double>(k + 1) / static_cast<double>(edges.size());
    arc(edges[k], std::lerp(z_from, z_to, t), feed, line, apart);
  }
}

void ToolpathBuilder::arc(const Edge& path, double z_to, MmPerMin feed, int line, double apart) {
  Move move{path, known(2, line), z_to, MoveKind::kCut, feed, line};
  move.kind = guessed_kind(move, false);
  take(move, apart > kRoundedRadii ? apart - kRoundedRadii : 0);
  at_ = {path.to.x, path.to.y, z_to};
}

void ToolpathBuilder::lift_home(int line) {
  straight({std::nullopt, std::nullopt, std::max(highest_, at_[2].value_or(setup_.home_z))}, true, {}, line);
}

void ToolpathBuilder::leave_plan(const std::string& name) {
  away_ = name;
}

double ToolpathBuilder::known(std::size_t axis, int line) {
  if (!at_[axis]) {
    condition("start-position", line,
              std::string("cuts or counts from a place the program has not stated; ") + "XYZ"[axis] +
                  " is taken as " + (axis == 2 ? trimmed(setup_.home_z, 3) + " mm" : "0"));
    at_[axis] = axis == 2 ? setup_.home_z : 0;
  }
  return *at_[axis];
}

/// From a place of the machine the way back to the work is known only where a rapid says X and Y up there.
void ToolpathBuilder::check_return(const Target& target, bool rapid, int line) {
  if (away_.empty()) return;
  if (rapid && target[0] && target[1] && target[2].value_or(*at_[2]) >= *at_[2]) {
    away_.clear();
  } else if (!rapid || target[2].value_or(*at_[2]) < *at_[2]) {
    condition(away_, line, "goes down from a place of the machine that the program does not state");
    away_.clear();
  }
}

void ToolpathBuilder::check_start(const Target& target, int line) {
  const bool begins = (!at_[0] && target[0]) || (!at_[1] && target[1]);
  const double low = std::min(at_[2].value_or(HUGE_VAL), at_[2] ? target[2].value_or(HUGE_VAL) : HUGE_VAL);
  if (begins && low <= setup_.safe_z) {
    condition("start-position", line,
              "the first move in X and Y is at Z " + trimmed(low, 3) +
                  " mm and begins where the machine happens to stand");
  }
}

/// Rapids down before X and Y were stated happen above the first place, as far as anything is known.
void ToolpathBuilder::place_first_rapids(Vec2 place) {
  const std::vector<Unplaced> moves = std::move(unplaced_);
  unplaced_.clear();
  const bool low = std::any_of(moves.begin(), moves.end(),
                               [&](const Unplaced& move) { return move.z_to <= setup_.safe_z; });
  if (!low) return;
  for (const Unplaced& move : moves) {
    append({Edge::line(place, place), move.z_from, move.z_to, MoveKind::kRapid, {}, move.line});
  }
}

void ToolpathBuilder::straight(const Target& target, bool rapid, MmPerMin feed, int line) {
  for (const auto& value : target) {
    if (value && !(std::abs(*value) <= kLargestCoordinate)) {
      throw InputError(place(line), "coordinate beyond any machine; check the number and the units");
    }
  }
  if (at_[2]) check_return(target, rapid, line);
  check_start(target, line);
  Target from = at_;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (!from[axis]) from[axis] = target[axis];
  }
  if (!from[2] && target[2]) from[2] = std::max(setup_.home_z, *target[2]);
  at_ = from;
  const bool placed = from[0] && from[1];
  const bool moves_in_plan =
      placed && ((target[0] && target[0] != from[0]) || (target[1] && target[1] != from[1]));
  if (!rapid || moves_in_plan) {
    for (std::size_t axis = 0; axis < 3; ++axis) known(axis, line);
    from = at_;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (target[axis]) at_[axis] = target[axis];
  }
  if (at_[2]) highest_ = std::max(highest_, *at_[2]);
  if (!from[0] || !from[1] || !from[2]) {
    if (from[2] && *from[2] != *at_[2]) unplaced_.push_back({*from[2], *at_[2], line});
    return;
  }
  Move move{
      Edge::line({*from[0], *from[1]}, {*at_[0], *at_[1]}), *from[2], *at_[2], MoveKind::kCut, feed, line};
  const bool leaves = beside_ && !compensated_ && (exit_takes_height_ || target[0] || target[1]);
  if (leaves) move.path.from = *beside_;
  if (move.is_vertical() && move.z_from == move.z_to) return;
  move.kind = guessed_kind(move, rapid);
  take(move, 0);
}

void ToolpathBuilder::expect_corner(int line) {
  if (beside_)
    throw InputError(place(line),
                     "a corner is rounded or chamfered behind the end of cutter compensation, which is not "
                     "read; leave the contour first");
  expects_corner_ = true;
}

void ToolpathBuilder::round_corner(const Corner& corner) {
  expects_corner_ = false;
  if (!before_corner_ || corner_)
    throw InputError(place(corner.line),
                     "a corner is rounded or chamfered behind a block that cuts no line or arc; correct it");
  if (!(corner.size > 0 && corner.size <= kLargestCoordinate))
    throw InputError(place(corner.line), "a corner is rounded or chamfered by no size above 0; correct it");
  corner_ = corner;
}

/// A move as programmed.
void ToolpathBuilder::take(const Move& move, double apart) {
  if (before_corner_ || expects_corner_) return take_at_corner(move, apart);
  pass(move, apart);
}

/// One move waits at a time: the last of those that lead to a corner.
void ToolpathBuilder::take_at_corner(const Move& move, double apart) {
  std::optional<Move> rest = move;
  if (corner_)
    rest = pass_corner(move);
  else if (before_corner_)
    pass_as(before_corner_->state, before_corner_->move, before_corner_->apart);
  before_corner_.reset();
  if (!expects_corner_) {
    if (rest) pass(*rest, apart);
    return;
  }
  if (!rest)
    throw InputError(place(move.line), "a move between two corners is used up by the first; correct it");
  before_corner_ = BeforeCorner{*rest, apart, state()};
}

/// What leads to the corner and the corner itself; what it leaves of the move behind it is returned.
std::optional<Move> ToolpathBuilder::pass_corner(Move move) {
  const Corner corner = *corner_;
  const BeforeCorner waiting = *before_corner_;
  Move first = waiting.move;
  const bool is_level = first.z_from == first.z_to && first.z_to == move.z_from && move.z_from == move.z_to;
  if (is_rapid(move.kind) || is_rapid(first.kind) || move.is_vertical() || first.is_vertical() || !is_level)
    require_no_corner(move.line, "a move that is no level line or arc at a feed");
  corner_.reset();
  const auto joined = joined_corner(first.path, move.path, corner);
  if (!joined)
    throw InputError(
        place(corner.line),
        "the corner cannot be rounded or chamfered: both moves are in line, too short for it, or "
        "an arc has a chamfer; correct its size");
  if (joined->before) {
    first.path = *joined->before;
    pass_as(waiting.state, first, waiting.apart);
  }
  first.path = joined->between;
  first.feed = corner.feed ? *corner.feed : corner.feeds_as_next ? move.feed : first.feed;
  first.line = corner.line;
  pass_as(waiting.state, first, 0);
  if (!joined->after) return std::nullopt;
  move.path = *joined->after;
  return move;
}

void ToolpathBuilder::pass_as(const State& held, const Move& move, double apart) {
  const State now = state();
  use(held);
  pass(move, apart);
  use(now);
}

void ToolpathBuilder::require_no_corner(int line, const std::string& what) const {
  if (corner_)
    throw InputError(place(line), what + " stands at a corner that is rounded or chamfered (line " +
                                      std::to_string(corner_->line) +
                                      "), where a line or an arc has to follow");
}

/// On its way through what compensates. `apart`: mm between the radii of an arc beyond what rounding does.
void ToolpathBuilder::pass(Move move, double apart) {
  if (!compensated_ || compensated_->radius == 0) {
    leave_contour(move);
    if (move.is_vertical() && move.z_from == move.z_to) return;
    if (apart > 0) control_.arcs.push_back({static_cast<std::size_t>(moves_), apart});
    return append(move);
  }
  Compensated& now = *compensated_;
  if (!now.moves)
    now.moves.emplace(now.rules, now.side, now.radius, beside_.value_or(move.path.from), setup_.file_name);
  beside_.reset();
  defer(state());
  if (apart > 0) defer(apart);
  now.before.emplace_back();
  give(now.moves->add(move));
}

/// Behind the end of a compensation the centre is still beside the contour, up to the first move in plan.
void ToolpathBuilder::leave_contour(Move& move) {
  if (!beside_) return;
  if (move.path.is_arc())
    throw InputError(place(move.line), "cutter compensation ends with an arc; leave along a straight line");
  if (move.is_vertical() && !exit_takes_height_) {
    move.path = Edge::line(*beside_, *beside_);
    return;
  }
  beside_.reset();
}

void ToolpathBuilder::defer(const Deferred& what) {
  auto& before = compensated_->before;
  if (before.empty()) before.emplace_back();
  before.back().push_back(what);
}

void ToolpathBuilder::give(const std::vector<OffsetMove>& moves) {
  if (moves.empty()) return;
  const State now = state();
  std::size_t next = 0;
  auto& before = compensated_->before;
  for (const OffsetMove& offset : moves) {
    for (; next <= offset.from; ++next) {
      for (const Deferred& what : before[next]) bring(what);
      before[next].clear();
    }
    append(offset.move);
  }
  use(now);
}

void ToolpathBuilder::bring(const Deferred& what) {
  if (const auto* event = std::get_if<ControlEvent>(&what)) {
    control_.events.push_back(*event);
    control_.events.back().before_move = static_cast<std::size_t>(moves_);
  } else if (const auto* section = std::get_if<SectionStart>(&what)) {
    label_ = section->label;
    workingstep_ = section->workingstep;
    new_section_ = true;
  } else if (const auto* state = std::get_if<State>(&what)) {
    use(*state);
  } else {
    control_.arcs.push_back({static_cast<std::size_t>(moves_), std::get<double>(what)});
  }
}

void ToolpathBuilder::use(const State& state) {
  drive = state.drive;
  drive_turns_ = state.turns;
  speed = state.speed;
  length = state.length;
  path_control = state.path;
  calls_ = state.calls;
}

void ToolpathBuilder::begin_compensation(const CompensationRules& rules, CompensationSide side,
                                         double radius) {
  if (corner_) require_no_corner(corner_->line, "the beginning of cutter compensation");
  compensated_tools_.insert(drive.tool);
  compensated_ = Compensated{rules, side, radius, std::nullopt, {}};
}

void ToolpathBuilder::end_compensation() {
  if (!compensated_) return;
  if (corner_) require_no_corner(corner_->line, "the end of cutter compensation");
  if (!compensated_->moves) {
    compensated_.reset();
    return;
  }
  give(compensated_->moves->end());
  note_outside_corner();
  const State now = state();
  for (const auto& before : compensated_->before)
    for (const Deferred& what : before) bring(what);
  use(now);
  if (!compensated_->moves->begins()) beside_ = compensated_->moves->place();
  exit_takes_height_ = compensated_->rules.exit_takes_height;
  compensated_.reset();
}

void ToolpathBuilder::note_outside_corner() {
  const int line = compensated_->moves->outside_corner_line();
  if (line == 0 || compensated_->rules.outside_needs.empty()) return;
  condition("compensation-corners", line, std::string(compensated_->rules.outside_needs));
}

bool ToolpathBuilder::compensation_begins() const {
  return compensated_ && compensated_->radius > 0 && (!compensated_->moves || compensated_->moves->begins());
}

void ToolpathBuilder::require_nothing_open(int line) const {
  require_no_corner(line, "the end of the program");
  if (compensated_)
    throw InputError(place(line),
                     "the program ends while cutter compensation is on; end it before (G40, R0)");
}

void ToolpathBuilder::append(const Move& move) {
  if (!unplaced_.empty()) place_first_rapids(move.path.from);
  check_size(move.line);
  keep_control(move.line);
  section_for(move).moves.push_back(move);
  ++moves_;
}

void ToolpathBuilder::set_calls(const std::string& text) {
  if (text.empty()) {
    calls_ = -1;
    return;
  }
  const auto [found, is_new] = calls_known_.try_emplace(text, static_cast<int>(control_.call_texts.size()));
  if (is_new) control_.call_texts.push_back(text);
  calls_ = found->second;
}

void ToolpathBuilder::keep_control(int line) {
  auto& calls = control_.calls;
  if (calls.empty() ? calls_ >= 0 : calls.back().calls != calls_)
    calls.push_back({static_cast<std::size_t>(moves_), calls_});
  const SpindleState turning = drive.clockwise ? SpindleState::kClockwise : SpindleState::kCounterClockwise;
  const ControlState state{
      drive.tool, drive_turns_ ? turning : SpindleState::kOff, speed, drive.coolant, length, path_control};
  auto& spans = control_.spans;
  if (spans.empty() || spans.back().state != state) {
    spans.push_back({static_cast<std::size_t>(moves_), line, state});
  }
}

/// The tool, spindle and coolant of a section are those of its first feed move.
Section& ToolpathBuilder::section_for(const Move& move) {
  const bool cuts = !is_rapid(move.kind);
  auto& sections = toolpath_.sections;
  if (!new_section_ && cuts && section_cuts_) {
    const Section& now = sections.back();
    new_section_ = Drive{now.tool_number, now.spindle_rpm, now.spindle_clockwise, now.coolant} != drive;
  }
  if (new_section_) {
    sections.push_back({.label = label_, .workingstep = workingstep_, .moves = {}});
    new_section_ = section_cuts_ = false;
  }
  Section& section = sections.back();
  if (!section_cuts_) {
    section.tool_number = drive.tool;
    section.spindle_rpm = drive.spindle_rpm;
    section.spindle_clockwise = drive.clockwise;
    section.coolant = drive.coolant;
    section_cuts_ = cuts;
  }
  return section;
}

void ToolpathBuilder::check_size(int line) {
  if (moves_ >= kMostExpandedMoves + kMovesPerLine * line) {
    throw InputError(place(line), "cycles and repeats expand to over a million moves; shorten the program");
  }
}

void ToolpathBuilder::condition(const std::string& name, int line, const std::string& what) {
  const bool known = std::any_of(conditions_.begin(), conditions_.end(),
                                 [&](const Condition& one) { return one.name == name; });
  if (!known) conditions_.push_back({name, what, line});
}

void ToolpathBuilder::note(int line, const std::string& what) {
  if (said_.insert(what).second) diagnostics_.note(place(line), what);
}

void ToolpathBuilder::warn(int line, const std::string& what) {
  if (said_.insert(what).second) diagnostics_.warn(place(line), what);
}

}  // namespace clearcut::read::gcode
