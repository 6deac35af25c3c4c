// Walls as tapered end mills leave them.
#pragma once

#include "model/part.h"

namespace clearcut::resolve {

/// Gives walls cut by tapered end mills the slope of the mills' flanks if the walls are steeper, from the edge at the
/// top on; the material left at their foot is a doubt (`leaning-walls`) of the part. Walls with at least as much
/// draft keep their own. Throws InputError if other mills work on the same vertical walls, and for profiles, holes
/// and isolation bands around copper.
void lean_walls(Part& part);

}  // namespace clearcut::resolve
