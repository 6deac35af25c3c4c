// Pockets that run into each other: where they meet there is no wall, and the cutter may pass.
#pragma once

#include <vector>

#include "part/part.h"
#include "plan/layer.h"

namespace clearcut {

/// The other features of the workplan that run into the pocket of a workingstep without lying inside it, and are either
/// cut before or begin no higher: over the others more may stand than the pocket's layers are deep. Open features and
/// round holes have none: they are bounded by themselves.
std::vector<const Feature*> features_meeting(const Part& part, int workingstep, const Tolerances& tol);

/// Widens a layer of a pocket by what those features take away at its depth or below, where that lets the cutter reach
/// more of the pocket: up to a diameter beside what is gained. What is added is cut with the layer, whether the other
/// feature comes before or after.
void widen_where_met(Layer& layer, const std::vector<const Feature*>& met, const Tolerances& tol);

}  // namespace clearcut
