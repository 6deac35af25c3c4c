// What the lower bounds in findings are added up from.
#pragma once

#include <vector>

#include "model/part.h"
#include "model/results/findings.h"
#include "model/results/length_bound.h"

namespace clearcut::verify {

/// One for each workingstep with a lower bound in the findings of the part, equal to the bound of its levels.
std::vector<StepLengthBound> length_bounds_of(const Part& part, const Findings& findings);

}  // namespace clearcut::verify
