// Proves that everything a cutter can reach was cut.
#pragma once

#include <optional>
#include <vector>

#include "base/tolerances.h"
#include "geometry/region.h"
#include "verify/finished_part.h"

namespace clearcut::verify {

/// A part of a program that cuts at the height in question: the tip is at or below it everywhere.
struct Swath {
  Edge path;  ///< a point for a plunge
  double radius = 0;
};

struct CoverageQuestion {
  const FinishedPart* part = nullptr;
  const Regions* target = nullptr;  ///< what is to be cut, plan view, before allowance and lean
  double z = 0;                     ///< at this depth
  double radius = 0;     ///< of the smallest cutter the work is given: what it reaches can be asked for
  double flat = 0;       ///< of its flat end, <= radius: only that cuts down to z
  double allowance = 0;  ///< stock to leave on walls
  /// The control may leave the paths by so much: it is added to the width, and looked out for.
  double path_tolerance = 0;
  double above = 0;  ///< mm; the highest tip that counts for this depth stands so much above it
  std::vector<Swath> swaths;
};

struct Coverage {
  bool reachable = false;  ///< whether a legal centre reaches any of the target
  /// Upper bound of the reachable area left; 0 where nothing is wider than widest_left(), and without films under it on walls.
  double uncut_mm2 = 0;
  /// Upper bound of the width of anything reachable that is left: of the widest disc that it holds, against a wall its
  /// thickness, and of the height of what is left under the tip.
  double thickness_mm = 0;
  double path_tolerance_mm = 0;  ///< of it, because the control may leave the path
  std::optional<Vec2> worst;     ///< where thickness_mm was met, if uncut_mm2 > 0
  /// Area of the target that no legal centre reaches: an estimate, error below 1 % of R^2 a corner.
  double unreachable_mm2 = 0;
  double target_mm2 = 0;
};

/// mm; the widest that may stay within reach. Planners leave films of up to tol.uncut beside what they cut; between two such the
/// width is more, and half as much again is allowed.
inline double widest_left(const Tolerances& tol) {
  return 1.5 * tol.uncut;
}

/// Target points that a legal centre reaches, minus the swept discs; docs/verification.md.
///
/// Method  A quadtree over the target. A cell is proven cut when its part of the target lies in one swath,
///         or in the convex rest that swaths before it left; beside the target; unreachable, when no boundary
///         of the legal area comes within the radius; or, wholly outside the legal area, cut because the
///         program runs along every stretch of the legal area's boundary within reach of it: the centre that
///         reaches a point is the nearest legal one, which lies on that boundary. All other cells are split,
///         down to an eighth of tol.uncut.
/// Error   thickness_mm and uncut_mm2 are proven bounds for walls and paths as given (rounding 1e-7 mm).
/// Cost    O((swaths + walls + cells) log n); cells grow with area / R^2 and with the length of what is left.
Coverage coverage_of(const CoverageQuestion& question, const Tolerances& tol);

}  // namespace clearcut::verify
