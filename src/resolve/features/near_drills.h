// Drills of nearly the size of a hole.
#pragma once

#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// Sets the width of plain round holes that no available tool can make or mill to that of the nearest drill, if it is
/// within features::kNearDrill; reports this in part.diagnostics, once for all holes of one size.
void take_near_drills(Part& part, const PlanOptions& options);

}  // namespace clearcut::resolve
