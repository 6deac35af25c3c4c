// What every strategy that fills an area starts from: where the cutter may be, the passes along the walls, and
// what these leave to be cut. Used by strategies alone.
#pragma once

#include <vector>

#include "model/layer.h"
#include "model/pass.h"

namespace clearcut::plan {

/// One connected legal area.
struct ClearingComponent {
  Region legal;
  Regions rest;  ///< what the wall passes leave of the target: every point at least one radius inside `legal`
  int outer_wall = -1;  ///< index of the pass along its outer boundary (or of some other wall), -1: none
};

struct ClearingArea {
  std::vector<ClearingComponent> components;  ///< numbered as in the passes
  LayerPasses walls;  ///< all but the strategy's own passes: legal area, fit lines, and passes along walls
};

/// Splits a layer into wall passes and rest.
///
/// Shape   a wall pass for each boundary of the legal area: closed, or on layers with open sides the open
///         stretches from which the target can be reached; then passes on lines where the cutter just fits.
///         Where the cutter has no legal position: nothing.
/// Error   what of the target lies neither in a rest nor within the radius of a wall pass is unreachable, to 2 um.
/// Cost    O(n log n).
ClearingArea clearing_area(const Layer& layer, const Tolerances& tol);

/// The target lies in `allowed`, so equal areas make them the same: a pocket closed all round.
bool closed_all_round(const Layer& layer);

}  // namespace clearcut::plan
