#include "verify/faults/state_faults.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string>

#include "base/text/format.h"
#include "verify/faults/faults.h"

namespace clearcut::verify {
namespace {

/// Share by which a feed or speed may exceed its limit, for rounding to whole rpm and to printed feeds.
constexpr double kSpeedRounding = 1e-3;
/// mm, for heights rounded by the coarsest controller (0.0001 inch).
constexpr double kHeightSlack = 5.5e-3;
/// Tangent of 45 degrees: steeper moves count as plunges.
constexpr double kPlungeSlope = 1;
/// Degrees by which the engagement may exceed its limit: arcs fitted to a path of constant engagement swing about it by more
/// than one degree, and the distance of the samples may hide half a degree.
constexpr double kDegreeSlack = 2;

Place end_of(const JudgedMove& judged) {
  return {judged.move->path.to, judged.move->z_to, judged.move->line};
}

class StateJudge {
 public:
  StateJudge(const Part& part, const JudgedProgram& program, const VerifyOptions& options)
      : part_(part), options_(options), changed_by_changer_(changer_tools(options)) {
    find_lengths(program);
    find_short_waits(program);
  }

  std::optional<Fault> length(const JudgedMove& judged) const {
    if (!judged.control || !judged.cuts()) return std::nullopt;
    const ToolLength& length = judged.control->length;
    const std::string tool = "T" + std::to_string(judged.tool_number);
    const bool numbered = length.kind == LengthKind::kNumbered || length.kind == LengthKind::kOfTool;
    if (numbered && judged.tool_number > 0 && length.h != judged.tool_number) {
      const std::string h = std::to_string(length.h);
      if (length.kind == LengthKind::kOfTool && length.h == 0) return std::nullopt;
      if (accepted("tool-length-h" + h)) return std::nullopt;
      return fault(FaultKind::kToolLength, judged, 0,
                   tool + " cuts with the length H" + h + " of another tool");
    }
    const bool off = length.kind == LengthKind::kOff || length.kind == LengthKind::kUnstated;
    if (!off || !length_needed(judged) || accepted("tool-length-off")) return std::nullopt;
    return fault(FaultKind::kToolLength, judged, 0,
                 tool + (length.kind == LengthKind::kOff ? " cuts with its length taken back (G49)"
                                                         : " cuts without its length (G43)"));
  }

  std::optional<Fault> spindle(const JudgedMove& judged) const {
    if (!judged.control || !judged.cuts()) return std::nullopt;
    if (judged.control->spindle == SpindleState::kOff)
      return fault(FaultKind::kSpindleOff, judged, judged.move->length(),
                   "The spindle stands while the cutter feeds into material");
    if (judged.control->spindle_rpm <= 0)
      return fault(FaultKind::kSpindleOff, judged, judged.move->length(),
                   "The spindle was started without a speed (S)");
    if (short_waits_.count(&judged) > 0)
      return fault(FaultKind::kSpindleOff, judged, judged.move->length(),
                   "The spindle has had less than the " + trimmed(options_.machine.spindle_wait_s, 2) +
                       " s that the machine needs to start");
    return std::nullopt;
  }

  std::optional<Fault> direction(const JudgedMove& judged) const {
    if (!judged.control || !judged.cuts() || judged.control->spindle == SpindleState::kOff)
      return std::nullopt;
    const bool clockwise = judged.control->spindle == SpindleState::kClockwise;
    if (may_turn(judged, clockwise)) return std::nullopt;
    return fault(FaultKind::kSpindleDirection, judged, 0,
                 std::string("The spindle turns ") + (clockwise ? "clockwise" : "counter-clockwise") +
                     " with a cutter made for the other way");
  }

  std::optional<Fault> speed(const JudgedMove& judged) const {
    if (!judged.control || !judged.cuts()) return std::nullopt;
    const auto& of_machine = options_.machine.max_spindle_rpm;
    if (of_machine && is_beyond(judged, *of_machine)) return too_fast(judged, "the machine has", *of_machine);
    if (!judged.tool || !judged.tool->max_spindle_rpm) return std::nullopt;
    const double of_tool = *judged.tool->max_spindle_rpm;
    if (!is_beyond(judged, of_tool)) return std::nullopt;
    return too_fast(judged, "T" + std::to_string(judged.tool->number) + " may have", of_tool);
  }

  static bool is_beyond(const JudgedMove& judged, double most_rpm) {
    return judged.control->spindle_rpm > most_rpm * (1 + kSpeedRounding);
  }

  Fault too_fast(const JudgedMove& judged, const std::string& whose, double most_rpm) const {
    return fault(FaultKind::kSpindleSpeed, judged, 0,
                 "The spindle is asked for " + trimmed(judged.control->spindle_rpm, 0) + " rpm where " +
                     whose + " " + trimmed(most_rpm, 0));
  }

  std::optional<Fault> plunge(const JudgedMove& judged) const {
    const MoveLoad& load = judged.load;
    if (load.plunge_contact)
      return fault_of(part_, FaultKind::kPlungeTooFast, judged, *load.plunge_contact, judged.move->length(),
                      "A cutter that may not plunge goes straight down into material");
    if (!judged.cuts() || !judged.tool || judged.slope() <= 0) return std::nullopt;
    if (!judged.tool->center_cutting && judged.slope() > steepest_of(judged) * (1 + kSpeedRounding)) {
      return fault(FaultKind::kPlungeTooFast, judged, judged.move->length(),
                   "A cutter that may not plunge enters material at " +
                       trimmed(std::atan(judged.slope()) * 180 / kPi, 2) + " degrees");
    }
    return plunge_feed(judged);
  }

  std::optional<Fault> flutes(const JudgedMove& judged) const {
    if (!judged.cuts() || !judged.tool || !judged.tool->flute_length) return std::nullopt;
    if (judged.tool->kind == ToolKind::kThreadMill)
      return std::nullopt;  // its neck is narrower than its teeth
    const double depth = std::max(judged.load.axial_mm, part_.top_z() - judged.low_z());
    if (depth <= *judged.tool->flute_length + kHeightSlack) return std::nullopt;
    return fault(FaultKind::kBeyondFlutes, judged, depth,
                 "Cuts " + trimmed(depth, 3) + " mm deep with flutes of " +
                     trimmed(*judged.tool->flute_length, 3) + " mm");
  }

  std::optional<Fault> stock(const JudgedMove& judged) const {
    if (!part_.is_shape_stated) return beyond_any_way_through(judged);
    if (!part_.stock || !judged.feeds()) return std::nullopt;
    double lowest = part_.stock->z_bottom;
    for (const Feature& feature : part_.features) {
      if (feature.through) lowest = std::min(lowest, feature.floor_z);
    }
    const double below = lowest - judged.low_z();
    if (below <= kHeightSlack || !judged.cuts()) return std::nullopt;
    return fault(
        FaultKind::kBeyondStock, judged, below,
        "The cutter goes " + trimmed(below, 3) + " mm below the bottom of the stock, into what it lies on");
  }

  std::optional<Fault> engagement(const JudgedMove& judged) const {
    const auto limit = options_.engagement_limit_deg;
    if (!limit || judged.load.max_deg <= *limit + kDegreeSlack) return std::nullopt;
    return fault_of(part_, FaultKind::kOverEngagement, judged, judged.load.max_at, judged.load.over_limit_mm,
                    "The cutter is engaged by " + trimmed(judged.load.max_deg, 1) + " degrees where " +
                        trimmed(*limit, 1) + " are the limit");
  }

 private:
  Fault fault(FaultKind kind, const JudgedMove& judged, double size, const std::string& what) const {
    return fault_of(part_, kind, judged, end_of(judged), size, what);
  }

  bool accepted(const std::string& name) const {
    return std::find(options_.accepted.begin(), options_.accepted.end(), name) != options_.accepted.end();
  }

  /// Where nothing says what goes through: a rapid below the stock, or more than a way through needs.
  std::optional<Fault> beyond_any_way_through(const JudgedMove& judged) const {
    const bool rises = !judged.feeds() && judged.move->z_to > judged.move->z_from;
    if (!part_.stock || rises) return std::nullopt;
    const double below = part_.stock->z_bottom - judged.low_z();
    const double allowed =
        !judged.feeds() ? 0 : kUsualBreakthrough + (judged.tool ? point_length(*judged.tool) : 0);
    if (below <= allowed + kHeightSlack) return std::nullopt;
    return fault(FaultKind::kBeyondStock, judged, below,
                 (judged.feeds() ? "The cutter goes " : "A rapid goes ") + trimmed(below, 3) +
                     " mm below the bottom of the stock, into what it lies on");
  }

  /// The tools that a changer puts in, whose length nobody can measure in the spindle.
  static std::set<int> changer_tools(const VerifyOptions& options) {
    std::set<int> tools;
    if (!options.control) return tools;
    for (const ControlEvent& event : options.control->events) {
      if (event.kind == ControlEventKind::kToolChange) tools.insert(event.tool);
    }
    return tools;
  }

  /// Finds the first move with a tool length; from it on, cutting without one is a fault.
  void find_lengths(const JudgedProgram& program) {
    for (const JudgedMove& judged : program.moves) {
      if (!judged.control) continue;
      const LengthKind kind = judged.control->length.kind;
      if (first_with_length_ == nullptr && kind != LengthKind::kOff && kind != LengthKind::kUnstated)
        first_with_length_ = &judged;
    }
  }

  bool length_needed(const JudgedMove& judged) const {
    if (first_with_length_ != nullptr && &judged >= first_with_length_) return true;
    return options_.needs_tool_length ? !changed_by_changer_.empty() : changed_by_changer_.size() > 1;
  }

  /// Finds the first cuts after starts of the spindle that come sooner than the machine needs.
  void find_short_waits(const JudgedProgram& program) {
    const double needed = options_.machine.spindle_wait_s;
    if (!options_.control || needed <= 0) return;
    const auto own = std::find_if(program.moves.begin(), program.moves.end(),
                                  [](const JudgedMove& judged) { return !judged.earlier; });
    const auto& events = options_.control->events;
    for (std::size_t i = 0; i < events.size(); ++i) {
      if (events[i].kind != ControlEventKind::kSpindleStart) continue;
      if (static_cast<std::ptrdiff_t>(events[i].before_move) >= program.moves.end() - own) continue;
      const auto begin = own + static_cast<std::ptrdiff_t>(events[i].before_move);
      const auto cut =
          std::find_if(begin, program.moves.end(), [](const JudgedMove& judged) { return judged.cuts(); });
      if (cut == program.moves.end()) continue;
      double waited = 0;
      for (std::size_t k = i + 1; k < events.size(); ++k) {
        const bool before = events[k].before_move <= static_cast<std::size_t>(cut - own);
        if (before && events[k].kind == ControlEventKind::kDwell) waited += events[k].seconds;
      }
      if (waited < needed * (1 - kSpeedRounding)) short_waits_.insert(&*cut);
    }
  }

  /// Whether the step works with the tool of the move.
  bool drives(const Workingstep& step, const JudgedMove& judged) const {
    const int index = step.operation.tool;
    return judged.tool && index >= 0 && index < static_cast<int>(part_.tools.size()) &&
           part_.tools[static_cast<std::size_t>(index)].number == judged.tool->number;
  }

  /// Whether some operation of the tool turns this way; where it has none, whether the tool itself does.
  bool may_turn(const JudgedMove& judged, bool clockwise) const {
    bool any = false;
    for (const Workingstep& step : part_.workplan) {
      if (!drives(step, judged)) continue;
      any = true;
      if (step.operation.cutting.spindle_clockwise == clockwise) return true;
    }
    if (any) return false;
    const auto limits =
        judged.tool ? options_.tool_limits.find(judged.tool->number) : options_.tool_limits.end();
    return clockwise == (limits == options_.tool_limits.end() || limits->second.is_clockwise);
  }

  /// Tangent of the steepest entry angle that an operation of the tool states, at least the default.
  double steepest_of(const JudgedMove& judged) const {
    double steepest = kSteepestEntry;
    for (const Workingstep& step : part_.workplan) {
      if (step.operation.entry_angle && drives(step, judged))
        steepest = std::max(steepest, std::tan(step.operation.entry_angle->radians()));
    }
    return steepest;
  }

  /// mm/min; the highest plunge feed that is stated for the tool or for an operation with it.
  std::optional<double> plunge_feed_of(const JudgedMove& judged) const {
    std::optional<double> most;
    const auto limits = options_.tool_limits.find(judged.tool->number);
    if (limits != options_.tool_limits.end() && limits->second.plunge_feed)
      most = limits->second.plunge_feed->mm_per_min();
    for (const Workingstep& step : part_.workplan) {
      const auto& feed = step.operation.cutting.plunge_feed;
      if (!feed || !drives(step, judged)) continue;
      most = std::max(most.value_or(0), feed->mm_per_min());
    }
    return most;
  }

  std::optional<Fault> plunge_feed(const JudgedMove& judged) const {
    // Holes are made at the cutting feed; that of a tap is checked in holes.cpp, against its speed.
    if (makes_holes(*judged.tool) || judged.tool->kind == ToolKind::kTap || judged.slope() < kPlungeSlope)
      return std::nullopt;
    const auto most = plunge_feed_of(judged);
    const double slope = judged.slope(), feed = judged.move->feed.mm_per_min();
    const double down = std::isinf(slope) ? feed : feed * slope / std::hypot(1, slope);
    if (!most || down <= *most * (1 + kSpeedRounding) + 0.01) return std::nullopt;
    return fault(FaultKind::kPlungeTooFast, judged, judged.move->length(),
                 "Goes down into material at " + trimmed(down, 1) +
                     " mm/min where the tool's plunge feed is " + trimmed(*most, 1));
  }

  const Part& part_;
  const VerifyOptions& options_;
  std::set<int> changed_by_changer_;
  const JudgedMove* first_with_length_ = nullptr;
  std::set<const JudgedMove*> short_waits_;
};

}  // namespace

std::vector<MoveJudge> state_judges(const Part& part, const JudgedProgram& program,
                                    const VerifyOptions& options) {
  const auto judge = std::make_shared<const StateJudge>(part, program, options);
  using Rule = std::optional<Fault> (StateJudge::*)(const JudgedMove&) const;
  std::vector<MoveJudge> judges;
  for (const Rule rule :
       {&StateJudge::length, &StateJudge::spindle, &StateJudge::direction, &StateJudge::speed,
        &StateJudge::plunge, &StateJudge::flutes, &StateJudge::stock, &StateJudge::engagement}) {
    judges.push_back([judge, rule](const JudgedMove& judged) { return (judge.get()->*rule)(judged); });
  }
  return judges;
}

}  // namespace clearcut::verify
