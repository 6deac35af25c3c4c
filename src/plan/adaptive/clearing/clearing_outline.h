// The outline of the area in which clearing runs: as far from the walls as a later wall pass can cut within
// the limit.
#pragma once

#include "geometry/region.h"

namespace clearcut::plan::adaptive {

/// The part of `legal`, where the centre may be, that clearing uses for an engagement of up to `limit`
/// radians.
///
/// Shape   Beside walls it leaves to the wall pass nearly as much as that can cut within the limit. Near
///         corners, where a wall pass meets both sides at once, and in narrow places it leaves nothing. In
///         between the distance from the wall changes slowly.
/// Error   0.3 um.
/// Cost    O(length / tool radius * edges).
Region front_area(const Region& legal, double tool_radius, double limit);

}  // namespace clearcut::plan::adaptive
