// The outline of the area in which clearing runs: off the walls by what a later wall pass can take within the limit.
#pragma once

#include "geometry/region.h"

namespace clearcut::plan::adaptive {

/// The part of `legal` (where the centre may be) that clearing uses for an engagement of up to `limit` radians.
///
/// Shape   beside walls the wall pass is left the most of its widest cut; near corners, where a wall
///         pass meets both sides at once, and in narrow places nothing; in between the distance changes
///         slowly.
/// Error   0.3 um.
/// Cost    O(length / tool radius * edges).
Region front_area(const Region& legal, double tool_radius, double limit);

}  // namespace clearcut::plan::adaptive
