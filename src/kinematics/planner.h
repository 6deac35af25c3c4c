// Time of a program on a machine: one planner for each family of controllers, each by its controller's own rules,
// over the moves of a program in one row.
#pragma once

#include <span>
#include <vector>

#include "base/units.h"
#include "model/control.h"
#include "model/machine.h"
#include "model/move.h"

namespace clearcut::kinematics {

/// A move as input of a control's planner.
struct PlannedMove {
  const Move* move = nullptr;
  PathControl path;  ///< permitted deviation of the control from the path, from this move on
  /// The control waits for standstill before this move: start, dwell, tool change, words of M.
  bool from_rest = false;
};

/// Time of each of the moves, run in this order from rest to rest, as the controller plans them.
///
/// Planner `machine.planner`, or `of_control` if the machine states none; kGrbl if neither is stated.
/// Error   LinuxCNC: 1 % at the median and 3 % at most of its own planner; docs/machine-time.md has the rules of
///         all planners, with sources.
/// Cost    O(n) for n moves; arcs count as their chords if the controller cuts them into chords.
std::vector<Seconds> planned_times(std::span<const PlannedMove> moves, const Machine& machine,
                                   std::optional<MotionPlanner> of_control = {});

/// Sum of planned_times for moves run without a stop, all under `path`.
Seconds planned_time(std::span<const Move> moves, const PathControl& path, const Machine& machine,
                     std::optional<MotionPlanner> of_control);

/// The planner used by planned_times.
MotionPlanner planner_in_force(const Machine& machine, std::optional<MotionPlanner> of_control);

/// All moves of all sections. With `control`, its states decide the standstills and the permitted deviation from the
/// path; without, every section begins at rest and no bound of the deviation is known.
std::vector<PlannedMove> planned_moves(const Toolpath& toolpath, const ControlTable* control);

}  // namespace clearcut::kinematics
