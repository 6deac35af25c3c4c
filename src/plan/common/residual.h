// Material left between two neighbouring contours, and the shortest path along the medial axis that clears it.
#pragma once

#include <vector>

#include "plan/common/rings.h"

namespace clearcut::plan {

/// A path along the medial axis clearing one connected residual.
struct ResidualPath {
  std::vector<Vec2> points;  ///< points to be visited in this order; at least one
  bool closed = false;       ///< a cycle of the axis round an island: from the last point back to the first
  bool rooted = false;       ///< points.front() is on the contour of one of the node's children
};

/// The paths clearing the residuals between the contour of `node` and those of its children; `radius` of
/// the cutter, mm.
///
/// An uncleared point between the contours is on the line from the wall to a point m of the medial axis
/// with level + radius < clearance(m) < next_level, at most next_level - level - radius <= radius from m. So
/// a path along that part of the axis clears everything. Its free ends are then cut back by up to one radius.
std::vector<ResidualPath> residual_paths(const RingNode& node, double radius);

}  // namespace clearcut::plan
