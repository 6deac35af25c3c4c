// How far a program lets its control round the corners of the path: of each section as much as gains time and leaves its
// features clean.
#pragma once

#include <vector>

#include "model/move.h"
#include "model/options/resolved_plan.h"
#include "model/runs/plan_result.h"

namespace clearcut::pipeline {

/// mm; of each section of `planned` the asked rounding where the control's planner gains time by it, else the least. Empty
/// if nothing is asked, or if the program states no rounding.
std::vector<double> widest_corner_tolerances(const Toolpath& planned, const ResolvedPlan& plan);

/// After `tries` certificates, the last of which found `result.findings`: less rounding in the sections of features that
/// have too much left or a gouge, then everywhere, in the end the least. False if there is nothing to make narrower: the program is not
/// faulty, or rounds no more than the least.
bool narrow_corner_tolerances(PlanResult& result, const Toolpath& planned, const ResolvedPlan& plan,
                              int tries);

/// Notes the operations whose corners the program lets the control round by less than asked.
void tell_corner_tolerances(const Toolpath& planned, const ResolvedPlan& plan, PlanResult& result);

}  // namespace clearcut::pipeline
