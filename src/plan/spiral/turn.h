// One turn of a spiral: from a loop to the loop around it, at an even rate.
#pragma once

#include <functional>

#include "geometry/region.h"

namespace clearcut::plan::spiral {

/// Share of a turn on which it goes over from one loop to the next; on the rest it follows the next loop. At
/// 1 turns would be even all round, but the wall would have to be followed once more.
inline constexpr double kSpiralFall = 0.3;

struct SpiralTurn {
  Path path;  ///< empty where there is none
  double reached =
      0;  ///< mm along the loop, from its place nearest to the turn's start, to where the turn is on it
};

/// The path from `start`, a place on the next loop inwards, once round `loop` in its direction to the place
/// of `loop` nearest to `start`. Its distance from `loop` decreases evenly from that of `start` to 0 on the
/// first part. A turn is nowhere farther from the turn before than their loops are from each other, because
/// both go over at the same place.
///
/// Method  Left of each edge of `loop` at that distance, and about each corner that points into the area,
///         lies a piece of the rim of the loop widened by that distance. The turn follows these pieces in
///         order and goes over to a later piece where they intersect, so that edges which vanish inwards need
///         no rule of their own.
/// Error   Arcs of changing radius are replaced by arcs through three of their points, at most 30 degrees
///         each (0.1 % of the step). Empty if the loop cannot be followed; it should then be reached on a
///         straight path and cut as it is.
/// Cost    O(n log n) in edges.
SpiralTurn spiral_turn(const Loop& loop, Vec2 start);

/// The loop from its place nearest to `start` once round.
Path lap(const Loop& loop, Vec2 start);

/// Continues `path` with `more`, which is made to begin exactly at the path's end; adds a line if they are
/// farther apart than rounding.
void append(Path& path, const Path& more);

/// Replaces corners by arcs of at most `radius` mm that touch both edges, except where `sharp` is true and
/// where edges are too short.
Path with_round_corners(const Path& path, double radius, const std::function<bool(Vec2)>& sharp);

}  // namespace clearcut::plan::spiral
