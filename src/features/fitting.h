// The widest cutter that fits into a feature.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "model/part.h"

namespace clearcut::features {

/// Diameter of the largest cutter that has a legal position over the feature's floor, mm; 0 when none. At open
/// sides only places over the feature itself count.
double largest_fitting_diameter(const Feature& feature, const Tolerances& tol);

/// For each feature the diameter of the largest cutter worth trying, mm: as above; for features with open sides also
/// a wider cutter that enters from outside and reaches nine tenths of the floor. Features in a row with the same
/// walls share the work.
std::vector<double> largest_cutters(const Part& part, const Tolerances& tol);

}  // namespace clearcut::features
