// Checks the presence and the height of the tabs of profiles.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "verify/program/checked_move.h"

namespace clearcut::verify {

/// One fault for each tab that is cut away, or whose middle is lower or higher than requested by more than tol.uncut;
/// for triangular tabs also if their sides are lower anywhere, or higher in the middle of the kerf, by more than
/// this, square to the side; for square tabs also if they are longer along the kerf by more than this. Cuts into the
/// sides of square tabs are gouges and material beside tabs is uncut; other checks find these.
///
/// Method  For each place, the lowest height of the tip of all moves whose cutter covers the place; exact for lines
///         and arcs. Sides are sampled on nine lines along the kerf, at places with heights 0.0025 mm apart.
/// Cost    O(tabs * (moves + places * moves near)).
std::vector<Fault> faults_of_tabs(const Part& part, const CheckedProgram& program, const Tolerances& tol);

}  // namespace clearcut::verify
