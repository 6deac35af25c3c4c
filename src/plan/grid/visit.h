// From design elements to points, and from points to the path of the tool through them.
#pragma once

#include <functional>
#include <vector>

#include "model/design_element.h"

namespace clearcut::plan::grid {

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
