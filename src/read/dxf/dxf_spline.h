// DXF SPLINE: rational B-splines, and cubics through fit points, the curves drawn by CAD for a SPLINE with fit points
// only, as lines and arcs.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/edge.h"
#include "geometry/vec2.h"
#include "read/common/affine.h"
#include "read/dxf/dxf_document.h"

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

/// Group codes that differ between SPLINE and the boundaries of HATCH.
struct SplineCodes {
  int degree;
  int weight;
};

/// The spline of an entity's control points under `map`, within kCurveTolerance mm; nothing if it has none.
/// Throws  InputError "file:line: ..." when knots, weights and control points are inconsistent.
/// Source  de Boor's algorithm on homogeneous points, knot span by knot span.
std::optional<Path> spline_by_poles(const DxfDocument& document, const DxfEntity& entity,
                                    const SplineCodes& codes, const Affine& map);

/// The spline under `map`, within kCurveTolerance mm. Fit points are used if it has no control points; nothing if it
/// has neither.
/// Throws  as spline_by_poles() does.
std::optional<Path> spline_path(const DxfDocument& document, const DxfEntity& entity, const Affine& map);

}  // namespace clearcut::read
