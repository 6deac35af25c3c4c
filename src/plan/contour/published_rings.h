// The loops with which published methods clear the residual of a wide step in a corner.
//
// Each loop leaves the inner contour at its corner (the root) and approaches the corner of the contour around it: up
// to the tip, the farthest point that the cutter must reach. A loop around the line from root to tip that is nowhere
// wider than the cutter clears the same area as this line: the shortest connection from any point to the line crosses
// the loop first.
//
// Contours whose reflex corners stay corners, as the papers print them.
//
// Passages from contour to contour along a corner's bisector, as the published methods run them.
#pragma once

#include <optional>
#include <vector>

#include "base/tolerances.h"
#include "geometry/edge.h"
#include "model/layer.h"
#include "plan/common/rings.h"
#include "plan/contour/contour.h"

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

/// The contours of a polygon from the distance `first_level`, mm, inwards: each with its sides moved in and prolonged
/// to their intersections (CPO-kappa eq. 2, in which interior angles above pi lengthen the sides; all moves are
/// straight). Parents come before their children. Clearances are those in the contour around, counted on from its
/// level: about reflex corners they are less than the distance from the wall.
///
/// Shape   nested as given by the moved sides: regions split, sides vanish, and islands grow.
/// Error   1 nm a contour.
/// Cost    one offset and one Voronoi diagram for each contour.
std::vector<RingNode> mitred_ring_tree(const Region& domain, double first_level, const StepOf& step_of,
                                       const Tolerances& tol);

/// Joins rings that each surround exactly one other ring into one pass: once round each ring, beginning and ending at
/// one corner, then along the bisector of that corner to the next ring. This is the sharpest corner of the ring at
/// the wall; if that corner has vanished farther in, the passage leads to the nearest place of the ring. Rings are
/// unchanged if they surround several rings, or if the passage would leave the legal area.
///
/// Shape   passes from the innermost ring outwards, or inwards if options.outside_in; parents of all passes are the
///         joined passes around them. Single passages contained in a joined pass are dropped.
/// Source  CPO-kappa eq. 1 and 3, M = H / sin(alpha / 2); CPO-rho eq. 6 and 7; see docs/texts.md.
void join_along_bisectors(LayerPasses& layer, const ContourOptions& options);

}  // namespace clearcut::plan::contour
