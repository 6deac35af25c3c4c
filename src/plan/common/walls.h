// One pass along every wall: what finishes them once the middle is cleared.
#pragma once

#include "base/tolerances.h"
#include "model/layer.h"

namespace clearcut::plan {

/// The boundary of the legal area at tool_radius + wall_stock, each loop a closed pass oriented as contours are, and the
/// lines on which the cutter just fits. Cost of one offset.
LayerPasses plan_walls(const Layer& layer, const Tolerances& tol);

}  // namespace clearcut::plan
