// What the cutters that were chosen cannot reach, as a condition that somebody has to accept.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "model/control.h"
#include "model/options/resolved_plan.h"
#include "model/part.h"
#include "model/results/findings.h"

namespace clearcut::pipeline {

/// One condition "out-of-reach" for each feature of which no position of its cutters reaches more than 2 %, or more than 1
/// mm2, with the largest cutter that would leave less. Open where it is more than both, or more than half of the feature; else
/// met by being little: corners rounded by the cutter are what everybody expects. And one condition "not-parted" for each
/// isolation whose pieces stay joined where gaps are narrower than the cutter. Cost O(1) insets of each such feature.
std::vector<Condition> out_of_reach(const Part& part, const Findings& findings, const Tolerances& tol);

/// Adds these conditions and those of the plan to the findings: the part is not all that was asked for until they are met or
/// accepted. They take the place of the faults that nothing is cut where no cutter fits; what is not machined for other
/// reasons is added after them.
void add_conditions_of_part(const Part& part, const ResolvedPlan& plan, Findings& findings);

}  // namespace clearcut::pipeline
