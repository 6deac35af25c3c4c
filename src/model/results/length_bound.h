// A lower bound of the length of paths that clear an area, with everything needed to add it up again.
#pragma once

#include <vector>

#include "geometry/vec2.h"

namespace clearcut::inline model {

/// A point of the area that the path must pass within the cutter's radius.
struct LengthBoundPoint {
  Vec2 at;
  double mm2 =
      0;  ///< area that the cutter covers beyond the area to be cleared, in the cell of this point, at least
};

/// A point of the area in a circle that the path must cross to reach the point.
struct LengthBoundRing {
  Vec2 at;
  double radius_mm = 0;  ///< radius of the circle
  double mm2 = 0;        ///< part of the area to be cleared within the circle's radius and the cutter's
};

/// See verify/coverage/length_bound.h for the formula and its proof.
struct LengthBound {
  double mm = 0;
  double cutter_radius_mm = 0;
  double area_mm2 = 0;
  int paths = 1;        ///< number of paths, each begun by an entry
  bool closed = false;  ///< the path returns to its start
  std::vector<LengthBoundPoint> points;
  std::vector<LengthBoundRing> rings;
};

/// The bound of each level of a workingstep that clears its feature, in Figures::lower_bound_mm.
struct StepLengthBound {
  int workingstep = 0;
  LengthBound bound;
};

}  // namespace clearcut::inline model
