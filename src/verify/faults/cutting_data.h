// Feeds and speeds that no cutter bears, whatever it cuts: what can be said without knowing the machine and the material.
#pragma once

#include <vector>

#include "model/control.h"
#include "verify/program/checked_move.h"
#include "verify/program/verify_options.h"

namespace clearcut::verify {

/// At most one of each: `chip-load`, where a tooth takes more than any tooth takes, or so little that it only rubs;
/// `cutting-speed`, where an edge runs faster than anybody lets edges run. Each names the worst move that cuts. Of taps, whose feed follows
/// their pitch, the stated speed alone is asked. `stated-feed` and `stated-speed` where a tool is driven by half as much again as somebody has stated
/// (options.stated), or at less than half of that speed. With options.speed_may_be_power an S word up to 255 says nothing about the spindle's turns.
///
/// Source  of the bounds: docs/verification.md, "Feeds and speeds".
std::vector<Condition> doubtful_cutting_data(const CheckedProgram& program, const VerifyOptions& options);

}  // namespace clearcut::verify
