// Neighbours that cross again near their joint: an arc drawn nearly tangent to its line.
#pragma once

#include <vector>

#include "read/repair/joining.h"

namespace clearcut::read {

/// Neighbours that meet a second time are joined there, and the sliver between is gone, when it is no
/// thicker than tol.join_gap. Reports each with its thickness. Cost O(n).
void trim_joints(std::vector<RawLoop>& loops, const RepairOptions& options, Diagnostics& diagnostics);

}  // namespace clearcut::read
