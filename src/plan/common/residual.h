// What successive contours leave uncut, and the shortest path along the medial axis that clears it. Used by
// plan_contour alone.
#pragma once

#include <vector>

#include "plan/common/rings.h"

namespace clearcut::plan {

/// A path along the medial axis that clears one connected residual.
struct ResidualPath {
  std::vector<Vec2> points;  ///< at least one
  bool closed = false;       ///< a ridge all round an island: the last point joins the first
  bool rooted = false;       ///< points.front() lies on the contour of one of the node's children
};

/// The residuals between the contour of `node` and those of its children, for a cutter of `radius`.
///
/// A point p between them that no contour clears lies on the line from the wall to a point m of the medial
/// axis with level + radius < clearance(m) < next_level, at most next_level - level - radius <= radius from
/// m. So a walk along that part of the axis clears everything; its free ends are then cut back by up to one
/// radius.
std::vector<ResidualPath> residual_paths(const RingNode& node, double radius);

}  // namespace clearcut::plan
