// Union of many regions or loops at once.
#pragma once

#include <span>

#include "base/tolerances.h"
#include "geometry/region.h"

namespace clearcut::inline geometry {

/// What any of the regions covers; they may overlap, and their boundaries may all but coincide for long (which makes
/// unite slow: thousands of slivers, each nested anew). Slivers are dropped before nesting is found.
///
/// Shape, error as unite. Cost O((n + k) log n + s^2) for n flattened vertices, k crossings, s contours left.
Regions unite_all(const Regions& regions, const Tolerances& tol);

/// What loops cover that turn counter-clockwise and do not cross themselves; they may overlap in any way, thousands in one place as
/// the strokes that fill an area.
///
/// Shape, error as unite. Cost O((n + k) log n) for each of the log l levels of halves of l loops; of what lies within others only
/// the first few count.
Regions unite_loops(std::span<const Loop> loops, const Tolerances& tol);

}  // namespace clearcut::inline geometry
