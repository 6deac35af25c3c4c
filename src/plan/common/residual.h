// Material left between two neighbouring contours or in any place, and the paths that clear it: along the medial
// axis, or as detours, there and back.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "geometry/edge.h"
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

struct MendJob {
  double radius = 0;       ///< radius of the cutter, mm
  double residual = 5e-4;  ///< mm; residuals up to this thick may stay between two paths one diameter apart
  std::function<bool(Vec2)> matters;  ///< whether a place has to be cleared
  std::span<const Edge> fixed;        ///< edges that also clear, but get no detours
  /// Whether the cutter's centre may go straight from one point to the other.
  std::function<bool(Vec2, Vec2)> legal;
};

/// Places to be cleared that neither `paths` nor `job.fixed` clear; see Cover::holes.
std::vector<Vec2> left_by(std::span<const Path> paths, const MendJob& job);

/// Adds detours to `paths` until nothing is left uncut. False if an uncut place remains that no straight legal detour
/// clears.
///
/// Method  The vertices of a hole's rim are collected into groups, each cleared by one position of the cutter. From
///         the nearest legal place on a path the cutter moves towards that position as far as needed for the group,
///         and back. A disc around the vertices contains nearly all of the hole; the search for holes is repeated
///         until no hole is found.
/// Cost    O(rounds * (n + holes * n)) for n edges, at most 24 rounds.
bool mend(std::vector<Path>& paths, const MendJob& job);

}  // namespace clearcut::plan
