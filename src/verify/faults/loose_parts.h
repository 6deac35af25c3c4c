// Detects cuts in a piece already cut free by a profile.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "verify/program/checked_move.h"

namespace clearcut::verify {

/// One fault for each profile without tabs and skin that goes through the material, after which the program still
/// cuts in the freed piece: the part within an outer profile, the waste within an inner one. Work in the profile's
/// own kerf does not count, nor does breaking the edge along it.
///
/// Method  The kerf's middle is sampled every quarter of the cutter's radius. The piece is free after the move that
///         reaches the last of these samples for the first time with its tip at the underside. Moves without cutting
///         do not count.
/// Blind   Other means of holding a piece, for example vacuum or glue. If no stock is stated a profile is assumed to
///         end at its underside.
/// Cost    O(profiles * moves); for findings, times the places along the kerf.
std::vector<Fault> faults_of_loose_parts(const Part& part, const CheckedProgram& program,
                                         const Tolerances& tol);

}  // namespace clearcut::verify
