// Holes against what they are to be: by the moves of the tools that make them, and what the control held meanwhile.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "verify/checked_move.h"
#include "verify/verify.h"

namespace clearcut::verify {

/// For every hole of which more is asked than a cylinder:
///
/// Drilled      its full diameter down to its depth, the drill's point taken off.
/// Spots, countersinks  the cone's width at the top.
/// Taps         place, size, hand and depth of the tap, its feed against the speed, its turning back on the way out.
/// Threads      see thread_helix.h.
///
/// What goes too deep or too wide is a gouge, which is found beside this. Cost O(holes * moves near them).
std::vector<Fault> faults_of_holes(const Part& part, const JudgedProgram& program,
                                   const VerifyOptions& options);

}  // namespace clearcut::verify
