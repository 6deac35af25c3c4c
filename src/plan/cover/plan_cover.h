// Cover passes, one short path for areas that the cutter may leave, such as faces and open blocks, and their entry in
// the table of strategies.
#pragma once

#include "base/tolerances.h"
#include "model/layer.h"
#include "model/options/strategy_entry.h"
#include "plan/cover/shortest_cover.h"

namespace clearcut::plan::cover {

/// Plans the passes of one layer. `corner_price`: cost of a corner in mm of path.
///
/// Shape   One open pass for each connected legal area, the shortest one found by the search, then passes along the
///         walls, if there are any. Empty if the cutter fits nowhere.
/// Error   Nothing reachable of the target is left.
/// Throws  InputError if the area is more than kMostSquares square diameters, or cannot be cleared this way.
/// Cost    Given by `effort`, which connected areas share by their size.
LayerPasses plan_cover(const Layer& layer, double corner_price, const CoverEffort& effort,
                       const Tolerances& tol);

/// Size of the largest searched area, in square diameters.
inline constexpr double kMostSquares = 10000;

StrategyEntry entry();

}  // namespace clearcut::plan::cover
