// Loops that do not cross become regions by their depth of nesting.
#pragma once

#include <vector>

#include "geometry/region.h"

namespace clearcut::read {

/// A point inside `loop`, as far from it as a short search finds.
Vec2 inner_point(const Loop& loop);

/// For every loop the loops that it lies in, from the largest to the smallest. The loops must not cross;
/// they may touch. Cost O(n log n + n k), k edges level with one place.
std::vector<std::vector<int>> loops_about(const std::vector<Loop>& loops);

/// Regions by the even-odd rule: loops at even depth are outlines, each with the loops just inside it as
/// islands. In the order of the outlines.
Regions nested(const std::vector<Loop>& loops);

}  // namespace clearcut::read
