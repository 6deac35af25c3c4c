// Whether a cutter keeps clear of a part in which features cut into walls with draft.
#pragma once

#include "model/move.h"
#include "verify/part/finished_part.h"

namespace clearcut::verify {

/// Whether a cylinder of `radius` mm, its tip along `move`, stays within the union of the volumes cleared by the
/// part's features. FinishedPart treats a wall with draft as whole even if another feature cuts into it; this
/// function tests the places themselves.
///
/// Method  A quadtree over the area swept by the cylinder, using that cleared_by() changes no faster than its place.
/// Error   True: the cylinder nowhere cuts in by more than 0.001 mm. False: it does, or the proof needs more than
///         kMostCells cells. Sloping moves are tested in pieces, each at its lowest tip. `slack`: mm by which floors
///         may be cut too deep.
bool is_clear_of_crossed_draft(const FinishedPart& part, const Move& move, double radius, double slack);

}  // namespace clearcut::verify
