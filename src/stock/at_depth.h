// Outlines of features whose walls have draft, by depth.
#pragma once

#include "base/tolerances.h"
#include "base/units.h"
#include "geometry/region.h"

namespace clearcut::stock {

/// The outline of `regions` at depth `below_top` mm under the top of a feature whose walls lean by `wall_slope` (draft; SPEC B4).
Regions at_depth(const Regions& regions, Radians wall_slope, double below_top, const Tolerances& tol);

}  // namespace clearcut::stock
