// Rounds corners of passes if other passes clear the material left by the rounded corner, so that machines keep their
// speed.
#pragma once

#include <vector>

#include "geometry/route/legal_area.h"
#include "model/layer.h"

namespace clearcut::plan {

/// Input of the rounding of corners.
struct RoundingJob {
  double radius = 0;  ///< radius of the cutter, mm
  /// mm; points within this distance of a pass are still within it afterwards.
  double proven = 0;
  const LegalArea* legal = nullptr;  ///< legal area of the centre
  double speed = 0;                  ///< mm/s, of the feed
  double acceleration = 0;           ///< mm/s^2
};

/// The radius for the proof that places stay cleared, for changes of passes with a residual of `residual` mm.
double proven_radius(double tool_radius, double residual);

/// Replaces corners between straight moves by arcs tangent to both moves, as large as the length of the moves
/// permits. A corner is kept if its arc would leave the legal area, or if some place cleared by the corner would no
/// longer be cleared by any pass. Corners that take the machine less time than the arc are kept, too.
///
/// Method  For each corner the farthest place cleared by it is tested first. Then, for arcs of decreasing radius,
///         other edges must clear the whole outer rim of the area cleared by the corner's two pieces. If they do not
///         clear it deeper than the arc deviates from the corner, the exact check (Cover::has_hole) must find no hole
///         inside of that rim, too.
/// Result  No path gets longer. The corner at the start of a closed pass is kept.
/// Cost    O(corners * passes nearby).
void round_corners(std::vector<Pass>& passes, const RoundingJob& job);

/// The same for all passes of a layer, within its legal area and the radius provable with its residual. `radius`: of
/// the cutter, mm; `speed`, mm/s, of the feed; `acceleration`, mm/s^2.
void round_corners(LayerPasses& layer, double radius, double speed, double acceleration);

}  // namespace clearcut::plan
