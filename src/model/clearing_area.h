// A layer split into the legal area of the cutter's centre, the passes along its walls, and what these leave.
#pragma once

#include <vector>

#include "model/layer.h"

namespace clearcut::inline model {

/// One connected part of the legal area of the cutter's centre.
struct ClearingComponent {
  Region legal;
  Regions rest;  ///< part of the target left by the wall passes: at least one tool radius inside `legal`
  int outer_wall = -1;  ///< index of the pass along its outer boundary, else of one along an island; -1: none
};

struct ClearingArea {
  std::vector<ClearingComponent> components;  ///< the index is `Pass::component`
  LayerPasses walls;  ///< legal area, fit lines and wall passes; the strategy adds its own passes to them
};

}  // namespace clearcut::inline model
