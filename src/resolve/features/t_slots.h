// T-slots: the slot for the neck that comes first, and where the disc goes down and comes up.
#pragma once

#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// Gives every T-slot its cutter's height, and puts a step before it, a feature of its own, that mills the slot above it along the
/// same line: with the narrowest end mill at hand that is wider than the neck of the T-slot cutter and narrower than its disc.
///
/// The disc goes down and comes up at ends of the line where nothing is in its way: beside the stock, where the line ends at or
/// beyond its side (it is drawn on as far as the cutter needs), or in pockets and holes that are cut before and at least as deep.
/// Throws InputError where a tool is missing, no end is such a place, or there would be no undercut. The tools must have been
/// chosen (choose_tools).
void shape_t_slots(Part& part, const PlanOptions& options, StepSources& sources);

}  // namespace clearcut::resolve
