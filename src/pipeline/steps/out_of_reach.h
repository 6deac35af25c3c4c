// Areas out of reach of the chosen cutters, as a condition that the user must accept.
#pragma once

#include <string>
#include <vector>

#include "base/tolerances.h"
#include "model/control.h"
#include "model/move.h"
#include "model/options/resolved_plan.h"
#include "model/part.h"
#include "model/results/findings.h"

namespace clearcut::pipeline {

/// One condition "out-of-reach" for each feature with more than 2 % or more than 1 mm2 out of reach of its cutters,
/// naming the largest cutter that would leave less. The condition is open if the area is more than both, or more than
/// half of the feature; else it is met because the area is small: corners rounded by the cutter are normal. And one
/// condition "not-parted" for each isolation with pieces that stay joined because gaps are narrower than the cutter.
/// Cost O(1) insets of each such feature.
std::vector<Condition> out_of_reach(const Part& part, const Findings& findings, const Tolerances& tol);

/// A drill makes no hole shallower than its point: which one, and what does.
std::string point_longer_than_hole(const Feature& feature, const Tool& tool);

/// Adds these conditions and those of the plan to the findings of the program `toolpath`: the part is not as requested until they are met or
/// accepted. For features into which no cutter fits they replace the faults on uncut features; features not machined
/// for other reasons are added after them.
void add_conditions_of_part(const Part& part, const Toolpath& toolpath, const ResolvedPlan& plan,
                            Findings& findings);

}  // namespace clearcut::pipeline
