// From the pieces of a level to exact lines and arcs that close exactly.
#pragma once

#include <optional>

#include "geometry/region.h"
#include "geometry/voronoi/level_curves.h"

namespace clearcut::inline geometry::voronoi {

/// Loop at distance d from the elements: lines stay parallel, arcs concentric, corners become arcs; joints
/// are the intersections of neighbouring offset curves. `slack` (mm) is the greatest distance of the diagram from the
/// exact boundary; pieces that exist only within this distance are dropped. Nothing if no area is left.
std::optional<Loop> offset_loop(const Diagram& diagram, const LevelCurve& curve, double d, double slack);

}  // namespace clearcut::inline geometry::voronoi
