// Sums up checked moves: lengths, times, turns, engagement. Checks the effect of a program on a part. The check
// shares with the planner only the distances to lines and arcs, indexes of boxes, the remaining stock with its
// engagement (stock/material.h) and the times of moves. Checks of a program without a stated part.
#pragma once

#include <span>

#include "model/move.h"
#include "model/part.h"
#include "model/results/findings.h"
#include "verify/program/checked_move.h"
#include "verify/program/verify_options.h"

namespace clearcut::verify {

/// Figures of some moves of a program in their order: all moves, or those of a workingstep or of a layer. The caller
/// sets coverage and `clean`. `top_z`: top of the stock, mm; a rise to this height between feed moves counts as a
/// retract.
Figures figures_of(std::span<const CheckedMove* const> moves, double top_z);

/// Checks `toolpath`, normally read back from a program's text, against `part`, regardless of its author.
///
/// Shape   Figures of the whole, of each workingstep and of each of its layers; faults, the worst first.
///         all.clean if there is no fault. Labels and workingsteps of sections only group the figures.
/// Error   Gouges are exact for lines and arcs; uncut material has proven upper bounds; see
///         docs/verification.md.
/// Throws  Cancelled if options.cancel requests a stop, and no other exception for a valid part. The result does not
///         depend on options.threads.
/// Cost    O((moves + outline + cells) log n) for gouges and coverage, O(feed length / step) for engagement.
Findings verify_program(const Part& part, const Toolpath& toolpath, const VerifyOptions& options);

/// Findings of a program against a stock alone: all faults of its moves and of the control's state, and a row of
/// figures for each tool. Uncut material and gouges are not examined: those figures are NaN. The load of the moves
/// must have been measured before.
Findings findings_without_part(const Part& part, const CheckedProgram& program, const VerifyOptions& options);

}  // namespace clearcut::verify
