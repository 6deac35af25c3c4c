// Depth of a move's cut into the finished part, for any shape of its cutter: T-slot cutters, a disc below remaining
// material on a neck, and parts in which features cut into walls with draft.
#pragma once

#include <optional>

#include "model/cutter_profile.h"
#include "model/move.h"
#include "model/tool.h"
#include "verify/part/finished_part.h"
#include "verify/part/finished_parts.h"
#include "verify/program/checked_move.h"
#include "verify/program/shaped_cutter.h"

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

/// The deepest cut of a T-slot cutter, `aside` mm wider than it is, into the part along `move`.
///
/// Without material above the disc, the cutter is a cylinder without upper limit, like every cutter. Otherwise three
/// conditions are tested: the disc may cut only into undercuts, sideways and downwards (the part without the material
/// over these); if the disc's upper side, at the highest tip of the move, is above the roof of an undercut on its
/// path, other undercuts reaching up to it must contain the disc, so that the disc neither rises nor sinks below
/// remaining material; and the neck, a cylinder from the disc's upper side upwards without limit, must not cut into
/// the part. `slack` as in gouge_of.
///
/// Cost    O(log n + walls near), thrice.
std::optional<Gouge> undercut_gouge_of(const FinishedParts& finished, const Move& move, const Tool& tool,
                                       double aside, double slack);

/// The deepest gouge of `move`, made by the tool of `checked`, which may be `aside` mm off its path, sideways.
/// `slack`: mm by which floors may be cut too deep. `joined`: the move is known to begin outside the part; for
/// cutters without flanks.
///
/// Error   as gouge_of and shaped_gouge_of
/// Cost    as of these functions, and once more for each feature with draft at the place
std::optional<Gouge> gouge_of_move(const FinishedParts& finished, const CheckedMove& checked,
                                   const Move& move, double aside, double slack, bool joined);

}  // namespace clearcut::verify
