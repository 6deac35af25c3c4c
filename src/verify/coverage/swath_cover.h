// Whether swaths cover a convex cell, and whether they run along a curve.
#pragma once

#include <span>
#include <vector>

#include "verify/coverage/convex.h"
#include "verify/coverage/coverage.h"

namespace clearcut::verify {

/// mm; upper bound of the distance of the points of `cell` outside the swath; negative if all are inside.
double excess_over(const ConvexPolygon& cell, const Swath& swath);

/// A convex polygon around the part of `cell` left by the swath; at worst the cell itself.
ConvexPolygon rest_after(const ConvexPolygon& cell, const Swath& swath);

/// mm; upper bound of the distance of the points of `curve` from the swath's path.
double deviation_of(const Edge& curve, const Edge& path);

/// Adds points whose convex hull holds the part of an edge inside a square.
void append_extremes(const Edge& edge, const Box& square, std::vector<Vec2>& out);

}  // namespace clearcut::verify
