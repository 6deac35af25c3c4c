// The entry of this strategy in the table of strategies.
#pragma once

#include <functional>

#include "model/options/strategy_entry.h"
#include "plan/tour/tour.h"

namespace clearcut::plan::tour {

/// `solver_for` makes the search for the order of the grid's points.
StrategyEntry entry(std::function<TourSolver(const StrategyRequest&)> solver_for);

}  // namespace clearcut::plan::tour
