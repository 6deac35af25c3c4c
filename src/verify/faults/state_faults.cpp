#include "verify/faults/state_faults.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <span>
#include <string>

#include "base/elementary.h"
#include "base/text.h"
#include "verify/engagement/tool_takes.h"
#include "verify/faults/faults.h"

namespace clearcut::verify {
namespace {

/// Share by which a feed or speed may exceed its limit, to allow for rounding to whole rpm and printed digits.
constexpr double kSpeedRounding = 1e-3;
/// mm, for heights rounded by the coarsest controller (0.0001 inch).
constexpr double kHeightSlack = 5.5e-3;

Place end_of(const CheckedMove& checked) {
  return {checked.move->path.to, checked.move->z_to, checked.move->line};
}

class StateCheck {
 public:
  StateCheck(const Part& part, const CheckedProgram& program, const VerifyOptions& options,
             const HandWorks& hands)
      : part_(part), options_(options), hands_(hands), first_(program.moves.data()) {
    find_short_waits(program);
    find_tapped(program);
  }

  std::optional<Fault> length(const CheckedMove& checked) const {
    if (!checked.control || !checked.works()) return std::nullopt;
    const ToolLength& length = checked.control->length;
    const std::string tool = "T" + std::to_string(checked.tool_number);
    const bool numbered = length.kind == LengthKind::kNumbered || length.kind == LengthKind::kOfTool;
    if (numbered && checked.tool_number > 0 && length.h != checked.tool_number) {
      const std::string h = std::to_string(length.h);
      if (length.kind == LengthKind::kOfTool && length.h == 0) return std::nullopt;
      if (accepted("tool-length-h" + h)) return std::nullopt;
      return fault(FaultKind::kToolLength, checked, 0,
                   tool + " cuts with the length H" + h + " of another tool (--accept tool-length-h" + h +
                       " where it holds this one's)");
    }
    const bool off = length.kind == LengthKind::kOff || length.kind == LengthKind::kUnstated;
    if (!off || !hands_.of(checked).lacks_length(checked) || accepted("tool-length-off")) return std::nullopt;
    return fault(FaultKind::kToolLength, checked, 0,
                 tool + (length.kind == LengthKind::kOff ? " cuts with its length taken back (G49)"
                                                         : " cuts without its length (G43)"));
  }

  std::optional<Fault> spindle(const CheckedMove& checked) const {
    if (!checked.control || !checked.works() || hands_.of(checked).switches_spindle()) return std::nullopt;
    if (checked.control->spindle == SpindleState::kOff)
      return fault(FaultKind::kSpindleOff, checked, 0,
                   "The spindle stands while the cutter feeds into material");
    if (checked.control->spindle_rpm <= 0 && !hands_.of(checked).sets_speed())
      return fault(FaultKind::kSpindleOff, checked, 0, "The spindle was started without a speed (S)");
    if (short_waits_.count(&checked) > 0)
      return fault(FaultKind::kSpindleOff, checked, 0,
                   "The spindle has had less than the " + trimmed(options_.machine.spindle_wait_s, 2) +
                       " s that the machine needs to start");
    return std::nullopt;
  }

  std::optional<Fault> direction(const CheckedMove& checked) const {
    // The direction of a tap is checked with its cycle.
    if (!checked.control || !checked.works() || checked.control->spindle == SpindleState::kOff ||
        checked.tool->kind == ToolKind::kTap)
      return std::nullopt;
    const bool clockwise = checked.control->spindle == SpindleState::kClockwise;
    if (may_turn(checked, clockwise)) return std::nullopt;
    return fault(FaultKind::kSpindleDirection, checked, 0,
                 std::string("The spindle turns ") + (clockwise ? "clockwise" : "counter-clockwise") +
                     " with a cutter made for the other way");
  }

  std::optional<Fault> speed(const CheckedMove& checked) const {
    if (!checked.control || !checked.works() || checked.control->spindle_rpm <= 0) return std::nullopt;
    const auto& of_machine = options_.machine.max_spindle_rpm;
    if (of_machine && is_beyond(checked, *of_machine))
      return too_fast(checked, "the machine has", *of_machine);
    const auto& least = options_.machine.min_spindle_rpm;
    if (least && checked.control->spindle_rpm < *least * (1 - kSpeedRounding))
      return fault(FaultKind::kSpindleSpeed, checked, 0,
                   "The spindle is asked for " + trimmed(checked.control->spindle_rpm, 0) +
                       " rpm where the machine turns no slower than " + trimmed(*least, 0));
    if (!checked.tool || !checked.tool->max_spindle_rpm) return std::nullopt;
    const double of_tool = *checked.tool->max_spindle_rpm;
    if (!is_beyond(checked, of_tool)) return std::nullopt;
    return too_fast(checked, "T" + std::to_string(checked.tool->number) + " may have", of_tool);
  }

  std::optional<Fault> fast_feed(const CheckedMove& checked) const {
    const auto& most = options_.machine.max_feed;
    const double feed = checked.move->feed.mm_per_min();
    if (!most || !checked.feeds() || feed <= most->mm_per_min() * (1 + kSpeedRounding)) return std::nullopt;
    return fault(FaultKind::kFeedTooFast, checked, feed,
                 "A feed of " + trimmed(feed, 0) + " mm/min is asked for where the machine has " +
                     trimmed(most->mm_per_min(), 0));
  }

  static bool is_beyond(const CheckedMove& checked, double most_rpm) {
    return checked.control->spindle_rpm > most_rpm * (1 + kSpeedRounding);
  }

  Fault too_fast(const CheckedMove& checked, const std::string& whose, double most_rpm) const {
    return fault(FaultKind::kSpindleSpeed, checked, 0,
                 "The spindle is asked for " + trimmed(checked.control->spindle_rpm, 0) + " rpm where " +
                     whose + " " + trimmed(most_rpm, 0));
  }

  std::optional<Fault> plunge(const CheckedMove& checked) const {
    const MoveLoad& load = checked.load;
    if (load.plunge_contact)
      return fault_of(part_, FaultKind::kPlungeTooFast, checked, *load.plunge_contact, checked.move->length(),
                      "A cutter that may not plunge goes straight down into material");
    if (!checked.cuts() || !checked.tool || checked.slope() <= 0) return std::nullopt;
    if (mills_down(*checked.tool) && !may_plunge(*checked.tool) &&
        checked.slope() > steepest_of(checked) * (1 + kSpeedRounding)) {
      return fault(FaultKind::kPlungeTooFast, checked, checked.move->length(),
                   "A cutter that may not plunge enters material at " +
                       trimmed(base::atan(checked.slope()) * 180 / kPi, 2) + " degrees");
    }
    return plunge_feed(checked);
  }

  std::optional<Fault> flutes(const CheckedMove& checked) const {
    if (!checked.cuts() || !checked.tool) return std::nullopt;
    if (!checked.tool->flute_length) return flanks(checked);
    // Their necks are narrower than their cutting parts; contact of a T-slot cutter's neck is checked separately.
    if (checked.tool->kind == ToolKind::kThreadMill || checked.tool->kind == ToolKind::kTSlot)
      return std::nullopt;
    const auto& wall = checked.load.wall_beyond_flutes;
    const double depth = std::max(checked.load.axial_mm, wall ? wall->height : 0);
    if (depth <= *checked.tool->flute_length + kHeightSlack) return std::nullopt;
    return fault(FaultKind::kBeyondFlutes, checked, depth,
                 "Cuts " + trimmed(depth, 3) + " mm deep with flutes of " +
                     trimmed(*checked.tool->flute_length, 3) + " mm");
  }

  /// V-bits and chamfer mills have edges on their flanks alone; spot drills have flutes above them, as drills have.
  std::optional<Fault> flanks(const CheckedMove& checked) const {
    const Tool& tool = *checked.tool;
    if (!is_conical(tool) || is_driven_down(tool)) return std::nullopt;
    const double depth = checked.load.axial_mm;
    if (depth <= flank_height(tool) + kHeightSlack) return std::nullopt;
    return fault(FaultKind::kBeyondFlutes, checked, depth,
                 "Cuts " + trimmed(depth, 3) + " mm deep with flanks that end " +
                     trimmed(flank_height(tool), 3) + " mm above the tip, where its shank begins");
  }

  std::optional<Fault> stock(const CheckedMove& checked) const {
    if (!part_.stock) return std::nullopt;
    if (!part_.is_shape_stated) return beyond_any_way_through(checked, part_.stock->z_bottom);
    double lowest = part_.stock->z_bottom;
    bool any_through = false;
    for (const Feature& feature : part_.features) {
      if (feature.through) lowest = std::min(lowest, feature.floor_z), any_through = true;
    }
    if (!checked.cuts()) return beyond_any_way_through(checked, lowest);
    if (any_through) lowest = std::min(lowest, part_.stock->z_bottom - breakthrough(checked));
    const double below = lowest - checked.low_z();
    if (below <= kHeightSlack) return std::nullopt;
    return beyond_stock(checked, below);
  }

  std::optional<Fault> tapping(const CheckedMove& checked) const {
    if (tapped_.count(&checked) == 0 || !checked.tool || checked.tool->kind == ToolKind::kTap)
      return std::nullopt;
    return fault(FaultKind::kTapping, checked, 0,
                 "T" + std::to_string(checked.tool->number) +
                     " is no tap, and the cycle turns it back at the bottom of the hole");
  }

  std::optional<Fault> engagement(const CheckedMove& checked) const {
    const auto limit = options_.engagement_limit_deg;
    if (!limit || checked.load.max_deg <= *limit + kFreeEngagementDeg) return std::nullopt;
    Fault found =
        fault_of(part_, FaultKind::kOverEngagement, checked, checked.load.max_at, checked.load.over_limit_mm,
                 "The cutter is engaged by " + trimmed(checked.load.max_deg, 1) + " degrees where " +
                     trimmed(*limit, 1) + " are the limit");
    found.cause =
        "the limit of engagement";  // clearing without regard to the limit exceeds it in many places
    return found;
  }

 private:
  /// Faults with the same text have one cause.
  Fault fault(FaultKind kind, const CheckedMove& checked, double size, const std::string& what) const {
    Fault found = fault_of(part_, kind, checked, end_of(checked), size, what);
    found.cause = what;
    return found;
  }

  bool accepted(const std::string& name) const {
    return std::find(options_.accepted.begin(), options_.accepted.end(), name) != options_.accepted.end();
  }

  /// If the through features are unknown, or no material is there: a rapid below the lowest through cut, or a feed
  /// move deeper below than a through cut needs.
  std::optional<Fault> beyond_any_way_through(const CheckedMove& checked, double lowest) const {
    const bool rises = !checked.feeds() && checked.move->z_to > checked.move->z_from;
    if (rises) return std::nullopt;
    const double below = lowest - checked.low_z();
    const double allowed = checked.feeds() ? breakthrough(checked) : 0;
    if (below <= allowed + kHeightSlack) return std::nullopt;
    return beyond_stock(checked, below);
  }

  /// mm; depth of a tool's tip below the stock in a through cut.
  static double breakthrough(const CheckedMove& checked) {
    return kUsualBreakthrough + (checked.tool ? point_length(*checked.tool) : 0);
  }

  Fault beyond_stock(const CheckedMove& checked, double below) const {
    Fault found = fault(FaultKind::kBeyondStock, checked, below,
                        (checked.feeds() ? "The cutter goes " : "A rapid goes ") + trimmed(below, 3) +
                            " mm below the bottom of the stock, into what it lies on");
    found.cause = kWrongStock;
    return found;
  }

  /// Finds first cuts that follow a start of the spindle sooner than the machine needs.
  void find_short_waits(const CheckedProgram& program) {
    const double needed = options_.machine.spindle_wait_s;
    if (!options_.control || needed <= 0) return;
    const auto own = std::find_if(program.moves.begin(), program.moves.end(),
                                  [](const CheckedMove& checked) { return !checked.earlier; });
    const auto& events = options_.control->events;
    for (std::size_t i = 0; i < events.size(); ++i) {
      if (events[i].kind != ControlEventKind::kSpindleStart) continue;
      if (static_cast<std::ptrdiff_t>(events[i].before_move) >= program.moves.end() - own) continue;
      const auto begin = own + static_cast<std::ptrdiff_t>(events[i].before_move);
      const auto cut = std::find_if(begin, program.moves.end(),
                                    [](const CheckedMove& checked) { return checked.works(); });
      if (cut == program.moves.end()) continue;
      double waited = 0;
      for (std::size_t k = i + 1; k < events.size(); ++k) {
        const bool before = events[k].before_move <= static_cast<std::size_t>(cut - own);
        if (before && events[k].kind == ControlEventKind::kDwell) waited += events[k].seconds;
      }
      if (waited < needed * (1 - kSpeedRounding)) short_waits_.insert(&*cut);
    }
  }

  /// Finds the moves at whose end a tapping cycle turns the spindle back.
  void find_tapped(const CheckedProgram& program) {
    if (!options_.control) return;
    const auto own = std::find_if(program.moves.begin(), program.moves.end(),
                                  [](const CheckedMove& checked) { return !checked.earlier; });
    for (const ControlEvent& event : options_.control->events) {
      const auto index = static_cast<std::ptrdiff_t>(event.before_move);
      if (event.kind == ControlEventKind::kTapTurnsBack && index > 0 && index <= program.moves.end() - own)
        tapped_.insert(&own[index - 1]);
    }
  }

  /// Whether the step works with the tool of the move.
  bool drives(const Workingstep& step, const CheckedMove& checked) const {
    const int index = step.operation.tool;
    return checked.tool && index >= 0 && index < static_cast<int>(part_.tools.size()) &&
           part_.tools[static_cast<std::size_t>(index)].number == checked.tool->number;
  }

  /// Whether some operation of the tool uses this direction; without operations, whether the tool itself does.
  bool may_turn(const CheckedMove& checked, bool clockwise) const {
    bool any = false;
    for (const Workingstep& step : part_.workplan) {
      if (!drives(step, checked)) continue;
      any = true;
      if (step.operation.cutting.spindle_clockwise == clockwise) return true;
    }
    if (any) return false;
    const auto limits =
        checked.tool ? options_.tool_limits.find(checked.tool->number) : options_.tool_limits.end();
    return clockwise == (limits == options_.tool_limits.end() || limits->second.is_clockwise);
  }

  /// Whether the tool itself states its permitted descent; for others their kind does.
  bool mills_down(const Tool& tool) const { return std::isinf(takes_of(tool, part_).down); }

  /// Tangent of the steepest entry angle stated by an operation of the tool, at least the default.
  double steepest_of(const CheckedMove& checked) const {
    double steepest = kSteepestEntry;
    for (const Workingstep& step : part_.workplan) {
      if (step.operation.entry_angle && drives(step, checked))
        steepest = std::max(steepest, base::tan(step.operation.entry_angle->radians()));
    }
    return steepest;
  }

  /// mm/min; the highest plunge feed stated for the tool or for an operation with it.
  std::optional<double> plunge_feed_of(const CheckedMove& checked) const {
    std::optional<double> most;
    const auto limits = options_.tool_limits.find(checked.tool->number);
    if (limits != options_.tool_limits.end() && limits->second.plunge_feed)
      most = limits->second.plunge_feed->mm_per_min();
    for (const Workingstep& step : part_.workplan) {
      const auto& feed = step.operation.cutting.plunge_feed;
      if (!feed || !drives(step, checked)) continue;
      most = std::max(most.value_or(0), feed->mm_per_min());
    }
    return most;
  }

  /// mm down for each mm of advance; for moves so short that the digits of heights decide it, together with the
  /// previous move.
  double judged_slope(const CheckedMove& checked) const {
    constexpr double kShort = 0.05;  // mm
    const double own = checked.slope(), length = checked.move->path.length();
    if (checked.move->is_vertical() || length >= kShort || &checked == first_) return own;
    const Move& before = *(&checked - 1)->move;
    if (is_rapid(before.kind) || before.path.to != checked.move->path.from ||
        before.z_to != checked.move->z_from)
      return own;
    return std::min(own, std::max(0.0, before.z_from - checked.move->z_to) / (length + before.path.length()));
  }

  std::optional<Fault> plunge_feed(const CheckedMove& checked) const {
    // Holes are made at the cutting feed; the feed of a tap is checked in holes.cpp, against its speed. Thread mills
    // descend along their thread.
    if (makes_holes(*checked.tool) || checked.tool->kind == ToolKind::kTap ||
        (checked.tool->kind == ToolKind::kThreadMill && !checked.move->is_vertical()))
      return std::nullopt;
    const auto most = plunge_feed_of(checked);
    const double slope = judged_slope(checked), feed = checked.move->feed.mm_per_min();
    const double down = std::isinf(slope) ? feed : feed * slope / base::hypot(1, slope);
    if (!most || down <= *most * (1 + kSpeedRounding) + 0.01) return std::nullopt;
    return fault(FaultKind::kPlungeTooFast, checked, checked.move->length(),
                 "Goes down into material at " + trimmed(down, 1) +
                     " mm/min where the tool's plunge feed is " + trimmed(*most, 1));
  }

  const Part& part_;
  const VerifyOptions& options_;
  const HandWorks& hands_;
  const CheckedMove* first_;  ///< first move of the program; the moves are contiguous
  std::set<const CheckedMove*> short_waits_;
  std::set<const CheckedMove*> tapped_;
};

}  // namespace

HandWorks::HandWorks(const CheckedProgram& program, const VerifyOptions& options) {
  const auto begin = std::find_if(program.moves.begin(), program.moves.end(),
                                  [](const CheckedMove& checked) { return !checked.earlier; });
  const auto before = static_cast<std::size_t>(begin - program.moves.begin());
  const std::span<const CheckedMove> moves(program.moves);
  own = HandWork(moves.subspan(before), options.control, options);
  earlier = HandWork(moves.first(before), options.earlier_control, options);
}

std::vector<Condition> HandWorks::conditions() const {
  std::vector<Condition> all = own.conditions();
  for (Condition& one : earlier.conditions()) {
    one.text = "in the program before: " + one.text;
    one.line = 0;
    all.push_back(std::move(one));
  }
  return all;
}

std::vector<MoveCheck> state_checks(const Part& part, const CheckedProgram& program,
                                    const VerifyOptions& options, const HandWorks& hands) {
  const auto check = std::make_shared<const StateCheck>(part, program, options, hands);
  using Rule = std::optional<Fault> (StateCheck::*)(const CheckedMove&) const;
  std::vector<MoveCheck> checks;
  for (const Rule rule :
       {&StateCheck::length, &StateCheck::spindle, &StateCheck::direction, &StateCheck::speed,
        &StateCheck::fast_feed, &StateCheck::plunge, &StateCheck::flutes, &StateCheck::stock,
        &StateCheck::tapping, &StateCheck::engagement}) {
    checks.push_back([check, rule](const CheckedMove& checked) { return (check.get()->*rule)(checked); });
  }
  return checks;
}

}  // namespace clearcut::verify
