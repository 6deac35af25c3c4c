// Loops that published methods append in a corner to clear what a wide step leaves there.
//
// All leave the inner contour at its corner (the root) and come near the corner of the contour around it: to the tip,
// the farthest place that a cutter has to reach. A loop that encloses the line from root to tip, and is nowhere wider than
// the cutter, clears all that this line clears: the shortest line from any point to it crosses the loop first.
#pragma once

#include <optional>

#include "geometry/edge.h"

namespace clearcut::plan::contour {

enum class CornerLoop {
  kCircle,  ///< Zhao et al.: the circle through root and tip. CPO-rho eq. (2), its length, is damaged in print
  kPwid,  ///< Park et al., pair-wise interference detection: a kite with sides parallel to the corner's at the tip
  kSingle,  ///< Choy and Chan: straight on past the corner, round, and back along the other side; tangent throughout
  kDouble  ///< Choy and Chan: the same twice, half way and all the way, so that each engages less
};

/// The loop from `root` back to it. `in` and `out` are the directions of the contour before and after its corner,
/// material on the left. None where root and tip coincide, where the corner is no sharper than a straight line, and where the loop would be wider
/// than a cutter of `radius`, so that its middle would be left.
/// Units mm. Cost O(1).
std::optional<Path> corner_loop(CornerLoop kind, Vec2 root, Vec2 tip, Vec2 in, Vec2 out, double radius);

}  // namespace clearcut::plan::contour
