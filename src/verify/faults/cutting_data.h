// Feeds and speeds beyond any cutter's limits in any material: checks without knowledge of machine and material.
#pragma once

#include <vector>

#include "model/control.h"
#include "verify/program/checked_move.h"
#include "verify/program/verify_options.h"

namespace clearcut::verify {

/// At most one of each: `chip-load`, if a tooth takes more than any tooth can, or so little that it only rubs;
/// `cutting-speed`, if an edge runs faster than any usual speed. Each names the worst cutting move. For taps, whose
/// feed follows their pitch, only the stated speed is checked. `stated-feed` and `stated-speed` if a tool runs at
/// more than 1.5 times the stated value (options.stated), or at less than half of the stated speed. With
/// options.speed_may_be_power an S word up to 255 is not taken as a spindle speed.
///
/// Source  of the bounds: docs/verification.md, "Feeds and speeds".
std::vector<Condition> doubtful_cutting_data(const CheckedProgram& program, const VerifyOptions& options);

}  // namespace clearcut::verify
