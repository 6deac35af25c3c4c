// Profiles for the cutters that were chosen: kerfs, and the tabs in them.
#pragma once

#include "model/part.h"
#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// Sets target (the kerf) and allowed (a band wide enough for leads) of every profile of the workplan for its cutter; other
/// parts on the same drawing stay out of both. Where tabs are asked for, the layers below their tops become a feature of
/// its own, "..._tabs", cut after those above. Lines that end within the material are cut all along. Throws InputError where no
/// place is left for a tab of a profile that frees the part.
void shape_profiles(Part& part, const PlanOptions& options, StepSources& sources);

/// Puts the steps of all that may free a piece behind all others, those along one outline together: no other step may come in between
/// once the first has gone through. Otherwise the order stays.
void put_what_frees_last(Part& part);

}  // namespace clearcut::resolve
