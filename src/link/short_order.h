// A better order of passes than always taking the nearest.
#pragma once

#include <vector>

#include "link/linker.h"

namespace clearcut::link {

/// What is kept together while the order is looked for.
enum class Together {
  kAreas,  ///< passes cut one after the other in the same place, through all layers
  kRuns    ///< passes that follow each other at depth
};

/// The passes in an order of fewer seconds between them, estimated, found from the one in which `linker` has cut them
/// all. Precedence is kept; a ring that is alone may begin elsewhere. Empty where there is nothing to choose.
/// Cost: see order/visit/visit_order.h.
std::vector<Task> short_order(const Work& work, const Linker& linker, Together together);

}  // namespace clearcut::link
