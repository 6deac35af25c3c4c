// Arcs through a run of points, one along a heading, and one for two.
#pragma once

#include <optional>
#include <span>

#include "geometry/edge.h"

namespace clearcut::plan::adaptive {

/// As few arcs and lines as reach, one after the other, from the first point to the last with every point
/// within `tolerance` mm. The points follow a smooth curve, none twice. Cost O(n log n).
Path fit_arcs(std::span<const Vec2> points, double tolerance);

/// The arc from one point to another that begins along `heading`; a line where that leads straight there.
Edge tangent_arc(Vec2 from, Vec2 heading, Vec2 to);

/// Two edges, one after the other, as one that keeps within `tolerance` mm of both; none where there is no such arc or line.
std::optional<Edge> joined(const Edge& first, const Edge& second, double tolerance);

}  // namespace clearcut::plan::adaptive
