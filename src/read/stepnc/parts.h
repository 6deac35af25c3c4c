// Which parts of a compound feature an operation is for.
#pragma once

#include "read/stepnc/shapes/draft.h"

namespace clearcut::read::stepnc {

/// Drilling and reaming have no approach, strategy and depths of cut.
bool goes_straight_down(const Operation& operation);

/// Indices into `parts` of those that `operation` (the entity `node`) with `tool` cuts: those that list it as theirs;
/// where none does, those it fits: drills go into holes of their diameter, else into holes at least as wide, and no cutter into
/// narrower holes. All where nothing fits, which then says why. A part alone is always cut.
std::vector<std::size_t> parts_for(const std::vector<const Draft*>& parts, const Node& node,
                                   const Operation& operation, const Tool& tool);

}  // namespace clearcut::read::stepnc
