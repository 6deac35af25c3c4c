// The loops with which published methods clear the residual of a wide step in a corner.
//
// Each loop leaves the inner contour at its corner (the root) and approaches the corner of the contour around it: up
// to the tip, the farthest point that the cutter must reach. A loop around the line from root to tip that is nowhere
// wider than the cutter clears the same area as this line: the shortest connection from any point to the line crosses
// the loop first.
#pragma once

#include <optional>

#include "geometry/edge.h"

namespace clearcut::plan::contour {

enum class CornerLoop {
  /// Zhao et al.: the circle through root and tip. Its length, CPO-rho eq. (2) (docs/texts.md), is illegible in
  /// print.
  kCircle,
  /// Park et al., pair-wise interference detection: a kite with sides parallel to the corner's at the tip.
  kPwid,
  /// Choy and Chan: straight on past the corner, round and back along the other side, always tangent.
  kSingle,
  kDouble  ///< Choy and Chan: two loops, to half and to the full distance, so that each engages less
};

/// The loop from `root` back to `root`, mm. `in` and `out`: unit directions of the contour before and after its
/// corner, material on the left. Nothing if root and tip coincide, if the corner is not convex, or if the
/// loop would be wider than a cutter of `radius` mm, so that its middle would remain uncut. Cost O(1).
std::optional<Path> corner_loop(CornerLoop kind, Vec2 root, Vec2 tip, Vec2 in, Vec2 out, double radius);

}  // namespace clearcut::plan::contour
