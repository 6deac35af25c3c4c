// Jobs of design elements: interpolated, reduced, visited, and certified like every other plan.
#pragma once

#include <vector>

#include "model/design_element.h"
#include "pipeline/steps/certify.h"
#include "report/picture/grid_picture.h"
#include "report/words/text_table.h"
#include "resolve/values/plan_options.h"

namespace clearcut::pipeline {

/// One planned element.
struct ElementFigures {
  std::string id;
  std::size_t squares = 0;
  std::size_t reduced = 0;
  double visit_mm = 0;  ///< from its first point to its last, in one layer
};

struct ElementsResult {
  PlanResult plan;
  PointTable points;
  std::vector<ElementFigures> elements;       ///< in the job's order
  std::vector<report::VisitSearch> searches;  ///< in the order they were made
};

/// Checks the job, tabulates and reduces its elements, orders the visits, and makes a checked program of them.
/// options: post, machine, tol, seed, time_s (longest search for one order, default 2 s), progress (called before
/// each search), cancel are used; the rest comes from the job. Material left uncut by the reduction is in the
/// findings, as everywhere. Throws InputError with all faults of the job on one line.
ElementsResult plan_elements(const ElementJob& job, const resolve::PlanOptions& options);

/// What the published genetic algorithm makes of one element's squares: all of them, and those that the reduction keeps.
struct SquareSearch {
  std::string id;
  std::size_t squares = 0, reduced = 0;
  double all_mm = 0, all_s = 0;  ///< length of the open path, time of the search
  double reduced_mm = 0, reduced_s = 0;
};

/// Of every element of a tabulated job. Ends as options.published.solver says, else after 1000 generations without gain.
std::vector<SquareSearch> search_squares(const ElementJob& job, const PointTable& points,
                                         const resolve::PlanOptions& options);

/// A row for each.
report::TextTable square_table(const std::vector<SquareSearch>& searches);

/// The elements with their squares, reduced squares and lengths of visit.
report::TextTable element_table(const ElementsResult& result);

}  // namespace clearcut::pipeline
