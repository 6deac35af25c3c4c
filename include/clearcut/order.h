// Tours over points under any cost: solve_tour() for files and lattices by name, solve_order() for problems of one's own.
#pragma once

#include "order/genetic/operators.h"
#include "order/search/solve.h"
#include "pipeline/tour/tour.h"

namespace clearcut {

using pipeline::solve_tour;
using pipeline::tour_json;
using pipeline::tour_line;
using pipeline::tour_svg;
using pipeline::TourOptions;
using pipeline::TourResult;
using pipeline::TourSample;

/// Orders the points of a problem, with a proven bound; see order::solve. Throws InputError for problems that contradict
/// themselves.
inline order::Solution solve_order(const order::Problem& problem, const order::Objective& objective,
                                   const order::SolveOptions& options) {
  return order::solve(problem, objective, options);
}

}  // namespace clearcut
