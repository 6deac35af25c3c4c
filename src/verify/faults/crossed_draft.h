// Whether a cutter keeps clear of a part in which features cut into walls with draft.
#pragma once

#include "model/cutter_profile.h"
#include "model/move.h"
#include "verify/part/finished_part.h"

namespace clearcut::verify {

/// Whether a cutter, its tip along `move`, stays within what the features of the part clear together. The walls of
/// FinishedPart stand whole where another feature cuts into one with draft; this asks the places themselves.
///
/// Method  A quadtree over what the cutter sweeps, with the bound that cleared_by() changes no faster than its place, each cell at the
///         lowest height that the cutter's surface has over it: whatever is clear there is clear above.
/// Error   True: it goes into nothing by more than 0.001 mm. False: it does, or is not found not to in kMostCells cells. Sloping moves are
///         looked at in pieces, each at its lowest tip. `slack`: mm by which floors may be cut too deep.
bool is_clear_of_crossed_draft(const FinishedPart& part, const Move& move, const CutterProfile& cutter,
                               double slack);

}  // namespace clearcut::verify
