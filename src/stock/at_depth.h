// Outlines of features with leaning walls, by depth.
#pragma once

#include "base/tolerances.h"
#include "base/units.h"
#include "geometry/region.h"

namespace clearcut::stock {

/// The outline of `regions` at depth `below_top` mm under a feature with leaning walls (SPEC B4).
Regions at_depth(const Regions& regions, Radians wall_slope, double below_top, const Tolerances& tol);

}  // namespace clearcut::stock
