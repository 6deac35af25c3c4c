// Clamps and other obstacles beside the work: no part of the tool may enter them.
#pragma once

#include <optional>
#include <string>

#include "model/part.h"
#include "model/results/findings.h"
#include "verify/program/checked_move.h"

namespace clearcut::verify {

/// ", which a stickout of 12.5 mm clears": of a holder whose tool goes down to `lowest`, mm, over something that ends at `top`.
std::string stickout_that_clears(double top, double lowest);

/// The first of the part's keep-outs entered by the cutter, its shank or its holder, feeding or at the rapid; the
/// fault's size is the depth of intrusion, seen from above, mm.
/// `lowest`: lowest height of the tip of this tool in the whole program, mm.
std::optional<Fault> keep_out_fault(const Part& part, const CheckedMove& checked, double lowest);

}  // namespace clearcut::verify
