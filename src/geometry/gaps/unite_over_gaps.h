// Union of areas separated by narrow gaps, and removal of edges too short to be anything but the rounding of a
// boolean.
#pragma once

#include "base/tolerances.h"
#include "geometry/region.h"

namespace clearcut::inline geometry {

/// The regions with each run of edges of at most `shortest` mm replaced by one corner. Booleans of nearly coincident
/// outlines leave runs of short edges, and offsets are unreliable near them.
///
/// Error   a corner moves by no more than `shortest`; runs that are longer in total, or between two arcs, stay
///         unchanged. O(n).
Regions without_short_edges(const Regions& regions, double shortest);

/// Both areas as one, also over gaps of up to `gap` mm between edges that run along each other; of a gap that is
/// wider in places, only the narrow parts are closed.
///
/// Shape, error as unite; at closed gaps, the areas also grow by kOverlap along their own edges there. Cost that of
/// unite, and O(n log n) if no gap is that narrow.
Regions unite_over_gaps(const Regions& a, const Regions& b, double gap, const Tolerances& tol);

}  // namespace clearcut::inline geometry
