// A whole layer as one path of the cutter: unchanged rings near the wall, and flexible paths between them.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "model/layer.h"

namespace clearcut::plan::contour {

/// A vertex of a flexible path.
struct FlexPoint {
  Vec2 at;
  int ring = -1;  ///< index of the ring along which the point may slide; -1: it may move anywhere
};

/// A path to a ring, the ring cut once round from the end of that path, and detours from the ring and back.
struct Leg {
  std::vector<int> path_in;  ///< indices of points; the last one is on the ring
  int ring = -1;
  /// Indices of points; each begins and ends with the same point, on the ring.
  std::vector<std::vector<int>> detours;
  bool retracted = false;  ///< a retract link leads to the beginning of path_in
};

/// All legs, in the order of cutting.
struct Skeleton {
  std::vector<FlexPoint> points;
  std::vector<Path> rings;
  std::vector<Leg> legs;
};

struct SkeletonOptions {
  double chord = 0.05;  ///< mm; flexible paths begin as polygons this near to their rings
  /// The innermost ring begins as near as possible to this point.
  std::optional<Vec2> begin;
  double retract_cost = 20;  ///< mm; feeding this far takes as long as a retract link
  /// mm; a ring is unchanged if the path inside is longer than this.
  double flexible = 1e9;
  /// Whether the straight path between two points is legal.
  std::function<bool(Vec2, Vec2)> legal;
};

/// Orders passes from the inside out and joins them. Every tree of passes becomes one path that visits side branches
/// along its course and ends on its ring at the wall, or on the first unchanged ring; this ring is then cut once
/// round. Open passes without a parent are left out.
Skeleton skeleton_of(const std::vector<Pass>& passes, const SkeletonOptions& options);

/// The paths of the cutter's centre, one for each stretch without a retract link.
std::vector<Path> paths_of(const Skeleton& skeleton);

}  // namespace clearcut::plan::contour
