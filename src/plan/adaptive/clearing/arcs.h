// Fits arcs: to a run of points, to two points and a heading, and one arc in place of two edges.
#pragma once

#include <optional>
#include <span>

#include "geometry/edge.h"

namespace clearcut::plan::adaptive {

/// Arcs and lines, one after the other, as few as keep every point within `tolerance` mm. The points lie
/// along a smooth curve and no two are equal. Cost O(n log n).
Path fit_arcs(std::span<const Vec2> points, double tolerance);

/// The arc from one point to another that begins along `heading`, a unit vector; a line if `to` lies straight
/// ahead.
Edge tangent_arc(Vec2 from, Vec2 heading, Vec2 to);

/// One arc or line that stays within `tolerance` mm of two successive edges; nothing if there is none.
std::optional<Edge> joined(const Edge& first, const Edge& second, double tolerance);

}  // namespace clearcut::plan::adaptive
