// What islands take of the outlines drawn about and within them.
#pragma once

#include <string>

#include "base/diagnostics.h"
#include "base/tolerances.h"
#include "geometry/region.h"

namespace clearcut::read {

/// `regions` without the islands they hold or reach into. What lies within an island, as a hole in a boss does, stays whole: it
/// is cut in the island. An outline as large as the island it lies on is left out, and said at `place`, since the two ask for
/// opposite things.
Regions without_islands(Regions regions, const Regions& islands, const std::string& place,
                        const Tolerances& tol, Diagnostics& diagnostics);

}  // namespace clearcut::read
