// The reductions of the grid model: which of an element's squares the tool has to visit.
// Sources: the grid paper, section III (EPSA, LCERA, RPERA); Tour section 3.3.4. See docs/grid.md.
#pragma once

#include <cstddef>
#include <vector>

#include "model/design_element.h"

namespace clearcut::plan::grid {

/// Places in a list of squares.
using Places = std::vector<std::size_t>;

/// The edges of a rectangle's squares. Corners belong to left and right alone.
struct ElementEdges {
  Places left, right, lower, upper;
};

/// Edge point search (EPSA): from squares row by row, by adjacency and collinearity of three in succession.
/// Rows have at least two squares, and there are at least two rows. O(n).
ElementEdges find_edges(const std::vector<Square>& squares);

/// Linear and circular element reduction (LCERA): from both ends inwards, of the squares at or beyond the
/// tool's periphery the nearest to it. The ends themselves are not kept: there the element ends, and the
/// tool's centre stays its radius away. Ascending places; empty when the element is too short. `radius` in
/// squares. O(n^2 / radius).
Places reduce_curve(const std::vector<Square>& squares, double radius);

/// How many squares an edge moves inwards at a time: the tool's radius, rounded up, at least one.
int edge_step(double radius);

/// The rows kept between the edge rows `low` and `high`: both move inwards by `step` squares until they meet
/// (d1 = d2 = step, d3 by the rule). Ascending.
std::vector<int> kept_rows(int low, int high, int step, MiddleRow rule);

/// Rectangular pocket reduction (RPERA): lower and upper edges inwards first, then left and right ones of
/// what was kept. `radius` in squares; where it is not whole the next whole number is taken, so that walls
/// stay whole. Ascending places. O(n).
Places reduce_rectangle(const std::vector<Square>& squares, double radius, MiddleRow rule);

/// Squares with a neighbour (of four) that is not in the list. O(n log n).
Places boundary_of(const std::vector<Square>& squares);
/// First phase of Tour's reduction: of the squares off the boundary no two are neighbours (of four).
Places reduce_neighbours(const std::vector<Square>& squares);
/// Both phases: then no two are nearer than `radius` squares, the boundary being kept first; every square of
/// the list is nearer than `radius` + 1 to one that was kept. Ascending places. O(n radius^2).
Places reduce_area(const std::vector<Square>& squares, double radius);

}  // namespace clearcut::plan::grid
