// Sorts nested offset loops into chains, each loop with the loop next inside.
#pragma once

#include <vector>

#include "plan/common/rings.h"

namespace clearcut::plan::spiral {

/// Loops following each other inwards one to one, the outermost first. A neck, or a loop touching another, ends a
/// chain.
struct SpiralChain {
  std::vector<Loop> loops;  ///< oriented as in their regions: the area to be cleared is on the left
  /// Index of the chain of the loop around the outermost; -1: the outermost is of the first level.
  int parent = -1;
};

struct SpiralChains {
  std::vector<SpiralChain> chains;  ///< parents come before their children
  std::vector<int> chain_of_node;   ///< for each node of the ring tree: index of the chain of its outer loop
};

/// Sorts the loops of a ring tree into chains. Costs O(loops^2) of neighbouring nodes.
SpiralChains spiral_chains(const std::vector<RingNode>& nodes);

}  // namespace clearcut::plan::spiral
