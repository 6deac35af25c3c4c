// Overlapping filled shapes.
#pragma once

#include <vector>

#include "read/repair/joining.h"
#include "read/repair/meetings.h"

namespace clearcut::read {

/// Partly overlapping filled shapes of one colour, neither mostly within the other (kSlightOverlap, kMostlyInside),
/// become one: the painted area is the intended one. `harmful`: the crossings of `loops` between different shapes.
/// Returns whether any were united; the crossings must then be found anew. Cost: one boolean for each crossing pair,
/// up to kMostCrossingPairs pairs; beyond, nothing is done.
bool unite_fills(std::vector<RawLoop>& loops, const std::vector<Meeting>& harmful,
                 const RepairOptions& options, Diagnostics& diagnostics);

}  // namespace clearcut::read
