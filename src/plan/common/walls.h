// A finishing pass along every wall, planned after the area between them has been cleared.
#pragma once

#include "base/tolerances.h"
#include "model/layer.h"

namespace clearcut::plan {

/// A closed pass on each boundary of the legal area, tool_radius + wall_stock off the wall and oriented as
/// contours are, and a pass on each line on which the cutter just fits. Costs one offset.
LayerPasses plan_walls(const Layer& layer, const Tolerances& tol);

}  // namespace clearcut::plan
