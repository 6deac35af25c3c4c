#include "features/at_depth.h"

#include "base/elementary.h"
#include "geometry/voronoi/clearance.h"

namespace clearcut::features {

Regions at_depth(const Regions& regions, Radians wall_slope, double below_top, const Tolerances& tol) {
  const double draft = below_top * base::tan(wall_slope.radians());
  if (draft <= 0) return regions;
  return inset(regions, draft, tol);
}

}  // namespace clearcut::features
