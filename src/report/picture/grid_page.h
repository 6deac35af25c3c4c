// The grid model's working screen as one page: elements and tools, squares before and after, visit, convergence.
#pragma once

#include <string>
#include <vector>

#include "model/design_element.h"
#include "model/move.h"

namespace clearcut::report {

/// Course of the search for one order of visits.
struct VisitSearch {
  std::string solver;      ///< "published" or "modern"
  std::size_t points = 0;  ///< number of ordered points
  double length = 0;       ///< length of the open path found, mm
  /// Generations of the published solver, improvements of Clearcut's own; ascending.
  std::vector<double> step;
  std::vector<double> best;  ///< length of the best path by then, mm
};

/// Shape   one HTML document without network access and without scripts: the job's elements and tools, the squares
///         activated and reduced and the tool's impact (grid_picture), the visit as an animated picture, a
///         convergence graph for each order with search steps, and the table of all points.
/// Units   mm in the part's frame. Cost O(points + moves).
std::string grid_page(const ElementJob& job, const PointTable& table, const Toolpath& toolpath,
                      const std::vector<VisitSearch>& searches);

}  // namespace clearcut::report
