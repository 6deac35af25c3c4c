// Loops that do not cross become regions by their depth of nesting.
#pragma once

#include <vector>

#include "geometry/region.h"

namespace clearcut {

/// A point inside `loop`, as far from it as a short search finds.
Vec2 inner_point(const Loop& loop);

/// For every loop how many of the others it lies in. The loops must not cross; they may touch.
/// Cost O(n log n + n k), k loops about one place.
std::vector<int> nesting_depths(const std::vector<Loop>& loops);

/// Regions by the even-odd rule: loops at even depth are outlines, each with the loops just inside it as
/// islands. In the order of the outlines.
Regions nested(const std::vector<Loop>& loops);

}  // namespace clearcut
