// Non-crossing loops become regions by their depth of nesting.
#pragma once

#include <vector>

#include "geometry/region.h"

namespace clearcut::read {

/// A point inside `loop`, as far from the loop as found by a short search.
Vec2 inner_point(const Loop& loop);

/// For every loop the loops around it, from the largest to the smallest. The loops must not cross;
/// they may touch. Cost O(n log n + n k), k edges level with one place.
std::vector<std::vector<int>> loops_about(const std::vector<Loop>& loops);

/// Regions by the even-odd rule: loops at even depth are outlines, each with the loops directly inside as islands. In
/// the order of the outlines.
Regions nested(const std::vector<Loop>& loops);

}  // namespace clearcut::read
