#include "kinematics/planner.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "base/tolerances.h"
#include "kinematics/families.h"

namespace clearcut::kinematics {
namespace {

/// In the order of MotionPlanner.
constexpr std::array<PlanFamily, 5> kFamilies{plan_grbl, plan_linuxcnc, plan_marlin, plan_mach,
                                              plan_jerk_limited};

}  // namespace

MotionPlanner planner_in_force(const Machine& machine, std::optional<MotionPlanner> of_control) {
  return machine.planner ? *machine.planner : of_control.value_or(MotionPlanner::kGrbl);
}

std::vector<Seconds> planned_times(std::span<const PlannedMove> moves, const Machine& machine,
                                   std::optional<MotionPlanner> of_control) {
  CLEARCUT_ASSERT(machine.acceleration > 0 && machine.rapid.mm_per_min() > 0);
  std::vector<Seconds> times(moves.size());
  kFamilies[static_cast<std::size_t>(planner_in_force(machine, of_control))](legs_of(moves, machine), machine,
                                                                             times);
  return times;
}

Seconds planned_time(std::span<const Move> moves, const PathControl& path, const Machine& machine,
                     std::optional<MotionPlanner> of_control) {
  std::vector<PlannedMove> planned;
  planned.reserve(moves.size());
  for (const Move& move : moves) planned.push_back({&move, path, planned.empty()});
  Seconds sum;
  for (const Seconds time : planned_times(planned, machine, of_control)) sum = sum + time;
  return sum;
}

namespace {

bool is_continued(const Move& before, const Move& after) {
  return distance(before.path.to, after.path.from) <= kSamePlaceMm &&
         std::abs(before.z_to - after.z_from) <= kSamePlaceMm;
}

/// Whether the control empties its queue of moves if `after` follows `before`.
bool needs_standstill(const ControlState& before, const ControlState& after) {
  return before.tool != after.tool || before.spindle != after.spindle ||
         before.spindle_rpm != after.spindle_rpm || before.coolant != after.coolant ||
         before.length != after.length;
}

/// Marks the moves preceded by an event that needs standstill.
void mark_standstills(const ControlTable& control, std::vector<PlannedMove>& moves) {
  for (const ControlEvent& event : control.events) {
    if (event.before_move < moves.size()) moves[event.before_move].from_rest = true;
  }
  for (std::size_t i = 1; i < control.spans.size(); ++i) {
    const ControlSpan& span = control.spans[i];
    if (span.first_move < moves.size() && needs_standstill(control.spans[i - 1].state, span.state))
      moves[span.first_move].from_rest = true;
  }
}

void set_paths(const ControlTable& control, std::vector<PlannedMove>& moves) {
  for (std::size_t i = 0; i < control.spans.size(); ++i) {
    const std::size_t end = i + 1 < control.spans.size() ? control.spans[i + 1].first_move : moves.size();
    for (std::size_t k = control.spans[i].first_move; k < std::min(end, moves.size()); ++k)
      moves[k].path = control.spans[i].state.path;
  }
}

}  // namespace

std::vector<PlannedMove> planned_moves(const Toolpath& toolpath, const ControlTable* control) {
  std::vector<PlannedMove> moves;
  for (const Section& section : toolpath.sections) {
    bool first = true;
    for (const Move& move : section.moves) {
      const bool apart = moves.empty() || !is_continued(*moves.back().move, move);
      moves.push_back({&move, {}, apart || (first && control == nullptr)});
      first = false;
    }
  }
  if (control == nullptr) return moves;
  set_paths(*control, moves);
  mark_standstills(*control, moves);
  return moves;
}

}  // namespace clearcut::kinematics
