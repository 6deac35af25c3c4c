// Whether the tabs of profiles stand, and how high.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "verify/program/checked_move.h"

namespace clearcut::verify {

/// One fault for each tab that is cut away, whose middle is lower or higher than asked for by more than tol.uncut, or, of
/// triangular tabs, whose sides are lower anywhere or higher in the middle of the kerf by as much, square to the side, or, of square
/// tabs, that reach farther along it by as much. What is cut from the sides of square tabs is a gouge and what stands beside tabs
/// is uncut, which other checks find.
///
/// Method  Of every move that covers a place with its cutter, the lowest height of the tip while it does so; exact for lines and
///         arcs. Sides are looked at on nine lines along the kerf, at places whose heights differ by 0.0025 mm.
/// Cost    O(tabs * (moves + places * moves near)).
std::vector<Fault> faults_of_tabs(const Part& part, const CheckedProgram& program, const Tolerances& tol);

}  // namespace clearcut::verify
