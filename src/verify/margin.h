// Allowed deviation of a machine from the programmed path before the part is out of bounds.
#pragma once

#include "model/results/margin.h"
#include "verify/verify.h"

namespace clearcut::verify {

/// For each feature the largest e, to kMarginStep, with the following property: on every path with each point within
/// e of its place on the programmed path (in space, all moves at once), no more than bounds.uncut of the reachable
/// material remains, and no gouge is deeper than bounds.gouge. The margin is at most bounds.uncut: a floor is left
/// higher by the margin.
///
/// A cutter of radius r on such a path clears at least the area of a cutter of radius r - e on the programmed path,
/// and stays within the volume of a cutter of radius r + e, lower by e, on that path. Both are tested by the same
/// proofs as the verdict, with bisection.
///
/// options  tolerances are replaced by the bounds; limits of load and rapids in material are not tested
/// Throws   Cancelled
/// Cost     some ten times that of coverage and gouges of a verdict
Margin margin_of(const Part& part, const Toolpath& toolpath, const VerifyOptions& options,
                 const MarginBounds& bounds);

/// mm; margins are found to this, rounded down.
inline constexpr double kMarginStep = 1e-4;

}  // namespace clearcut::verify
