// Cubic splines through points: the curves drawn by CAD for a DXF SPLINE with fit points only.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/vec2.h"

namespace clearcut::read {

/// One cubic between neighbouring points, by its ends and the derivatives there over u in [0, length].
struct FitSpan {
  Vec2 from, to;
  Vec2 from_slope, to_slope;
  double length = 0;  ///< length of its parameter range: the chord

  /// The point at share t in [0, 1] of the span.
  Vec2 at(double t) const;
};

struct FitEnds {
  std::optional<Vec2> start, end;  ///< directions of travel; any length but 0. Absent: no curvature there
  bool closed = false;             ///< back to the first point, as smoothly as everywhere else
};

/// The C2 cubic through `points` with chord lengths as parameters.
///
/// Shape   one span between neighbouring points; none for fewer than two. Points repeating their neighbour count
///         once.
/// Cost    O(n).
/// Source  de Boor, A Practical Guide to Splines, chapter IV: the tridiagonal system for the slopes. Ends without a
///         direction are natural; with one, the speed there is 1, the speed of the chord lengths.
std::vector<FitSpan> cubic_through(std::span<const Vec2> points, const FitEnds& ends);

}  // namespace clearcut::read
