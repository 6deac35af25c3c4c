// Pieces that profiles cut free: presence and height of the tabs that hold them, and cuts in a piece already cut
// free.
#pragma once

#include <optional>
#include <vector>

#include "base/tolerances.h"
#include "verify/program/checked_move.h"

namespace clearcut::verify {

/// mm; the lowest height of the tip while the cutter's disc covers p; absent if it never does. Exact for lines and
/// arcs.
std::optional<double> lowest_tip(const CheckedMove& checked, Vec2 p);

/// One fault for each tab that is cut away, or whose middle is lower or higher than requested by more than tol.uncut;
/// for triangular tabs also if their sides are lower anywhere, or higher in the middle of the kerf, by more than
/// this, square to the side; for square tabs also if they are longer along the kerf by more than this. Cuts into the
/// sides of square tabs are gouges and material beside tabs is uncut; other checks find these.
///
/// Method  For each place, the lowest height of the tip of all moves whose cutter covers the place; exact for lines
///         and arcs. Sides are sampled on nine lines along the kerf, at places with heights 0.0025 mm apart.
/// Cost    O(tabs * (moves + places * moves near)).
std::vector<Fault> faults_of_tabs(const Part& part, const CheckedProgram& program, const Tolerances& tol);

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
