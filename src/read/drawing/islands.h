// Subtracts islands from the outlines around and within them.
#pragma once

#include <string>

#include "base/diagnostics.h"
#include "base/tolerances.h"
#include "geometry/region.h"

namespace clearcut::read {

/// `regions` without the islands they contain or overlap. An area within an island, such as a hole in a boss, stays
/// whole: it is cut in the island. An outline as large as the island below it is left out, and reported at `place`,
/// since the two contradict each other.
Regions without_islands(Regions regions, const Regions& islands, const std::string& place,
                        const Tolerances& tol, Diagnostics& diagnostics);

}  // namespace clearcut::read
