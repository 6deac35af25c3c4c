// Proves that all material within a cutter's reach was cut.
#pragma once

#include <optional>
#include <vector>

#include "base/tolerances.h"
#include "geometry/region.h"
#include "verify/part/finished_part.h"

namespace clearcut::verify {

/// A part of a program that cuts at the given height: its tip is everywhere at or below this height.
struct Swath {
  Edge path;  ///< a point for a plunge
  double radius = 0;
};

struct CoverageQuestion {
  const FinishedPart* part = nullptr;
  /// Area to be cut, in plan view, without subtraction of allowance and draft.
  const Regions* target = nullptr;
  double z = 0;  ///< mm; height of the tip down to which the target must be cut
  /// mm; radius of the smallest cutter of the work: the area within its reach must be cut.
  double radius = 0;
  /// mm; radius of its flat end, <= radius: only the flat end cuts down to z.
  double flat = 0;
  double allowance = 0;  ///< mm; stock to leave on walls
  /// mm; permitted deviation of the control from the paths: added to the width of uncut material.
  double path_tolerance = 0;
  double above = 0;  ///< mm; height over this level of the highest tip counted as cutting it
  std::vector<Swath> swaths;
  double corner =
      0;  ///< mm; radius of the rounding at its tip: the cutter keeps off greater fillets at the feet of walls
};

struct Coverage {
  bool reachable = false;  ///< whether a legal centre reaches any of the target
  /// mm^2; upper bound of the reachable area left. 0 if no residual is wider than widest_left(); thinner residuals on
  /// walls are left out.
  double uncut_mm2 = 0;
  /// mm; upper bound of the width of reachable material left: the diameter of its widest disc, at a wall its
  /// thickness, or its height below the tip.
  double thickness_mm = 0;
  double path_tolerance_mm = 0;  ///< mm of it due to the control's deviation from the path
  std::optional<Vec2> worst;     ///< place of thickness_mm, if uncut_mm2 > 0
  /// mm^2; area of the target not reached from any legal centre: an estimate, to 1 % of R^2 for each corner.
  double unreachable_mm2 = 0;
  double target_mm2 = 0;
};

/// mm; the greatest permitted width of reachable material left. Merging residuals of two passes count with their
/// common width, so planners leave less than half of this beside each pass.
inline double widest_left(const Tolerances& tol) {
  return tol.uncut;
}

/// Proves which points of the target reached from legal centres are in some swath; docs/verification.md.
///
/// Method  A quadtree over the target. A cell is proven cut if its part of the target is in one swath, or the convex
///         polygon left by previous swaths is. A cell is also decided if it is beside the target; if it is
///         unreachable, because no boundary of the legal area is within the radius; or if it is outside the legal
///         area and the program runs along every part of the legal area's boundary within reach of the cell: a point
///         is reached from the nearest legal centre, which is on that boundary. All other cells are divided, down to
///         an eighth of tol.uncut.
/// Error   thickness_mm and uncut_mm2 are proven bounds for walls and paths as given, up to rounding of 1e-7
///         mm.
/// Cost    O((swaths + walls + cells) log n); the number of cells grows with area / R^2 and with the length of the
///         residuals.
Coverage coverage_of(const CoverageQuestion& question, const Tolerances& tol);

/// Coverage of a target wholly out of its cutter's reach.
Coverage nothing_in_reach(const Regions& target);

}  // namespace clearcut::verify
