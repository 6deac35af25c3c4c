// A planned job of design elements.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/design_element.h"
#include "model/runs/plan_result.h"

namespace clearcut::inline model {

/// One planned element.
struct ElementFigures {
  std::string id;
  std::size_t squares = 0;
  std::size_t reduced = 0;
  double visit_mm = 0;  ///< from its first point to its last, in one layer
};

/// Course of the search for one order of visits.
struct VisitSearch {
  std::string solver;      ///< "published" or "modern"
  std::size_t points = 0;  ///< number of ordered points
  double length = 0;       ///< length of the open path found, mm
  /// Generations of the published solver, improvements of Clearcut's own; ascending.
  std::vector<double> step;
  std::vector<double> best;  ///< length of the best path by then, mm
};

struct ElementsResult {
  PlanResult plan;
  PointTable points;
  std::vector<ElementFigures> elements;  ///< in the job's order
  std::vector<VisitSearch> searches;     ///< in the order they were made
};

/// What the published genetic algorithm makes of one element's squares: all of them, and those that the reduction keeps.
struct SquareSearch {
  std::string id;
  std::size_t squares = 0, reduced = 0;
  double all_mm = 0, all_s = 0;  ///< length of the open path, time of the search
  double reduced_mm = 0, reduced_s = 0;
};

}  // namespace clearcut::inline model
