// Clamps and what else stands beside the work: nothing of the tool may come there.
#pragma once

#include <optional>

#include "model/part.h"
#include "model/results/findings.h"
#include "verify/program/checked_move.h"

namespace clearcut::verify {

/// The first of the part's keep-outs that the cutter, its shank or its holder comes into, feeding or at the rapid; its size is how
/// far it comes in, seen from above, mm.
std::optional<Fault> keep_out_fault(const Part& part, const CheckedMove& checked);

}  // namespace clearcut::verify
