// Chamfers: the wall of each, the wall's side of the line, and the room beside it.
#pragma once

#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// Finds the walls of the part's chamfers and sets the chamfers' strips; chamfers by cutters with a non-cutting tip
/// are moved after the cut-out of their wall. Throws InputError if there is no wall along a line, or if an obstacle
/// limits the chamfer's width.
void shape_chamfers(Part& part, const Tolerances& tol);

}  // namespace clearcut::resolve
