// Loops that meet: pinches are split, small crossings mended, islands through walls cut back, the rest
// refused.
#pragma once

#include <cstddef>
#include <vector>

#include "read/repair/joining.h"

namespace clearcut::read {

/// Loops of compounds, which may cross each other, become loops under the even-odd rule that do not.
std::vector<RawLoop> resolve_compounds(std::vector<RawLoop> loops, const RepairOptions& options,
                                       Diagnostics& diagnostics);

/// Loops that at most touch each other in points, bounding the same area under the even-odd rule, up to the
/// mends listed in `diagnostics`:
/// - a loop that crosses itself keeps its main part when all the rest is a sliver (kLargestCurl of its
///   area);
/// - an island through a wall (kMostlyInside of it lies within) is cut back to the wall;
/// - filled shapes of one colour that overlap in part are united;
/// - outlines that overlap by less than kSlightOverlap of the smaller, or share a stretch of wall, are
///   united. Throws InputError naming the place for all other crossings.
std::vector<Loop> resolve_crossings(std::vector<RawLoop> loops, const RepairOptions& options,
                                    Diagnostics& diagnostics);

inline constexpr double kLargestCurl = 0.001;
inline constexpr double kMostlyInside = 0.9;
inline constexpr double kSlightOverlap = 0.1;
/// Of outlines that cross each other, each pair with a boolean of its own.
inline constexpr std::size_t kMostCrossingPairs = 500;

}  // namespace clearcut::read
