// Filled shapes that overlap each other.
#pragma once

#include <vector>

#include "read/repair/joining.h"
#include "read/repair/meetings.h"

namespace clearcut::read {

/// Filled shapes of one colour that overlap in part, neither of them mostly within the other (kSlightOverlap, kMostlyInside), become
/// one: what was painted is what is meant. `harmful`: the crossings of `loops` between different shapes. Returns whether any
/// were united; then the crossings have to be found anew. Cost one boolean for each pair that crosses, up to kMostCrossingPairs pairs;
/// beyond, nothing is done.
bool unite_fills(std::vector<RawLoop>& loops, const std::vector<Meeting>& harmful,
                 const RepairOptions& options, Diagnostics& diagnostics);

}  // namespace clearcut::read
