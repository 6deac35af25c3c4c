// Tests whether the passes of a layer clear everything within the cutter's reach; used if no later check of the part
// would find residuals.
#pragma once

#include "model/pass.h"

namespace clearcut::plan {

/// Whether every place of the target within the legal area of the cutter's centre is within the tool radius (mm) of
/// the passes. Residuals thinner than those between exactly meeting rings do not count. Cost: one search for holes in
/// the swept area.
bool leaves_nothing(const LayerPasses& passes, double tool_radius);

}  // namespace clearcut::plan
