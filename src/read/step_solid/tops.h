// Tops of the features of a solid, and removal of features not worth a cut.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "model/part.h"

namespace clearcut::read {

/// Sets top_z of every feature to the height left by earlier ones, and removes features then no deeper than a
/// permitted gouge: the checks ignore walls of this height, and no cutter follows them. Returns the removed features,
/// in the same order.
std::vector<Feature> settle_tops(std::vector<Feature>& features, const Stock& stock, const Tolerances& tol);

}  // namespace clearcut::read
