// Whether the tabs of profiles stand, and how high.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "verify/checked_move.h"

namespace clearcut::verify {

/// One fault for each tab that is cut away, or whose middle is lower or higher than asked for by more than
/// tol.uncut. What is cut from its sides is a gouge and what stands beside it is uncut, which other checks
/// find. Cost O(tabs * moves).
std::vector<Fault> faults_of_tabs(const Part& part, const CheckedProgram& program, const Tolerances& tol);

}  // namespace clearcut::verify
