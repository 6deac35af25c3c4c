// Rounds corners of passes where other passes clear the material that a rounded corner leaves, so that machines keep their speed.
#pragma once

#include <vector>

#include "geometry/route/legal_area.h"
#include "model/pass.h"

namespace clearcut::plan {

/// What corners are rounded for.
struct RoundingJob {
  double radius = 0;                 ///< of the cutter, mm
  double proven = 0;                 ///< mm; whatever lies within this of a pass still does afterwards
  const LegalArea* legal = nullptr;  ///< where the centre may be
  double speed = 0;                  ///< mm/s, of the feed
  double acceleration = 0;           ///< mm/s^2
};

/// The radius within which places stay cleared when passes that leave a residual of `residual` mm are changed.
double proven_radius(double tool_radius, double residual);

/// Replaces corners between straight moves by arcs that join both tangentially, as wide as the moves are long. A corner stays
/// where its arc would leave the legal area, or where any place that the corner clears would be cleared by no pass.
/// Corners that cost the machine less time than the arc stay, too.
///
/// Method  For each corner the place that it clears farthest out is tested first. Then, for arcs of smaller and smaller radius,
///         others have to clear the whole outer rim of what the corner's two pieces clear. If they do so no deeper than the arc
///         deviates from the corner, the exact check (Cover::has_hole) has to find nothing inside of that rim, too.
/// Result  No path gets longer. The corner where a closed pass begins stays.
/// Cost    O(corners * passes nearby).
void round_corners(std::vector<Pass>& passes, const RoundingJob& job);

/// The same of all passes of a layer, within its legal area and what its residual lets be proven. `radius`: of the cutter, mm; `speed`, mm/s,
/// of the feed; `acceleration`, mm/s^2.
void round_corners(LayerPasses& layer, double radius, double speed, double acceleration);

}  // namespace clearcut::plan
