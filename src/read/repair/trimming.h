// Neighbours crossing again near their joint: an arc drawn nearly tangent to its line.
#pragma once

#include <vector>

#include "read/repair/joining.h"

namespace clearcut::read {

/// Neighbours meeting a second time are joined there, without the sliver between, if it is no thicker than
/// tol.join_gap. Reports each with its thickness. Cost O(n).
void trim_joints(std::vector<RawLoop>& loops, const RepairOptions& options, Diagnostics& diagnostics);

}  // namespace clearcut::read
