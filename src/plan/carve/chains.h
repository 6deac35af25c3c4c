// Stretches of the medial axis as polylines with the clearance at each point.
#pragma once

#include <vector>

#include "geometry/voronoi/clearance.h"

namespace clearcut::plan::carve {

/// A stretch of the axis. Between two successive points the clearance (mm) changes linearly.
using Chain = std::vector<AxisPoint>;

/// The point at the share t of the line from a to b, with the clearance there.
AxisPoint part_way(const AxisPoint& a, const AxisPoint& b, double t);

/// The parts of a chain whose clearance is from `low` to `high` mm. A chain of one point is kept or dropped as a
/// whole.
std::vector<Chain> between(const Chain& chain, double low, double high);

/// The same chain with a point added wherever its clearance passes through `clearance` mm.
Chain with_points_at(const Chain& chain, double clearance);

/// Joins chains at common ends into few longer ones, greedily: not always the fewest. Cost O(n log n).
std::vector<Chain> joined(std::vector<Chain> chains);

}  // namespace clearcut::plan::carve
