// The exact end of a search: places that a path leaves, wherever they are.
#pragma once

#include <vector>

#include "geometry/region.h"
#include "geometry/route/legal_area.h"

namespace clearcut::plan::cover {

/// An area, and the disc that has to clear it.
struct CoveredArea {
  explicit CoveredArea(const Regions& area) : edges(edges_of(area)), inside(area) {}
  std::vector<Edge> edges;  ///< the boundary
  LegalArea inside;
};

/// Places of the area farther than `radius` from all moves of the path, at least one of each part that is left; empty if
/// nothing is left.
///
/// Method  Parts that do not touch the boundary of the area are found by the vertices of their rims (plan/common/cover.h), and
///         a raster over each. Others contain a stretch of the boundary: the stretches cleared by each move are bounded by
///         intersections of the boundary with the rim of what the move clears.
/// Error   Parts thinner than 1e-9 of the radius count as cleared.
/// Cost    O(n log n) for n moves and edges, if few moves are near each other.
std::vector<Vec2> places_left(const CoveredArea& area, const Path& path, double radius);

}  // namespace clearcut::plan::cover
