// Union of areas that all but touch.
#pragma once

#include "base/tolerances.h"
#include "geometry/region.h"

namespace clearcut::inline geometry {

/// Both areas as one, also over gaps of up to `gap` mm between edges that run along each other; gaps that are wider somewhere
/// are closed as far as they are not.
///
/// Shape, error as unite; where a gap is closed, the areas also grow by kOverlap along their own edges there. Cost that of unite,
/// and O(n log n) to find out that no gap is that narrow.
Regions unite_over_gaps(const Regions& a, const Regions& b, double gap, const Tolerances& tol);

}  // namespace clearcut::inline geometry
