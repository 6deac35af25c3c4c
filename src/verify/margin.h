// How far a machine may leave the programmed path before the part suffers.
#pragma once

#include "model/results/margin.h"
#include "verify/verify.h"

namespace clearcut::verify {

/// For each feature the largest e, to kMarginStep, such that on every path of which each point lies within e of its place on the
/// programmed one (in space, all moves at once) no more than bounds.uncut of what is within reach stays, and nothing is cut deeper than
/// bounds.gouge. At most bounds.uncut: a floor is left that much higher.
///
/// A cutter of radius r on such a path clears what one of radius r - e clears on the programmed path, and stays within what one of
/// radius r + e, e lower, would cut there. Both are asked by the same proofs as the verdict, and bisected.
///
/// options  tolerances are replaced by the bounds; limits of load are not asked, nor are rapids in material
/// Throws   Cancelled
/// Cost     some ten times that of coverage and gouges of a verdict
Margin margin_of(const Part& part, const Toolpath& toolpath, const VerifyOptions& options,
                 const MarginBounds& bounds);

/// mm; margins are found to this, rounded down.
inline constexpr double kMarginStep = 1e-4;

}  // namespace clearcut::verify
