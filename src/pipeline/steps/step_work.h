// What is to be done in each workingstep: found once, however many strategies are tried on it.
#pragma once

#include <optional>
#include <vector>

#include "model/layer.h"
#include "model/move.h"
#include "model/options/resolved_plan.h"

namespace clearcut::pipeline {

/// A layer as it is to be planned.
struct LayerLeft {
  Layer layer;
  bool walls_only = false;
  bool rest = false;  ///< cleared by others around its target
};

/// One workingstep, ready for any strategy.
struct StepWork {
  int workingstep = 0;
  std::vector<LayerLeft> layers;  ///< over which something still stands, from the top down
  std::optional<Section>
      hole;  ///< where it is made as a round hole, carved, or by a stated path, whatever the strategy
  std::optional<double> wall_top;  ///< height of walls above that stand as near as its own
  /// Other features lie in its area: they may take what is left here, and then the finished part shows nothing of it.
  bool meets_others = false;
  bool done_before = false;  ///< an earlier program has left nothing that is worth a cut
};

/// The work of every workingstep, in the order of the workplan. Cost O(layers) booleans a step.
std::vector<StepWork> step_works(const ResolvedPlan& plan);

}  // namespace clearcut::pipeline
