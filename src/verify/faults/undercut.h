// T-slot cutters: a disc that may run under what stands, on a neck that has to pass through the slot above.
#pragma once

#include <optional>

#include "model/move.h"
#include "model/tool.h"
#include "verify/part/finished_parts.h"
#include "verify/program/gouge.h"

namespace clearcut::verify {

/// The deepest cut of a T-slot cutter, `aside` mm wider than it is, into the part along `move`.
///
/// Where nothing stands over the disc it is a cylinder that reaches up without end, as every cutter. Where something does, three
/// things are asked: the disc may cut into nothing but undercuts, sideways and downwards (the part without what stands over these);
/// where its upper side, at the highest tip of the move, is above the roof of an undercut that it comes into, others that reach up
/// to it have to hold the disc, so that it neither rises nor sinks under what stands; and the neck, a cylinder from the disc's upper side up without end, cuts into nothing
/// of the part as it stands. `slack` as in gouge_of.
///
/// Cost    O(log n + walls near), thrice.
std::optional<Gouge> undercut_gouge_of(const FinishedParts& finished, const Move& move, const Tool& tool,
                                       double aside, double slack);

}  // namespace clearcut::verify
