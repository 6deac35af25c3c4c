// Walls as tapered end mills leave them.
#pragma once

#include "model/part.h"

namespace clearcut::resolve {

/// Gives the walls that tapered end mills cut and that are steeper than the mills' flanks the slope of the flanks, from the edge at
/// the top on; how much stays at their foot is a doubt (`leaning-walls`) of the part's. Walls with as much draft keep their own. Throws
/// InputError where other mills work on the same upright walls, and for profiles, holes and bands about copper.
void lean_walls(Part& part);

}  // namespace clearcut::resolve
