// Checks holes against their required shapes: by the moves of their tools, and the state of the control meanwhile.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "verify/program/checked_move.h"
#include "verify/program/verify_options.h"

namespace clearcut::verify {

/// Checks every hole requiring more than a cylinder:
///
/// Drilled      The full diameter reaches down to the hole's depth; the drill's point does not count.
/// Spots, countersinks  The cone is wide enough at the top.
/// Taps         Place, size, hand and depth of the tap, feed = pitch * speed, and reversal for the retract.
/// Threads      See thread_helix.h.
///
/// Cuts too deep or too wide are gouges (see gouge.h). Cost O(holes * moves near them).
std::vector<Fault> faults_of_holes(const Part& part, const CheckedProgram& program,
                                   const VerifyOptions& options);

}  // namespace clearcut::verify
