// Whether anything is cut in a piece that a profile has cut free before.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "verify/program/checked_move.h"

namespace clearcut::verify {

/// One fault for each profile without tabs and skin that goes through the material, after which the program still cuts in the piece
/// that it frees: the part within an outer profile, the waste within an inner one. Work in the profile's own kerf is none, nor is
/// breaking the edge along it.
///
/// Method  The kerf's middle is looked at every quarter of the cutter's radius. The piece is free after the move that is the last to
///         come over such a place for the first time with its tip at the underside. Moves that cut nothing do not count.
/// Blind   What holds a piece otherwise, such as vacuum or glue. Where no stock is stated a profile is taken to end at its underside.
/// Cost    O(profiles * moves); where something is found, times the places along its kerf.
std::vector<Fault> faults_of_loose_parts(const Part& part, const CheckedProgram& program,
                                         const Tolerances& tol);

}  // namespace clearcut::verify
