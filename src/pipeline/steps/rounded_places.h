// Says why a hole is not where it was drawn: the digits that the program is written with.
#pragma once

#include "pipeline/run.h"

namespace clearcut::pipeline {

/// Warns of each hole that is drilled beside its place by more than tol.gouge and no more than the digits of the program
/// explain, with what helps. A cutter as wide as its hole cannot keep off the wall, so that the fault stays.
void explain_rounded_places(PlanResult& result, const ResolvedPlan& plan);

}  // namespace clearcut::pipeline
