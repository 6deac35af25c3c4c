// Checks of a program without a stated part.
#pragma once

#include "model/results/findings.h"
#include "verify/program/checked_move.h"
#include "verify/verify.h"

namespace clearcut::verify {

/// Findings of a program against a stock alone: all faults of its moves and of the control's state, and a row of
/// figures for each tool. Uncut material and gouges are not examined: those figures are NaN. The load of the moves
/// must have been measured before.
Findings findings_without_part(const Part& part, const CheckedProgram& program, const VerifyOptions& options);

}  // namespace clearcut::verify
