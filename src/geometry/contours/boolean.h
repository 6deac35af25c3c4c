// Union, difference, intersection of regions by polyclipping, with arcs found again by provenance.
#pragma once

#include <span>
#include <vector>

#include "base/tolerances.h"
#include "geometry/region.h"

namespace clearcut::inline geometry {

/// Of each region the outer loop, counter-clockwise, then its islands, clockwise.
inline std::vector<Loop> loops_of(const Regions& regions) {
  std::vector<Loop> loops;
  for (const Region& region : regions) {
    loops.push_back(region.outer());
    loops.insert(loops.end(), region.islands().begin(), region.islands().end());
  }
  return loops;
}

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
