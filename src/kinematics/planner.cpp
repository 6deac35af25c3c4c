#include "kinematics/planner.h"

#include <array>

#include "base/error.h"
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

}  // namespace clearcut::kinematics
