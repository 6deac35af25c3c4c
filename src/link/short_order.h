// Finds a quicker order of passes than always taking the nearest.
#pragma once

#include <vector>

#include "link/linker.h"

namespace clearcut::link {

/// Groups of passes kept together while orders are compared.
enum class Together {
  kAreas,  ///< passes cut one after the other in the same area, through all layers
  kRuns    ///< passes that follow each other with links at depth
};

/// The passes in an order with a shorter estimated time of links; found from the order in which `linker` has cut them
/// all. Precedence is respected; a ring without neighbours may begin elsewhere. Empty if there is nothing to choose.
/// Cost: see order/search/visit_order.h.
std::vector<Task> short_order(const Work& work, const Linker& linker, Together together);

}  // namespace clearcut::link
