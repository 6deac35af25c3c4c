// Spirals between offset contours: one smooth way from the middle to the wall, without passages.
#pragma once

#include <optional>

#include "base/tolerances.h"
#include "base/units.h"
#include "model/layer.h"
#include "model/machine.h"
#include "model/pass.h"

namespace clearcut::plan::spiral {

struct SpiralOptions {
  std::optional<double> stepover;  ///< mm, greatest distance of turns; absent: the fastest found
  /// Turns have the wall on the right (climb milling for a clockwise spindle); false: on the left.
  bool wall_on_right = true;
  /// What steps are checked by.
  Machine machine;
  MmPerMin feed = MmPerMin::of(1000);
};

/// The passes of one layer.
///
/// Shape   one open pass for each run of offset contours that follow each other one to one, from the innermost outwards,
///         ending with the outermost once round: necks and islands end a run. In pockets that is the wall pass. Single
///         contours are closed passes. Where the legal position is a line, that line.
/// Error   nothing reachable of the target is left thicker than tol.uncut; turns are no farther apart than the step.
/// Cost    O(steps tried * (n log n + turns * n log n)).
/// Source  the idea of [held2009]; turns are built by booleans of offsets instead of by waves along a tree.
LayerPasses plan_spiral(const Layer& layer, const SpiralOptions& options, const Tolerances& tol);

}  // namespace clearcut::plan::spiral
