// One turn of a spiral, from a loop to the loop around it at an even rate, and chains of nested offset loops, each
// with the loop next inside.
#pragma once

#include <functional>
#include <vector>

#include "geometry/region.h"
#include "plan/common/rings.h"

namespace clearcut::plan::spiral {

/// Loops following each other inwards one to one, the outermost first. A neck, or a loop touching another, ends a
/// chain.
struct SpiralChain {
  std::vector<Loop> loops;  ///< oriented as in their regions: the area to be cleared is on the left
  /// Index of the chain of the loop around the outermost; -1: the outermost is of the first level.
  int parent = -1;
};

struct SpiralChains {
  std::vector<SpiralChain> chains;  ///< parents come before their children
  std::vector<int> chain_of_node;   ///< for each node of the ring tree: index of the chain of its outer loop
};

/// Sorts the loops of a ring tree into chains. Costs O(loops^2) of neighbouring nodes.
SpiralChains spiral_chains(const std::vector<RingNode>& nodes);

/// Share of a turn used for the transition from one loop to the next; the rest follows the next loop. At 1 turns
/// would be even all round, but the wall would have to be followed once more.
inline constexpr double kSpiralFall = 0.3;

struct SpiralTurn {
  Path path;  ///< empty if there is none
  /// mm along the loop, from its place nearest to the turn's start, to the point at which the turn reaches the loop.
  double reached = 0;
};

/// The path from `start`, a place on the next loop inwards, once round `loop` in its direction to the place
/// of `loop` nearest to `start`. Its distance from `loop` decreases evenly from that of `start` to 0 on the
/// first part. The distance of a turn from the previous turn nowhere exceeds that of their loops, because both have
/// their transition at the same place.
///
/// Method  Left of each edge of `loop` at this distance, and about each corner pointing into the area, is a piece of
///         the rim of the loop widened by this distance. The turn follows these pieces in order and changes to a
///         later piece at their intersection, so that edges vanishing inwards need no rule of their own.
/// Error   Arcs of changing radius are replaced by arcs through three of their points, at most 30 degrees
///         each (0.1 % of the step). Empty if the loop cannot be followed; the loop should then be reached on a
///         straight path and cut unchanged.
/// Cost    O(n log n) in edges.
SpiralTurn spiral_turn(const Loop& loop, Vec2 start);

/// The loop from its place nearest to `start` once round.
Path lap(const Loop& loop, Vec2 start);

/// Continues `path` with `more`, whose start is moved exactly to the path's end; adds a line if the two are farther
/// apart than rounding.
void append(Path& path, const Path& more);

/// Replaces corners by arcs of at most `radius` mm tangent to both edges, except at corners for which `sharp` is true
/// or edges are too short.
Path with_round_corners(const Path& path, double radius, const std::function<bool(Vec2)>& sharp);

}  // namespace clearcut::plan::spiral
