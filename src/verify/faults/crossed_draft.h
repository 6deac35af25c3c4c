// Whether a cutter keeps clear of a part in which features cut into walls with draft.
#pragma once

#include "model/move.h"
#include "verify/part/finished_part.h"

namespace clearcut::verify {

/// Whether a cylinder of `radius` mm, its tip along `move`, stays within what the features of the part clear together. The walls of
/// FinishedPart stand whole where another feature cuts into one with draft; this asks the places themselves.
///
/// Method  A quadtree over what the cylinder sweeps, with the bound that cleared_by() changes no faster than its place.
/// Error   True: it goes into nothing by more than 0.001 mm. False: it does, or is not found not to in kMostCells cells. Sloping moves are
///         looked at in pieces, each at its lowest tip. `slack`: mm by which floors may be cut too deep.
bool is_clear_of_crossed_draft(const FinishedPart& part, const Move& move, double radius, double slack);

}  // namespace clearcut::verify
