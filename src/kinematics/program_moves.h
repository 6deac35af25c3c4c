// The moves of a program in one row, as the planner of its control meets them.
#pragma once

#include <vector>

#include "kinematics/planner.h"

namespace clearcut::kinematics {

/// All moves of all sections. With `control`, its states decide the standstills and the permitted deviation from the
/// path; without, every section begins at rest and no bound of the deviation is known.
std::vector<PlannedMove> planned_moves(const Toolpath& toolpath, const ControlTable* control);

}  // namespace clearcut::kinematics
