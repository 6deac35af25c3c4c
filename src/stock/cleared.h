// What earlier work has taken away over a target.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "geometry/box.h"
#include "geometry/region.h"

namespace clearcut::stock {

/// Everything above `floor_z` within `area` is gone.
struct Cleared {
  Cleared(double floor, Regions cleared);

  double floor_z = 0;
  Regions area;
  Box extent;
};

/// Whether these are no more than slivers along outlines that were meant to coincide: thinner than 0.05 mm in the mean.
bool is_sliver(const Region& region);
bool negligible(const Regions& regions);

/// What `cleared` leaves of `standing`.
Regions without(const Regions& standing, const Cleared& cleared, const Tolerances& tol);

/// The highest place of what stands over `target`: `start` where any of it was not cleared.
///
/// With the areas sorted deepest first and U_k the union of the first k, it is the floor of the first k for which U_k covers
/// the target: so they are subtracted one after the other until nothing is left. Cost O(areas) booleans.
double top_over(const Regions& target, const std::vector<Cleared>& deepest_first, double start,
                const Tolerances& tol);

}  // namespace clearcut::stock
