// Bounded curves of ISO 10303-42 as paths of lines and arcs, and fillets between the walls of an outline.
#pragma once

#include <vector>

#include "geometry/edge.h"
#include "geometry/region.h"
#include "read/stepnc/shapes/placement.h"

namespace clearcut::read::stepnc {

/// POLYLINE, TRIMMED_CURVE of LINE or CIRCLE, COMPOSITE_CURVE (nested), CIRCLE, and within kCurveTolerance ELLIPSE,
/// B_SPLINE_CURVE_WITH_KNOTS and BEZIER_CURVE: in plan, in the frame the
/// curve is given in; the z of points is not used. Edges are joined exactly: gaps up to tol.join_gap are
/// closed and reported. Throws InputError for larger gaps and other curves.
Path curve_path(const Node& curve, Context& context);

/// The same as a closed loop: a polyline need not repeat its first point.
Loop curve_loop(const Node& curve, Context& context);

/// Arc from a to b about a center that is at `radius` from them only nearly: the ends stay, and the radius
/// where the arc sweeps up to 120 degrees, else the middle of the chord's bisector nearest to `center`.
Edge arc_through(Vec2 a, Vec2 b, Vec2 center, double radius, Turn turn);

/// Without edges shorter than tol.coincident, ends joined exactly.
Path without_tiny_edges(Path path, const Tolerances& tol);

struct Filleted {
  Path path;
  std::vector<Vec2>
      sharp;  ///< corners that stay sharp, because no arc of the radius fits between their edges
};

/// `path` with an arc of `radius`, mm, in each corner at which it turns to the left (counter-clockwise loops: the corners of a pocket, not
/// those of an island in it); `closed`: also where its end meets its start. Edges that go on in one direction are no corner.
///
/// Error   exact but for rounding: an arc touches both edges.
/// Cost    O(edges).
Filleted filleted(const Path& path, bool closed, double radius);

/// The same for corners at which the path turns to the right.
Filleted filleted_on_the_right(const Path& path, double radius);

}  // namespace clearcut::read::stepnc
