// The widest cutter that fits into a feature.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "model/part.h"

namespace clearcut::features {

/// Diameter of the largest cutter that has a legal position over the feature's floor, mm; 0 when none. At open
/// sides only places over the feature itself count.
double largest_fitting_diameter(const Feature& feature, const Tolerances& tol);

/// Whether the cutter can go down into the feature at all: where it may not plunge it needs room for a ramp or a small circle, unless the
/// feature is open at a side. Holes that are there before are left out of account.
bool has_room_to_enter(const Feature& feature, const Tool& tool, const Tolerances& tol);

/// For each feature the diameter of the largest cutter that is worth a try, mm: as above, and where sides are open also a wider one that
/// comes in from outside and reaches nine tenths of the floor. Features in a row with the same walls share the work.
std::vector<double> largest_cutters(const Part& part, const Tolerances& tol);

}  // namespace clearcut::features
