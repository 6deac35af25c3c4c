// Height of the top of each feature's material, after the cuts of earlier features.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "model/part.h"

namespace clearcut::features {

/// Sets top_z of every feature, in workplan order, to the height of the material left over its target by earlier
/// features. Reports tops that differ from the declared ones by more than tol.join_gap.
void stack_tops(Part& part, const Tolerances& tol);
/// The same heights, mm, one for each feature, without setting or reporting anything. Features outside the
/// workplan keep their declared top. Slivers thinner than 0.05 mm in the mean do not count. Cost O(features)
/// booleans for each feature at worst.
std::vector<double> stacked_tops(const Part& part, const Tolerances& tol);

}  // namespace clearcut::features
