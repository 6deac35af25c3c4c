// One turn of a spiral: from a loop to the one around it, evenly. Used by the planner alone.
#pragma once

#include <functional>

#include "geometry/region.h"

namespace clearcut::plan::spiral {

/// Share of the way round on which a turn falls from one loop to the next; on the rest it runs along the next. At 1
/// turns would be even, and the wall had to be followed twice all round.
inline constexpr double kSpiralFall = 0.3;

/// The way from `start`, a place on the next loop inwards, once round `loop` in its sense to the place of `loop` nearest
/// to `start`, where it ends. Its distance from `loop` falls evenly from that of `start` to 0 on the first part of the
/// way. A turn is nowhere farther from the turn before than their loops are, because both fall at the same place.
///
/// Method  Beside each edge of `loop` on the left at that distance, and about each corner that sticks out, runs a piece of
///         what may bound the loop widened by that distance. The turn goes along them from the first on, and at each
///         meeting on to the later one: so edges that vanish on the way in need no care.
/// Error   arcs of changing radius are arcs through three of their places, at most 30 degrees each (0.1 % of the step).
///         Empty when the loop cannot be followed; it should then be reached straight, and cut as it is.
/// Cost    O(n log n) in edges.
Path spiral_turn(const Loop& loop, Vec2 start);

/// The loop from the place nearest to `start` once round, or as far as `share` of its length.
Path lap(const Loop& loop, Vec2 start, double share = 1);

/// Goes on with `more`: from where the path ends, exactly, and by a line where that is farther away than rounding.
void append(Path& path, const Path& more);

/// Corners become arcs of at most `radius` that touch both edges, except where `sharp` says so and where edges are too
/// short.
Path with_round_corners(const Path& path, double radius, const std::function<bool(Vec2)>& sharp);

}  // namespace clearcut::plan::spiral
