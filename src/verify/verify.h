// Checks the effect of a program on a part. The check shares with the planner only the distances to lines and arcs,
// indexes of boxes, the remaining stock with its engagement (stock/material.h) and the times of moves.
#pragma once

#include "model/move.h"
#include "model/part.h"
#include "model/results/findings.h"
#include "verify/program/verify_options.h"

namespace clearcut::verify {

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

}  // namespace clearcut::verify
