// Sums up checked moves: lengths, times, turns, engagement.
#pragma once

#include <span>

#include "model/results/findings.h"
#include "verify/program/checked_move.h"

namespace clearcut::verify {

/// Figures of some moves of a program in their order: all moves, or those of a workingstep or of a layer. The caller
/// sets coverage and `clean`. `top_z`: top of the stock, mm; a rise to this height between feed moves counts as a
/// retract.
Figures figures_of(std::span<const CheckedMove* const> moves, double top_z);

}  // namespace clearcut::verify
