// What can be said of a program that nobody has stated a part for.
#pragma once

#include "model/results/findings.h"
#include "verify/program/checked_move.h"
#include "verify/verify.h"

namespace clearcut::verify {

/// Findings of a program against a stock alone: all faults of its moves and of the control's state, and a row of figures for each
/// tool. What is left and what is gouged is no question: those figures are not numbers. The load of the moves was measured before.
Findings findings_without_part(const Part& part, const CheckedProgram& program, const VerifyOptions& options);

}  // namespace clearcut::verify
