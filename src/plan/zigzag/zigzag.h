// Zigzag passes: parallel lines to and fro, then once along the walls.
#pragma once

#include <optional>

#include "base/tolerances.h"
#include "base/units.h"
#include "model/layer.h"
#include "model/machine.h"
#include "model/pass.h"

namespace clearcut::plan::zigzag {

struct ZigzagOptions {
  std::optional<Radians> angle;    ///< of the lines against x; absent: the fastest found
  std::optional<double> stepover;  ///< mm, greatest distance of lines; absent: as wide as leaves nothing
  /// Lines on which the material lies right of the cutter are preferred (climb milling for a clockwise spindle);
  /// false: left.
  bool material_on_right = true;
  /// What directions are checked by.
  Machine machine;
  MmPerMin feed = MmPerMin::of(1000);
};

/// The passes of one layer.
///
/// Shape   for each connected legal area one open pass, more where a lift is quicker than a way at depth; then the
///         wall passes, which surround it. Empty where the cutter has no legal position.
/// Error   nothing reachable of the target is left thicker than tol.uncut, whatever the angle and the stepover.
/// Cost    O(n log n + directions * (lines + cells^2 * edges)).
LayerPasses plan_zigzag(const Layer& layer, const ZigzagOptions& options, const Tolerances& tol);

}  // namespace clearcut::plan::zigzag
