// The loops with which published methods clear what a wide step leaves in a corner.
//
// Each leaves the inner contour at its corner (the root) and comes near the corner of the contour around
// it: to the tip, the farthest point that the cutter has to reach. A loop that encloses the line from root to
// tip and is nowhere wider than the cutter clears all that this line clears: the shortest line from any point
// to it crosses the loop first.
#pragma once

#include <optional>

#include "geometry/edge.h"

namespace clearcut::plan::contour {

enum class CornerLoop {
  /// Zhao et al.: the circle through root and tip. Its length, CPO-rho eq. (2) (docs/texts.md), is illegible in print.
  kCircle,
  /// Park et al., pair-wise interference detection: a kite with sides parallel to the corner's at the tip.
  kPwid,
  /// Choy and Chan: straight on past the corner, round and back along the other side, always tangent.
  kSingle,
  kDouble  ///< Choy and Chan: two such loops, half way and all the way, so that each engages less
};

/// The loop from `root` back to it, mm. `in` and `out`: unit directions of the contour before and after its
/// corner, material on the left. Nothing if root and tip coincide, if the corner is not convex, or if the
/// loop would be wider than a cutter of `radius` mm, so that its middle would stay. Cost O(1).
std::optional<Path> corner_loop(CornerLoop kind, Vec2 root, Vec2 tip, Vec2 in, Vec2 out, double radius);

}  // namespace clearcut::plan::contour
