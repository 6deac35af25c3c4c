// Chamfers: which wall each breaks, on which side of its line, and how much room there is beside it.
#pragma once

#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// Finds the walls that the part's chamfers break and gives them their strip; chamfers by cutters whose tip does not cut go
/// after the cut-out that makes their wall. Throws InputError where no wall stands along a line, or something is in the
/// way of the chamfer's width.
void shape_chamfers(Part& part, const Tolerances& tol);

}  // namespace clearcut::resolve
