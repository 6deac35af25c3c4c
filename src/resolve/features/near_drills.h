// Drills of nearly the size of a hole.
#pragma once

#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// Makes plain round holes that no tool at hand makes or mills as wide as the drill that comes nearest, where it comes within
/// features::kNearDrill of them; says so in part.diagnostics, once for all holes of one size.
void take_near_drills(Part& part, const PlanOptions& options);

}  // namespace clearcut::resolve
