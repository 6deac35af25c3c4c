// Walls as tapered end mills leave them.
#pragma once

#include "base/tolerances.h"
#include "model/part.h"

namespace clearcut::resolve {

/// Gives walls cut by tapered end mills the slope of the mills' flanks if the walls are steeper, from the edge at the
/// top on; the material left at their foot is a doubt (`leaning-walls`) of the part. Walls with at least as much
/// draft keep their own. Throws InputError if other mills work on the same vertical walls, and for profiles, holes
/// and isolation bands around copper.
void lean_walls(Part& part);

/// Whether the flanks of a tapered mill would cut into walls of other features where these cut into the walls of `own`: between steeper
/// walls there is no room for them, however much the walls of `own` lean. False for other tools.
bool meets_steeper_walls(const Part& part, const Feature& own, const Tool& tool, const Tolerances& tol);

}  // namespace clearcut::resolve
