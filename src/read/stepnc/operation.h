// Operations and their cutting data.
#pragma once

#include "model/part.h"
#include "read/stepnc/file/node.h"
#include "read/stepnc/tools.h"

namespace clearcut::read::stepnc {

/// An operation, with what it says of the hole that it goes down in.
struct StatedOperation {
  Operation operation;  ///< its retract_z is above the top of the feature
  HoleKind hole = HoleKind::kDrilled;
  std::optional<double> depth;              ///< mm below the top of the hole; absent: down to its floor
  bool is_floating = false;                 ///< the tap is held with play
  std::optional<double> previous_diameter;  ///< mm; of the hole that is there before
};

/// Throws InputError for operations that cannot be machined yet and for missing tools.
StatedOperation read_operation(const Node& operation, const Tools& tools, Context& context);

}  // namespace clearcut::read::stepnc
