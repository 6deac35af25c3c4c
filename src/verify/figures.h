// Sums up judged moves: lengths, times, turns, loads.
#pragma once

#include <span>

#include "model/results/findings.h"
#include "verify/checked_move.h"

namespace clearcut::verify {

/// Figures of some moves of a program in their order: of all, of a workingstep or of a layer. Coverage and
/// `clean` are left to the caller. `top_z` is the stock's top: a rise to it between feed moves is a retract.
Figures figures_of(std::span<const JudgedMove* const> moves, double top_z);

}  // namespace clearcut::verify
