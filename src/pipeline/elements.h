// Jobs of design elements: interpolated, reduced, visited, and certified like every other plan.
#pragma once

#include <vector>

#include "model/design_element.h"
#include "pipeline/steps/plan_result.h"
#include "report/picture/grid_page.h"
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

/// The elements with their squares, reduced squares and lengths of visit.
report::TextTable element_table(const ElementsResult& result);

}  // namespace clearcut::pipeline
