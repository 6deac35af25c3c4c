// Profiles: the cutter's centre at its radius from an outline, or on a line.
#pragma once

#include "base/tolerances.h"
#include "model/layer.h"

namespace clearcut::plan::profile {

/// Passes along the profile, one loop where nothing is in the way, and open ones between tabs. Cost that of one inset of
/// layer.allowed, and the edges of both outlines multiplied.
LayerPasses plan_profile(const Layer& layer, const ProfileCut& cut, const Tolerances& tol);

}  // namespace clearcut::plan::profile
