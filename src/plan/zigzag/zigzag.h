// Zigzag passes: parallel lines to and fro, then once along the walls; and their entry in the table of strategies.
#pragma once

#include <optional>

#include "base/tolerances.h"
#include "base/units.h"
#include "model/layer.h"
#include "model/machine.h"
#include "model/options/strategy_entry.h"

namespace clearcut::plan::zigzag {

struct ZigzagOptions {
  std::optional<Radians> angle;  ///< angle of the lines to the x axis; absent: the fastest one found
  /// mm, greatest distance between lines; absent: the widest without residual.
  std::optional<double> stepover;
  /// Lines with the material on the right of the cutter are preferred (climb milling for a clockwise
  /// spindle); false: on the left.
  bool material_on_right = true;
  /// The machine and the feed for comparing the times of directions.
  Machine machine;
  MmPerMin feed = MmPerMin::of(1000);
};

/// Plans the passes of one layer.
///
/// Shape   One open pass for each connected legal area, more if a retract link is quicker than a link at
///         depth; then the wall passes around it. Empty if the cutter fits nowhere.
/// Error   Nothing reachable of the target is left thicker than tol.uncut, for any angle and stepover.
/// Cost    O(n log n + directions * (lines + cells^2 * edges)).
LayerPasses plan_zigzag(const Layer& layer, const ZigzagOptions& options, const Tolerances& tol);

StrategyEntry entry();

}  // namespace clearcut::plan::zigzag
