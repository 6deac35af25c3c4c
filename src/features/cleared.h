// Areas that earlier work has cleared over a target.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "geometry/box.h"
#include "geometry/region.h"

namespace clearcut::features {

/// An area from which everything above `floor_z`, mm, has been removed.
struct Cleared {
  Cleared(double floor, Regions cleared);

  double floor_z = 0;
  Regions area;
  Box extent;  ///< box of `area`
};

/// mm. Mean thickness below which a remainder of `target` after subtractions counts as a sliver along nominally
/// coincident outlines: 0.05 mm; for targets hardly wider than that, half of their own width.
double sliver_width(const Regions& target);
bool is_sliver(const Region& region, double width);

/// The regions `standing` minus the cleared area.
Regions without(const Regions& standing, const Cleared& cleared, const Tolerances& tol);

/// mm; height of the highest material over `target`: `start` if some part of the target was not cleared.
/// Subtracts the areas one after the other until nothing of the target is left; the floor of the last one is
/// the height. Cost O(areas) booleans.
double top_over(const Regions& target, const std::vector<Cleared>& deepest_first, double start,
                const Tolerances& tol);

}  // namespace clearcut::features
