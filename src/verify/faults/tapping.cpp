#include "verify/faults/tapping.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>

#include "base/text/format.h"
#include "verify/faults/faults.h"

namespace clearcut::verify {
namespace {

/// Permitted relative difference of a tap's feed from its pitch times the speed.
constexpr double kTapFeedShare = 0.005;
/// mm; rounding of heights.
constexpr double kTapHeight = 1e-3;

/// The cycles with reversal of taps, by the move at whose end the reversal is.
std::map<const CheckedMove*, TapCycle> tap_cycles(const CheckedProgram& program,
                                                  const VerifyOptions& options) {
  std::map<const CheckedMove*, TapCycle> cycles;
  if (!options.control) return cycles;
  const auto own = std::find_if(program.moves.begin(), program.moves.end(),
                                [](const CheckedMove& checked) { return !checked.earlier; });
  for (const ControlEvent& event : options.control->events) {
    const auto index = static_cast<std::ptrdiff_t>(event.before_move);
    if (event.kind == ControlEventKind::kTapTurnsBack && index > 0 && index <= program.moves.end() - own)
      cycles[&own[index - 1]] = event.tap;
  }
  return cycles;
}

bool is_tap_move(const CheckedMove& checked) {
  return !checked.earlier && checked.tool && checked.tool->kind == ToolKind::kTap && checked.feeds() &&
         checked.move->is_vertical();
}

bool goes_in(const CheckedMove& checked) {
  return checked.move->z_to < checked.move->z_from;
}

const char* way_of(SpindleState spindle) {
  return spindle == SpindleState::kClockwise          ? "clockwise"
         : spindle == SpindleState::kCounterClockwise ? "counter-clockwise"
                                                      : "not at all";
}

class TapCheck {
 public:
  TapCheck(const Part& part, const CheckedProgram& program, const VerifyOptions& options)
      : part_(part),
        program_(program),
        cycles_(tap_cycles(program, options)),
        has_control_(options.control) {}

  std::optional<Fault> feed(const CheckedMove& checked) const {
    if (!is_asked(checked)) return std::nullopt;
    const double rpm = checked.control ? checked.control->spindle_rpm : checked.rpm;
    const double wanted = checked.tool->pitch * rpm, feed = checked.move->feed.mm_per_min();
    if (std::abs(feed - wanted) <= kTapFeedShare * wanted) return std::nullopt;
    return fault(checked, std::abs(feed - wanted) / std::max(1.0, rpm),
                 "the tap feeds " + trimmed(feed, 2) + " mm/min where its pitch of " +
                     trimmed(checked.tool->pitch, 4) + " mm at " + trimmed(rpm, 0) + " rpm asks for " +
                     trimmed(wanted, 2));
  }

  std::optional<Fault> turn(const CheckedMove& checked) const {
    if (!is_asked(checked) || !checked.control) return std::nullopt;
    return goes_in(checked) ? turn_in(checked) : turn_out(checked);
  }

  std::optional<Fault> way_out(const CheckedMove& checked) const {
    if (!is_asked(checked) || !goes_in(checked)) return std::nullopt;
    const CheckedMove* next = &checked == &program_.moves.back() ? nullptr : &checked + 1;
    const double top = std::min(checked.move->z_from, top_at(checked));
    if (next && next->feeds() && next->move->is_vertical() && next->move->z_to >= top - kTapHeight)
      return std::nullopt;
    return fault(checked, 0, "the tap does not come out at its feed right after it went in");
  }

 private:
  bool is_asked(const CheckedMove& checked) const {
    return is_tap_move(checked) && checked.low_z() < top_at(checked);
  }

  /// mm; top of the feature being tapped.
  double top_at(const CheckedMove& checked) const {
    const auto step = static_cast<std::size_t>(checked.workingstep);
    return checked.workingstep < 0 ? part_.top_z() : feature_of(part_, part_.workplan[step]).top_z;
  }

  static SpindleState cutting_way(const Tool& tap) {
    return tap.left_hand ? SpindleState::kCounterClockwise : SpindleState::kClockwise;
  }

  std::optional<Fault> turn_in(const CheckedMove& checked) const {
    const SpindleState needed = cutting_way(*checked.tool), stated = checked.control->spindle;
    const auto cycle = cycles_.find(&checked);
    if (cycle == cycles_.end() || !cycle->second.left_hand)
      return stated == needed ? std::nullopt : wrong_way(checked);
    const bool cuts_left = *cycle->second.left_hand;
    if (cuts_left != checked.tool->left_hand)
      return fault(checked, 0,
                   std::string("the cycle is for ") + (cuts_left ? "left" : "right") + "-hand taps, and T" +
                       std::to_string(checked.tool_number) + " is a " + (cuts_left ? "right" : "left") +
                       "-hand one");
    const bool may_stand = cycle->second.turns_by_itself && stated == SpindleState::kOff;
    if (may_stand || stated == needed) return std::nullopt;
    return fault(checked, 0,
                 std::string("the spindle turns ") + way_of(stated) + " before a cycle that asks for " +
                     way_of(needed) + ": the control stops, or the tap breaks");
  }

  std::optional<Fault> turn_out(const CheckedMove& checked) const {
    const bool by_cycle = &checked != program_.moves.data() && cycles_.count(&checked - 1) > 0;
    const SpindleState spindle = checked.control->spindle, in = cutting_way(*checked.tool);
    if (!has_control_ || by_cycle || (spindle != in && spindle != SpindleState::kOff)) return std::nullopt;
    return fault(checked, 0, "the tap comes out while the spindle still turns as on its way in");
  }

  std::optional<Fault> wrong_way(const CheckedMove& checked) const {
    return fault(checked, 0, "the spindle does not turn the way that this tap cuts");
  }

  Fault fault(const CheckedMove& checked, double size, const std::string& what) const {
    return fault_of(part_, FaultKind::kTapping, checked,
                    {checked.move->path.to, checked.move->z_to, checked.move->line}, size, what);
  }

  const Part& part_;
  const CheckedProgram& program_;
  std::map<const CheckedMove*, TapCycle> cycles_;
  bool has_control_;
};

}  // namespace

std::vector<MoveCheck> tapping_checks(const Part& part, const CheckedProgram& program,
                                      const VerifyOptions& options) {
  const auto check = std::make_shared<const TapCheck>(part, program, options);
  return {[check](const CheckedMove& one) { return check->feed(one); },
          [check](const CheckedMove& one) { return check->turn(one); },
          [check](const CheckedMove& one) { return check->way_out(one); }};
}

std::vector<Condition> conditions_of_taps(const CheckedProgram& program, const VerifyOptions& options) {
  if (!options.control) return {};
  const std::map<const CheckedMove*, TapCycle> cycles = tap_cycles(program, options);
  for (const CheckedMove& checked : program.moves) {
    if (!is_tap_move(checked) || !goes_in(checked) || checked.tool->floating || !checked.cuts()) continue;
    const auto cycle = cycles.find(&checked);
    if (cycle != cycles.end() && cycle->second.is_tied) continue;
    return {{"rigid-tap",
             "T" + std::to_string(checked.tool_number) +
                 " is a rigid tap, and nothing ties its feed to the spindle; its holder floats",
             checked.move->line}};
  }
  return {};
}

}  // namespace clearcut::verify
