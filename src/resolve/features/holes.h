// Holes requiring more than one tool: the preceding steps, and the depth of each.
#pragma once

#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// Gives every hole requiring more than a cylinder its tool and its depths, and inserts the necessary preceding
/// steps, as separate features:
///
/// Spots     before drilled holes, if there is a spot drill among the tools: a cone 0.9 of the hole's width.
/// Pilots    before taps, thread mills, reamers and boring bars: the available drill of the right width, else a
///           milled hole. None if the drawing contains such a hole on the same centre.
/// Points    through holes are drilled `kBreakthrough` mm plus the drill's point below the stock; blind holes by a
///           drill with a stated point angle have their full diameter down to their depth.
///
/// Throws InputError if a tool is missing, naming a suitable one. The tools must have been chosen (choose_tools).
void shape_holes(Part& part, const PlanOptions& options, StepSources& sources);

}  // namespace clearcut::resolve
