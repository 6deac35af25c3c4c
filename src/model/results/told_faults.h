// The faults that people are told.
#pragma once

#include <vector>

#include "model/results/findings.h"

namespace clearcut::inline model {

/// Those that stand alone, the worst first; those that follow from one of them are counted in its sentence.
std::vector<Fault> told_faults(const Findings& findings);

}  // namespace clearcut::inline model
