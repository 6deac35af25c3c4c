// Curves of faces in plan view: selection of those bounding an area, and their order.
#pragma once

#include <string>
#include <vector>

#include "geometry/region.h"
#include "read/repair/repair.h"

namespace clearcut::read {

/// mm. Ends of edges of different faces nearer than this are one point.
inline constexpr double kSamePlace = 1e-4;

/// Indices, ascending, of the curves without a reversed counterpart. Common ends must be equal. O(n log n)
/// while few curves end in one point.
std::vector<std::size_t> unpaired(const std::vector<const Path*>& curves);

/// Joins curves end to start into closed ones as far as they go; the repair sees to the rest. O(n log n).
std::vector<RawCurve> chained(const std::vector<Path>& curves, const std::string& source);

}  // namespace clearcut::read
