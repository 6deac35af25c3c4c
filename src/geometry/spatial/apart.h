// Whether two areas keep apart, without the cost of a boolean.
#pragma once

#include "geometry/region.h"

namespace clearcut::inline geometry {

/// True only if no point of one lies in the other, nor nearer to it than `gap` mm: their intersection is then empty, and either
/// without the other is itself. May be false all the same.
///
/// Method  Edges near the boxes' common part are compared by their boxes in one sweep along x; where none come near each
///         other, areas that meet hold one another whole. O(n log n) where edges are short.
bool are_apart(const Regions& a, const Regions& b, double gap);

}  // namespace clearcut::inline geometry
