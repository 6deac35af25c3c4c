// Where the material of each feature of a solid begins, and which have none worth a cut.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "model/part.h"

namespace clearcut::read {

/// Sets top_z of every feature to the height that those before it leave, and takes out those which are then no deeper than what counts
/// as no gouge: to the checks, walls as low as that are none, and no cutter follows them. What is taken out, in the same order.
std::vector<Feature> settle_tops(std::vector<Feature>& features, const Stock& stock, const Tolerances& tol);

}  // namespace clearcut::read
