// A lower bound for turns with moves in any direction: the least number of straight lines covering all points.
#pragma once

#include <functional>

#include "order/lattice.h"

namespace clearcut::order {

/// Lower bound of the turns of any path or tour through all points, with any moves. `is_legal` returns whether the
/// straight move between two points stays inside; lines end where it does not. Legal detours are straight pieces too,
/// so they count.
///
/// A path of R straight pieces has R - 1 turns (closed: R). Each piece is on a line of points, and two that follow
/// each other on different ones or in one and the same, so no direction has more than half of the lines, (R + 1) / 2
/// in a path. For any weights w of the points, with M1 >= M2 the heaviest lines of two directions:
///     sum w <= M1 (R + 1) / 2 + M2 (R - 1) / 2.
/// The weights are found by multiplicative updates, any serve. Cost O(iterations * points * directions), bounded;
/// deterministic.
int line_cover_bound(const Lattice& lattice, bool closed, const std::function<bool(int, int)>& is_legal);

}  // namespace clearcut::order
