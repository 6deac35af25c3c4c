// A whole layer as one path of the cutter: rings at the wall that stay as they are, and flexible paths between them. Used
// by the planner alone.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "model/pass.h"

namespace clearcut::plan::contour {

/// A vertex of a flexible path.
struct FlexPoint {
  Vec2 at;
  int ring = -1;  ///< it may only slide along this ring
};

/// A path in, a ring cut once round from where that path ends, and detours: paths that leave the ring and come back to it.
struct Leg {
  std::vector<int> path_in;  ///< numbers of points; the last lies on the ring
  int ring = -1;
  std::vector<std::vector<int>>
      detours;          ///< each begins and ends with the same point, which lies on the ring
  bool lifted = false;  ///< path_in does not begin where the leg before ended
};

struct Skeleton {
  std::vector<FlexPoint> points;
  std::vector<Path> rings;
  std::vector<Leg> legs;
};

struct SkeletonOptions {
  double chord = 0.05;  ///< mm; flexible paths start as polygons within this of their rings
  /// The innermost ring is begun as near to this as it comes.
  std::optional<Vec2> begin;
  double retract_cost = 20;  ///< mm; a retract link costs as much time as feeding this far
  double flexible =
      1e9;  ///< mm; rings that surround a greater length of path than this stay as they are, like those at the wall
  /// Whether the straight path between two points is legal.
  std::function<bool(Vec2, Vec2)> legal;
};

/// Orders passes inside-out and joins them: every tree of passes becomes one path that ends on its ring at the
/// wall, or its first that stays as it is, which then runs round once; side branches are visited on the way. Open passes without a parent are
/// left out.
Skeleton skeleton_of(const std::vector<Pass>& passes, const SkeletonOptions& options);

/// The paths of the cutter's centre, one for each stretch without a lift.
std::vector<Path> paths_of(const Skeleton& skeleton);

}  // namespace clearcut::plan::contour
