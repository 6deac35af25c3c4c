// The faults reported to people.
#pragma once

#include <vector>

#include "model/results/findings.h"

namespace clearcut::inline model {

/// Faults without a cause among the others, the worst first; faults caused by one of them are counted in its
/// sentence.
std::vector<Fault> told_faults(const Findings& findings);

}  // namespace clearcut::inline model
