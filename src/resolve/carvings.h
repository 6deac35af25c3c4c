// V-carving and engraving for the chosen cutters: slopes, depths, and the mill that clears wide floors.
#pragma once

#include "model/part.h"
#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// Gives every V-carving the slope and the depth of its bit, and, if its floor is wide enough, a preceding step that
/// clears the floor with the largest fitting mill; gives every engraving with a shaped cutter its groove. Throws
/// InputError if the tools cannot make the feature.
void shape_carvings(Part& part, const PlanOptions& options, StepSources& sources);

}  // namespace clearcut::resolve
