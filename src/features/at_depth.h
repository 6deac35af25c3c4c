// Outlines of features whose walls have draft, at a given depth.
#pragma once

#include "base/tolerances.h"
#include "base/units.h"
#include "geometry/region.h"

namespace clearcut::features {

/// The outline `below_top` mm under the top of a feature whose outline at the top is `regions` and whose
/// walls have the draft `wall_slope`: `regions` inset by below_top * tan(wall_slope).
Regions at_depth(const Regions& regions, Radians wall_slope, double below_top, const Tolerances& tol);

}  // namespace clearcut::features
