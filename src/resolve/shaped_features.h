// Features whose shape follows from the chosen cutters: V-carving and engraving (slopes, depths, the mill that clears
// wide floors), profiles (kerfs, and the tabs in them).
#pragma once

#include "model/part.h"
#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// Gives every V-carving the slope and the depth of its bit, and, if its floor is wide enough, a preceding step that
/// clears the floor with the largest fitting mill; gives every engraving with a shaped cutter its groove. Throws
/// InputError if the tools cannot make the feature.
void shape_carvings(Part& part, const PlanOptions& options, StepSources& sources);

/// Sets target (the kerf) and allowed (a band wide enough for leads) of every profile of the workplan for its cutter;
/// other parts on the same drawing stay out of both. If tabs are requested, the layers below their tops become a
/// separate feature, "..._tabs", cut after the layers above. Lines ending within the material are cut along their
/// whole length. Throws InputError if no place is left for a tab of a profile that frees the part.
void shape_profiles(Part& part, const PlanOptions& options, StepSources& sources);

/// Moves the steps of all features that may free a piece behind all other steps, those along one outline together: no
/// other step may follow in between once the first one has gone through. The remaining order is unchanged.
void put_what_frees_last(Part& part);

}  // namespace clearcut::resolve
