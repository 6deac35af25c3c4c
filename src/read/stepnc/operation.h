// Operations and their cutting data, and the parts of a compound feature an operation is for.
#pragma once

#include "model/part.h"
#include "read/stepnc/file/node.h"
#include "read/stepnc/shapes/draft.h"
#include "read/stepnc/toolpaths.h"

namespace clearcut::read::stepnc {

/// Drilling and reaming have no approach, strategy and depths of cut.
bool goes_straight_down(const Operation& operation);

/// Indices into `parts` of those that `operation` (the entity `node`) with `tool` cuts: those that list it as theirs;
/// where none does, those it fits: drills go into holes of their diameter, else into holes at least as wide, and no cutter into
/// narrower holes. All where nothing fits, which then says why. A part alone is always cut.
std::vector<std::size_t> parts_for(const std::vector<const Draft*>& parts, const Node& node,
                                   const Operation& operation, const Tool& tool);

/// An operation, with what it says of the hole that it goes down in.
struct StatedOperation {
  Operation operation;  ///< its retract_z is above the top of the feature
  HoleKind hole = HoleKind::kDrilled;
  Hand hand = Hand::kUnstated;              ///< of its tool
  std::optional<double> depth;              ///< mm below the top of the hole; absent: down to its floor
  bool is_floating = false;                 ///< the tap is held with play
  std::optional<double> previous_diameter;  ///< mm; of the hole that is there before
};

/// Throws InputError for operations that cannot be machined yet and for missing tools.
StatedOperation read_operation(const Node& operation, const Tools& tools, Context& context);

}  // namespace clearcut::read::stepnc
