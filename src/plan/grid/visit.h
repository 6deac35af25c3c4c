// From design elements to points, and from points to the path of the tool through them. The reductions of the grid
// model: the squares of an element that the cutter must visit. Sources: the grid paper, section III (EPSA, LCERA,
// RPERA); Tour section 3.3.4. See docs/grid.md.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "model/design_element.h"

namespace clearcut::plan::grid {

/// Indices into a list of squares.
using Places = std::vector<std::size_t>;

/// The squares along the four edges of a rectangle. Corners belong to left and right only.
struct ElementEdges {
  Places left, right, lower, upper;
};

/// Edge point search (EPSA): finds the edges of squares listed row by row, from whether three successive
/// squares are adjacent and collinear. At least two rows of at least two squares. O(n).
ElementEdges find_edges(const std::vector<Square>& squares);

/// Linear and circular element reduction (LCERA): from both ends inwards, repeatedly the nearest square at or
/// beyond the tool's periphery. The ends are not kept: the element ends there, and the tool's centre stays a
/// radius away. `radius` is measured in squares. Ascending indices; empty if the element is too short. O(n^2
/// / radius).
Places reduce_curve(const std::vector<Square>& squares, double radius);

/// Number of squares by which an edge moves inwards each time: the tool's radius in squares, rounded up, at least
/// one.
int edge_step(double radius);

/// The rows kept between the edge rows `low` and `high`: both move inwards by `step` squares until
/// they meet (the paper's d1 = d2 = step, d3 by `rule`). Ascending.
std::vector<int> kept_rows(int low, int high, int step, MiddleRow rule);

/// Rectangular pocket reduction (RPERA): first the lower and upper edges move inwards, then the left and
/// right ones of the kept squares. `radius` is measured in squares and rounded up, so that rows along walls stay
/// complete. Ascending indices. O(n).
Places reduce_rectangle(const std::vector<Square>& squares, double radius, MiddleRow rule);

/// The squares with one of the four neighbours missing in the list. O(n log n).
Places boundary_of(const std::vector<Square>& squares);
/// First phase of Tour's reduction: keeps squares off the boundary, no two of them neighbours (of four).
Places reduce_neighbours(const std::vector<Square>& squares);
/// Both phases of Tour's reduction: no two kept squares are nearer than `radius` squares, the boundary is
/// kept first, and every square of the list is nearer than `radius` + 1 to a kept one. Ascending indices. O(n
/// radius^2).
Places reduce_area(const std::vector<Square>& squares, double radius);

/// The table of all squares of all elements of a checked job, the reduced ones marked (the paper's decision
/// maker).
PointTable tabulate(const ElementJob& job);

/// Finds an order with a short open path through the points; returns their indices.
using VisitSolver = std::function<std::vector<int>(const std::vector<Vec2>&)>;

/// Visit of one element.
struct ElementVisit {
  std::size_t element = 0;          ///< index in the job's elements
  std::vector<std::size_t> points;  ///< indices in the table, in order of visit
  /// Through the points: lines, for arc elements arcs. For a single point one edge without length.
  Path path;
};

/// Orders all visits and sets GridPoint::visit. Elements of one tool come together, tools in the job's order.
/// The solver orders the points of an element and the elements of a tool; then each element's direction is
/// chosen to make the paths between elements shortest.
std::vector<ElementVisit> plan_visits(const ElementJob& job, PointTable& table, const VisitSolver& solve);

}  // namespace clearcut::plan::grid
