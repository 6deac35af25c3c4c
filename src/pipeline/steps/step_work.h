// The work of each workingstep: computed once for all tried strategies. Work permitted to each strategy for a
// workingstep.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/layer.h"
#include "model/move.h"
#include "model/options/resolved_plan.h"

namespace clearcut::pipeline {

/// A layer to be planned.
struct LayerLeft {
  Layer layer;
  bool walls_only = false;
  bool rest = false;  ///< cleared by others around its target
};

/// One workingstep, ready for any strategy.
struct StepWork {
  int workingstep = 0;
  std::vector<LayerLeft> layers;  ///< layers with material left, from the top down
  /// Section of a round hole, a carving, or a stated path, independent of the strategy.
  std::optional<Section> hole;
  std::optional<double> wall_top;  ///< height of walls above that are as near as its own walls
  /// Other features are in its area: they may remove material left here, and the finished part then shows nothing of
  /// it.
  bool meets_others = false;
  /// Nothing rests on what its passes clear beyond the targets of its layers.
  bool stands_alone = false;
  bool done_before = false;  ///< an earlier program has left no material worth a cut
};

/// mm; stock that is kept on walls so that the rounding of a control's digits puts no path into them; 0 for fine digits.
double reserve_for_digits(const ResolvedPlan& plan);

/// The work of every workingstep, in the order of the workplan, with its share of reserve_for_digits() kept on walls. Cost O(layers)
/// booleans a step.
std::vector<StepWork> step_works(const ResolvedPlan& plan, const std::vector<double>& reserve_shares);
/// The same with all of reserve_for_digits().
std::vector<StepWork> step_works(const ResolvedPlan& plan);

/// Steps of work (base/work_budget.h, about 8 us each) permitted to each strategy for all workingsteps if several are
/// tried; every workingstep has a share by its area, at least the smaller number.
inline constexpr std::uint64_t kMostWork = 500'000;
inline constexpr std::uint64_t kLeastWork = 50'000;
/// The same for one workingstep with a strategy requested by name, for which there is no alternative.
inline constexpr std::uint64_t kMostWorkAlone = 8'000'000;

/// For each workingstep: the steps of work permitted to a strategy.
std::vector<std::uint64_t> work_shares(const std::vector<StepWork>& works, const ResolvedPlan& plan);

}  // namespace clearcut::pipeline
