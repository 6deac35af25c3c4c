// From elements to points, and from points to the way the tool visits them.
#pragma once

#include <functional>
#include <vector>

#include "model/design_element.h"

namespace clearcut::plan::grid {

/// The decision maker's table of a checked job: every square of every element, the reduced ones marked.
PointTable tabulate(const ElementJob& job);

/// An order of visits that makes the open path through the points short: their places.
using VisitSolver = std::function<std::vector<int>(const std::vector<Vec2>&)>;

/// One element's visits.
struct ElementVisit {
  std::size_t element = 0;          ///< place in the job's elements
  std::vector<std::size_t> points;  ///< places in the table, in order of visit
  /// Through the points: straight, on arcs along the arc. A single point gives one edge without length.
  Path path;
};

/// Elements of one tool follow each other, tools in the job's order; within an element and among the elements
/// of a tool the solver decides, then each element's direction is chosen for the shortest path between them.
/// Sets GridPoint::visit.
std::vector<ElementVisit> plan_visits(const ElementJob& job, PointTable& table, const VisitSolver& solve);

}  // namespace clearcut::plan::grid
