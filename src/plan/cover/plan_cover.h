// Cover passes: one short path for what may be left by the cutter, such as faces and open blocks.
#pragma once

#include "base/tolerances.h"
#include "model/layer.h"
#include "model/pass.h"
#include "plan/cover/shortest_cover.h"

namespace clearcut::plan::cover {

/// Plans the passes of one layer. `corner_price`: mm of path that a corner counts as.
///
/// Shape   One open pass for each connected legal area, the shortest that the search finds, then passes along the walls, if
///         there are any. Empty if the cutter fits nowhere.
/// Error   Nothing reachable of the target is left.
/// Throws  InputError where the area is more than kMostSquares square diameters, or cannot be cleared so.
/// Cost    As `effort` says, for each connected area.
LayerPasses plan_cover(const Layer& layer, double corner_price, const CoverEffort& effort,
                       const Tolerances& tol);

/// Square diameters, of the largest area that is searched.
inline constexpr double kMostSquares = 10000;

}  // namespace clearcut::plan::cover
