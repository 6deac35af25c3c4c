// Union of many regions or loops at once.
#pragma once

#include <span>

#include "base/tolerances.h"
#include "geometry/region.h"

namespace clearcut::inline geometry {

/// The union of the regions; they may overlap, and their boundaries may nearly coincide over long stretches (there,
/// unite is slow: thousands of slivers, each nested anew). Slivers are dropped before nesting is found.
///
/// Shape, error as unite. Cost O((n + k) log n + s^2) for n flattened vertices, k crossings, s contours left.
Regions unite_all(const Regions& regions, const Tolerances& tol);

/// The union of loops that turn counter-clockwise and do not cross themselves; they may overlap each other
/// arbitrarily, thousands in one place, such as the strokes filling an area.
///
/// Shape, error as unite. Cost O((n + k) log n) for each of the log l levels of halves of l loops; loops inside
/// others cost time only in the first few levels.
Regions unite_loops(std::span<const Loop> loops, const Tolerances& tol);

}  // namespace clearcut::inline geometry
