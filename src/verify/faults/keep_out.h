// Clamps and other obstacles beside the work: no part of the tool may enter them.
#pragma once

#include <optional>

#include "model/part.h"
#include "model/results/findings.h"
#include "verify/program/checked_move.h"

namespace clearcut::verify {

/// The first of the part's keep-outs entered by the cutter, its shank or its holder, feeding or at the rapid; the
/// fault's size is the depth of intrusion, seen from above, mm.
std::optional<Fault> keep_out_fault(const Part& part, const CheckedMove& checked);

}  // namespace clearcut::verify
