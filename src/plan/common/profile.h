// Profiles: the cutter's centre follows an outline at its radius, or a line.
#pragma once

#include "base/tolerances.h"
#include "model/layer.h"

namespace clearcut::plan {

/// The passes along the profile: one loop if nothing blocks it, else open passes, between tabs too. Costs
/// one inset of layer.allowed, and the product of the edges of both outlines.
LayerPasses plan_profile(const Layer& layer, const ProfileCut& cut, const Tolerances& tol);

}  // namespace clearcut::plan
