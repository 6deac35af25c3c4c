// T-slot cutters: a disc that may run below remaining material, on a neck that must pass through the slot above.
#pragma once

#include <optional>

#include "model/move.h"
#include "model/tool.h"
#include "verify/part/finished_parts.h"
#include "verify/program/gouge.h"

namespace clearcut::verify {

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

}  // namespace clearcut::verify
