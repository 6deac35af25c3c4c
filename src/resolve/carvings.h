// V-carving and engraving for the cutters that were chosen: slopes, depths, and the mill that clears wide floors.
#pragma once

#include "model/part.h"
#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// Gives every V-carving the slope and the depth of its bit, and where its floor is wide enough a step before it that clears the
/// floor with the largest mill that fits; every engraving with a shaped cutter the groove that it cuts. Throws InputError where
/// the tools cannot make it.
void shape_carvings(Part& part, const PlanOptions& options, StepSources& sources);

}  // namespace clearcut::resolve
