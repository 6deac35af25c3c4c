// The widest cutter that fits into a feature.
#pragma once

#include "base/tolerances.h"
#include "model/part.h"

namespace clearcut::stock {

/// Diameter of the largest cutter that has a legal position over the feature's floor, mm; 0 when none. At open
/// sides only places over the feature itself count.
double largest_fitting_diameter(const Feature& feature, const Tolerances& tol);

}  // namespace clearcut::stock
