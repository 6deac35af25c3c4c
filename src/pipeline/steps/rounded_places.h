// Explains displaced holes and narrow slots by the digits of the program.
#pragma once

#include "pipeline/steps/plan_result.h"

namespace clearcut::pipeline {

/// Warns of each hole drilled and each slot milled beside its place by more than tol.gouge, but no more than the
/// rounding of the program's digits, with a remedy. A cutter as wide as its hole or slot cannot keep a distance from
/// the wall, so the fault remains.
void explain_rounded_places(PlanResult& result, const ResolvedPlan& plan);

}  // namespace clearcut::pipeline
