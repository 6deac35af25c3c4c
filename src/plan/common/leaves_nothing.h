// Whether the passes of a layer clear all that the cutter can reach: asked where no later look at the part would tell.
#pragma once

#include "model/pass.h"

namespace clearcut::plan {

/// Whether no place of the target at which the centre of the cutter may stand is farther from the passes than its radius,
/// in mm. Thinner residuals than rings leave that exactly meet do not count. Cost: one search for holes in what is swept.
bool leaves_nothing(const LayerPasses& passes, double tool_radius);

}  // namespace clearcut::plan
