// Stretches of the medial axis as polylines with the clearance at each point.
#pragma once

#include <vector>

#include "geometry/clearance.h"

namespace clearcut::plan::carve {

/// The clearance between two points goes linearly from one to the other.
using Chain = std::vector<AxisPoint>;

/// The point that divides the line between two.
AxisPoint part_way(const AxisPoint& a, const AxisPoint& b, double t);

/// The parts of a chain where the clearance lies between the two. A chain of one point is such a part or nothing.
std::vector<Chain> between(const Chain& chain, double low, double high);

/// The same chain with points wherever it passes the clearance.
Chain with_points_at(const Chain& chain, double clearance);

/// Chains joined at common ends into as few as a simple walk finds. Cost O(n log n).
std::vector<Chain> joined(std::vector<Chain> chains);

}  // namespace clearcut::plan::carve
