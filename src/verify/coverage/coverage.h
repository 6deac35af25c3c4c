// Proves that everything a cutter can reach was cut.
#pragma once

#include <optional>
#include <vector>

#include "base/tolerances.h"
#include "geometry/region.h"
#include "verify/part/finished_part.h"

namespace clearcut::verify {

/// A part of a program that cuts at the height in question: the tip is at or below it everywhere.
struct Swath {
  Edge path;  ///< a point for a plunge
  double radius = 0;
};

struct CoverageQuestion {
  const FinishedPart* part = nullptr;
  const Regions* target = nullptr;  ///< what is to be cut, in plan view, allowance and draft not taken off
  double z = 0;                     ///< mm; height of the tip down to which it is to be cut
  double radius = 0;                ///< mm; of the smallest cutter of the work: what it reaches has to be cut
  double flat = 0;                  ///< mm; of its flat end, <= radius: only that cuts down to z
  double allowance = 0;             ///< mm; stock to leave on walls
  /// mm; the control may leave the paths by this: it is added to the width of what may be left.
  double path_tolerance = 0;
  double above = 0;  ///< mm; how far above this height the highest tip lies that is taken to have cut it
  std::vector<Swath> swaths;
};

struct Coverage {
  bool reachable = false;  ///< whether a legal centre reaches any of the target
  /// mm^2; upper bound of the reachable area left. 0 if nothing is wider than widest_left(); residuals
  /// thinner than that on walls are left out.
  double uncut_mm2 = 0;
  /// mm; upper bound of the width of anything reachable that is left: the widest disc in it, against a wall
  /// its thickness, or its height under the tip.
  double thickness_mm = 0;
  double path_tolerance_mm = 0;  ///< mm of it that come from where the control may leave the path
  std::optional<Vec2> worst;     ///< where thickness_mm was found, if uncut_mm2 > 0
  /// mm^2; area of the target that no legal centre reaches: an estimate, to 1 % of R^2 for each corner.
  double unreachable_mm2 = 0;
  double target_mm2 = 0;
};

/// mm; the greatest width of material that may stay within reach. Residuals of two passes that meet count with
/// their common width, so planners leave less than half of this beside each.
inline double widest_left(const Tolerances& tol) {
  return tol.uncut;
}

/// Proves which points of the target that a legal centre reaches lie in some swath; docs/verification.md.
///
/// Method  A quadtree over the target. A cell is proven cut if its part of the target lies in one swath, or
///         in the convex polygon that swaths before it left. It is decided, too, if it lies beside the
///         target; if it is unreachable, because no boundary of the legal area comes within the radius; or if
///         it lies outside the legal area and the program runs along every part of the legal area's boundary
///         within reach of it: the centre that reaches a point is the nearest legal one, which lies on that
///         boundary. All other cells are divided, down to an eighth of tol.uncut.
/// Error   thickness_mm and uncut_mm2 are proven bounds for walls and paths as given, up to rounding of 1e-7
///         mm.
/// Cost    O((swaths + walls + cells) log n); the number of cells grows with area / R^2 and with the length
///         of what is left.
Coverage coverage_of(const CoverageQuestion& question, const Tolerances& tol);

/// Of a target of which its cutter reaches nothing.
Coverage nothing_in_reach(const Regions& target);

}  // namespace clearcut::verify
