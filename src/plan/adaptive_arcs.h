// Arcs through a run of points.
#pragma once

#include <span>

#include "geometry/edge.h"

namespace clearcut {

/// As few arcs and lines as reach, one after the other, from the first point to the last with every point
/// within `tolerance` mm. The points follow a smooth curve, none twice. Cost O(n log n).
Path fit_arcs(std::span<const Vec2> points, double tolerance);

}  // namespace clearcut
