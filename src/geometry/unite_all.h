// Union of many regions at once.
#pragma once

#include "base/tolerances.h"
#include "geometry/region.h"

namespace clearcut::inline geometry {

/// What any of the regions covers; they may overlap, and their boundaries may all but coincide for long (which makes
/// unite slow: thousands of slivers, each nested anew). Slivers are dropped before nesting is found.
///
/// Shape, error as unite. Cost O((n + k) log n + s^2) for n flattened vertices, k crossings, s contours left.
Regions unite_all(const Regions& regions, const Tolerances& tol);

}  // namespace clearcut::inline geometry
