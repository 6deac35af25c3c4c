// Grids made as the Tour text makes them, and orders of them for its tables.
#pragma once

#include <functional>

#include "order/search/solve.h"
#include "plan/tour/tour.h"

namespace clearcut::studies {

/// By rounds and never by the clock, so that tables repeat.
order::Solution solved(const order::Problem& problem, const order::Objective& objective, std::uint64_t seed,
                       long long rounds = 4);

/// Hands the grids of a layer, one for each connected legal area, to `answer`.
void ask_published(const Layer& layer, double pitch_mm, const plan::tour::TourSolver& answer);

/// The largest of them. Its legal ways can be asked for only inside `use`. False where no grid has a point.
bool with_largest_grid(const Layer& layer, double pitch_mm,
                       const std::function<void(const plan::tour::TourTask&)>& use);

}  // namespace clearcut::studies
