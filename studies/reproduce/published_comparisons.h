// Grids made as the Tour text makes them, and orders of them for its tables. The papers' comparisons of methods,
// beside ours. Their outlines are not printed: ours stand in, and the tables say so.
#pragma once

#include <functional>

#include "order/search/solve.h"
#include "plan/tour/tour.h"
#include "studies/reproduce/reproduction.h"

namespace clearcut::studies {

/// By rounds and never by the clock, so that tables repeat.
order::Solution solved(const order::Problem& problem, const order::Objective& objective, std::uint64_t seed,
                       long long rounds = 4);

/// Hands the grids of a layer, one for each connected legal area, to `answer`.
void ask_published(const Layer& layer, double pitch_mm, const plan::tour::TourSolver& answer);

/// The largest of them. Its legal ways can be asked for only inside `use`. False where no grid has a point.
bool with_largest_grid(const Layer& layer, double pitch_mm,
                       const std::function<void(const plan::tour::TourTask&)>& use);

/// CPO-kappa table 1: lengths of the proposed method, of bisector segments and of loops on a concave and a convex outline.
Reproduction length_comparison();

/// CPO-rho table 3: cutting times (eq. 9) of eleven cutters on a polygon of inscribed radius 20.46 mm.
Reproduction cutter_comparison();

/// The same, which is faster at which feed.
Reproduction cutter_trend();

}  // namespace clearcut::studies
