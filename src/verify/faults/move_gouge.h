// Depth of a move's cut into the finished part, for any shape of its cutter.
#pragma once

#include <optional>

#include "verify/part/finished_parts.h"
#include "verify/program/checked_move.h"

namespace clearcut::verify {

/// The deepest gouge of `move`, made by the tool of `checked`, which may be `aside` mm off its path, sideways.
/// `slack`: mm by which floors may be cut too deep. `joined`: the move is known to begin outside the part; for
/// cutters without flanks.
///
/// Error   as gouge_of and shaped_gouge_of
/// Cost    as of these functions, and once more for each feature with draft at the place
std::optional<Gouge> gouge_of_move(const FinishedParts& finished, const CheckedMove& checked,
                                   const Move& move, double aside, double slack, bool joined);

}  // namespace clearcut::verify
