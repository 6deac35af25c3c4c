// Jobs of design elements: interpolated, reduced, visited, and certified like every other plan.
#pragma once

#include <vector>

#include "model/design_element.h"
#include "model/runs/elements_result.h"
#include "pipeline/steps/certify.h"
#include "report/picture/grid_picture.h"
#include "report/words/text_table.h"
#include "resolve/values/plan_options.h"

namespace clearcut::pipeline {

/// Checks the job, tabulates and reduces its elements, orders the visits, and makes a checked program of them.
/// options: post, machine, tol, seed, time_s (longest search for one order, default 2 s), progress (called before
/// each search), cancel are used; the rest comes from the job. Material left uncut by the reduction is in the
/// findings, as everywhere. Throws InputError with all faults of the job on one line.
ElementsResult plan_elements(const ElementJob& job, const PlanOptions& options);

/// Of every element of a tabulated job. Ends as options.published.solver says, else after 1000 generations without gain.
std::vector<SquareSearch> search_squares(const ElementJob& job, const PointTable& points,
                                         const PlanOptions& options);

/// A row for each.
TextTable square_table(const std::vector<SquareSearch>& searches);

/// The elements with their squares, reduced squares and lengths of visit.
TextTable element_table(const ElementsResult& result);

}  // namespace clearcut::pipeline
