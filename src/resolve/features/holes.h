// Holes that take more than one tool: what comes before the last one, and how deep each goes.
#pragma once

#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// Gives every hole that asks for more than a cylinder its tool and its depths, and puts the steps before it that it needs, as
/// features of their own:
///
/// Spots     before holes that are drilled, where a spot drill is among the tools: a cone 0.9 of the hole's width.
/// Pilots    before taps, thread mills, reamers and boring bars: the drill at hand of the right width, else a milled hole.
///           None where a hole of the drawing on the same centre is one.
/// Points    what goes through is drilled `kBreakthrough` mm and the drill's point below the stock; blind holes whose drill
///           states its point's angle have their full diameter down to their depth.
///
/// Throws InputError where a tool is missing, naming what would do. The tools must have been chosen (choose_tools).
void shape_holes(Part& part, const PlanOptions& options, StepSources& sources);

}  // namespace clearcut::resolve
