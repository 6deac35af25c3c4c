// T-slots: the preceding slot for the neck, and the places at which the disc descends and retracts.
#pragma once

#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// Gives every T-slot its cutter's height, and inserts a preceding step, a separate feature, for milling the slot
/// above it along the same line: with the narrowest available end mill wider than the neck of the T-slot cutter and
/// narrower than its disc.
///
/// The disc descends and retracts at free ends of the line: beside the stock, if the line ends at or beyond the
/// stock's side (the line is extended as far as the cutter needs), or in pockets and holes cut before and at least as
/// deep. Throws InputError if a tool is missing, no end is free, or there would be no undercut. The tools must have
/// been chosen (choose_tools).
void shape_t_slots(Part& part, const PlanOptions& options, StepSources& sources);

}  // namespace clearcut::resolve
