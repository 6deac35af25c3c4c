// Touching and crossing loops: pinches are split, small crossings mended, overlapping filled shapes united, islands
// through walls cut back, all others refused.
#pragma once

#include <cstddef>
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

/// Loops of compounds, which may cross each other, become non-crossing loops under the even-odd rule.
std::vector<RawLoop> resolve_compounds(std::vector<RawLoop> loops, const RepairOptions& options,
                                       Diagnostics& diagnostics);

/// Loops that touch each other at most in points, bounding the same area under the even-odd rule, up to the
/// mends listed in `diagnostics`:
/// - a self-crossing loop keeps its main part if all the rest is a sliver (kLargestCurl of its
///   area);
/// - an island through a wall (kMostlyInside of it is inside) is cut back to the wall;
/// - partly overlapping filled shapes of one colour are united;
/// - outlines that overlap by less than kSlightOverlap of the smaller, or share a stretch of wall, are
///   united. Throws InputError naming the place for all other crossings.
std::vector<Loop> resolve_crossings(std::vector<RawLoop> loops, const RepairOptions& options,
                                    Diagnostics& diagnostics);

inline constexpr double kLargestCurl = 0.001;
inline constexpr double kMostlyInside = 0.9;
inline constexpr double kSlightOverlap = 0.1;
/// Greatest number of crossing pairs of outlines, each with its own boolean.
inline constexpr std::size_t kMostCrossingPairs = 500;

}  // namespace clearcut::read
