// Union, difference, intersection of regions by polyclipping, with arcs found again by provenance.
#pragma once

#include "base/tolerances.h"
#include "geometry/region.h"

namespace clearcut::inline geometry {

/// Shape   disjoint regions, islands and nesting resolved. Arcs of the input give arcs on the same circle.
/// Error   results are within tol.chord of the exact ones; parts thinner than that may vanish.
/// Cost    O((n + k) log n), n flattened vertices, k crossings.
Regions unite(const Regions& a, const Regions& b, const Tolerances& tol);
Regions subtract(const Regions& a, const Regions& b, const Tolerances& tol);
Regions intersect(const Regions& a, const Regions& b, const Tolerances& tol);

/// Regions bounded by arbitrary closed loops (crossing, overlapping, any orientation) under the even-odd
/// rule: the basis for the repair of faulty input.
Regions resolve_even_odd(std::span<const Loop> loops, const Tolerances& tol);
/// The same under the non-zero rule: loops' orientations count.
Regions resolve_nonzero(std::span<const Loop> loops, const Tolerances& tol);

}  // namespace clearcut::inline geometry
