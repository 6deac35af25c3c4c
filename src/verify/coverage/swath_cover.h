// Whether swaths cover a convex cell, and whether they run along a curve.
#pragma once

#include <span>
#include <vector>

#include "verify/coverage/convex.h"
#include "verify/coverage/coverage.h"

namespace clearcut::verify {

/// Upper bound of how far a point of `cell` may lie outside the swath, mm; below 0 when all are inside.
double excess_over(const ConvexPolygon& cell, const Swath& swath);

/// A convex polygon that holds what the swath leaves of `cell`: often smaller, at worst the cell itself.
ConvexPolygon rest_after(const ConvexPolygon& cell, const Swath& swath);

/// Upper bound of how far a point of `curve` may lie from the swath's path, mm.
double deviation_of(const Edge& curve, const Edge& path);

/// Corners of the convex hull of an edge's part inside a square.
void append_extremes(const Edge& edge, const Box& square, std::vector<Vec2>& out);

}  // namespace clearcut::verify
