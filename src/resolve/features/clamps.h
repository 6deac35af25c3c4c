// Clamps, and other blocks that the cutter must keep out of, beside the features to be cut.
#pragma once

#include "base/tolerances.h"
#include "model/part.h"

namespace clearcut::resolve {

/// Takes the plan views of all blocks higher than a feature's floor out of the area allowed to its cutter, as wide as
/// shank and holder need it. Beside them the cutter leaves what its radius does not reach. Cost one boolean for each
/// block near a feature.
void keep_out_of_clamps(Part& part, const Tolerances& tol);

/// Throws InputError if such a block stands on what the step is to cut.
void refuse_under_clamps(const Part& part, const Workingstep& step);

}  // namespace clearcut::resolve
