// Holes against what they are to be: by the moves of the tools that make them, and what the control held meanwhile.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "verify/program/checked_move.h"
#include "verify/program/verify_options.h"

namespace clearcut::verify {

/// Checks every hole that has to be more than a cylinder:
///
/// Drilled      The full diameter reaches down to the hole's depth; the drill's point does not count.
/// Spots, countersinks  The cone is wide enough at the top.
/// Taps         Place, size, hand and depth of the tap, feed = pitch * speed, and turning back on the way out.
/// Threads      See thread_helix.h.
///
/// What is cut too deep or too wide is a gouge (see gouge.h). Cost O(holes * moves near them).
std::vector<Fault> faults_of_holes(const Part& part, const CheckedProgram& program,
                                   const VerifyOptions& options);

}  // namespace clearcut::verify
