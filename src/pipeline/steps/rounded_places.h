// Says why a hole or a narrow slot is not where it was drawn: the digits that the program is written with.
#pragma once

#include "pipeline/steps/plan_result.h"

namespace clearcut::pipeline {

/// Warns of each hole that is drilled beside its place, and of each slot that is milled so, by more than tol.gouge and no more
/// than the digits of the program explain, with what helps. A cutter as wide as what it makes cannot keep off the wall, so
/// that the fault stays.
void explain_rounded_places(PlanResult& result, const ResolvedPlan& plan);

}  // namespace clearcut::pipeline
