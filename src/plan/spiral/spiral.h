// Spirals between offset contours: one smooth path from the middle to the wall, without passages between contours;
// and their entry in the table of strategies.
#pragma once

#include <optional>

#include "base/tolerances.h"
#include "base/units.h"
#include "model/layer.h"
#include "model/machine.h"
#include "model/options/strategy_entry.h"

namespace clearcut::plan::spiral {

struct SpiralOptions {
  std::optional<double> stepover;  ///< mm, greatest distance between turns; absent: the fastest one found
  /// Turns have the wall on the right (climb milling for a clockwise spindle); false: on the left.
  bool wall_on_right = true;
  /// The machine and the feed for comparing the times of several steps.
  Machine machine;
  MmPerMin feed = MmPerMin::of(1000);
};

/// Plans the passes of one layer.
///
/// Shape   One open pass for each chain of offset contours following each other one to one, from the
///         innermost outwards, ending with the outermost once round; necks and islands end a chain. In
///         pockets the outermost contour is the wall pass. Single contours are closed passes. If the legal area is a
///         line, a pass on this line.
/// Error   Nothing reachable of the target is left thicker than tol.uncut; turns are no farther apart than
///         the step.
/// Cost    O(steps tried * (n log n + turns * n log n)).
/// Source  The idea of [held2009]; turns follow the rim of a widened offset (turn.h) instead of waves along a tree.
LayerPasses plan_spiral(const Layer& layer, const SpiralOptions& options, const Tolerances& tol);

StrategyEntry entry();

}  // namespace clearcut::plan::spiral
