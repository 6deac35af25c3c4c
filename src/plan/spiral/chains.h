// Nested offset loops in chains: each loop with the one that follows it inwards. Used by the planner alone.
#pragma once

#include <vector>

#include "plan/common/rings.h"

namespace clearcut::plan::spiral {

/// Loops that follow each other inwards one to one, the outermost first; a neck, or meeting another loop, ends it.
struct SpiralChain {
  std::vector<Loop> loops;  ///< oriented as in their regions: what is to be cut lies on the left
  int parent = -1;  ///< chain of the loop around the outermost; -1: the outermost is of the first level
};

struct SpiralChains {
  std::vector<SpiralChain> chains;  ///< parents come first
  std::vector<int> chain_of_node;   ///< chain of each node's outer loop
};

/// Sorts the loops of a ring tree into chains. Cost: O(loops^2) of neighbouring nodes.
SpiralChains spiral_chains(const std::vector<RingNode>& nodes);

}  // namespace clearcut::plan::spiral
