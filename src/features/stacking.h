// Where each feature's material begins, given what was cut before it.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "model/part.h"

namespace clearcut::features {

/// Sets top_z of every feature, in workplan order, to the height of the material that the features before it
/// leave over its target. Reports where that differs from the declared top by more than tol.join_gap.
void stack_tops(Part& part, const Tolerances& tol);
/// The same heights, mm, one for each feature, without setting or reporting anything. Features outside the
/// workplan keep their declared top. Slivers thinner than 0.05 mm in the mean do not count. Cost O(features)
/// booleans for each feature at worst.
std::vector<double> stacked_tops(const Part& part, const Tolerances& tol);

}  // namespace clearcut::features
