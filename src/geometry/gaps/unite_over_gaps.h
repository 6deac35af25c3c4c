// Union of areas separated by narrow gaps.
#pragma once

#include "base/tolerances.h"
#include "geometry/region.h"

namespace clearcut::inline geometry {

/// Both areas as one, also over gaps of up to `gap` mm between edges that run along each other; of a gap that is
/// wider in places, only the narrow parts are closed.
///
/// Shape, error as unite; at closed gaps, the areas also grow by kOverlap along their own edges there. Cost that of
/// unite, and O(n log n) if no gap is that narrow.
Regions unite_over_gaps(const Regions& a, const Regions& b, double gap, const Tolerances& tol);

}  // namespace clearcut::inline geometry
