// Whether two areas keep apart, without the cost of a boolean.
#pragma once

#include "geometry/region.h"

namespace clearcut::inline geometry {

/// True only if no point of one area is in the other, nor nearer to the other than `gap` mm: the intersection is then
/// empty, and subtracting either from the other changes nothing. May return false although this is true.
///
/// Method  Edges near the boxes' common part are compared by their boxes in one sweep along x; if no edges come near
///         each other, either the areas are apart or one contains the other. O(n log n) for short edges.
bool are_apart(const Regions& a, const Regions& b, double gap);

}  // namespace clearcut::inline geometry
