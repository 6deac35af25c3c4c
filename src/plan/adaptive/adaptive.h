// Engagement-limited clearing: a spiral in the widest place, then cuts from wall to wall at the limit.
#pragma once

#include <optional>
#include <stop_token>

#include "base/tolerances.h"
#include "base/units.h"
#include "model/layer.h"
#include "model/pass.h"

namespace clearcut::plan::adaptive {

struct AdaptiveOptions {
  /// Largest angle of the cutter's circle in material while it cuts, after the entry.
  Radians engagement = Radians::of_degrees(60);
  /// Where it goes down first, in the region that holds the point; absent, or nearer to a wall than an entry needs: in a
  /// predrilled hole, else in the widest place.
  std::optional<Vec2> start;
  /// mm, greatest diameter of the centre's circle on the way down.
  std::optional<double> widest_helix;
  /// Looked at before each cut; Cancelled is thrown when it asks to stop.
  std::stop_token cancel;
};

/// The passes of one layer with the cutter's engagement limited.
///
/// Shape   open passes with their links, to run one after the other: for each wide room of each connected legal
///         area a spiral, then cuts from wall to wall with the contact at the limit, at last along the walls
///         at radius + wall_stock. Empty where the cutter has no legal position.
/// Error   the contact exceeds the limit only on the circle of an entry and where a wall pass turns into a
///         tight corner.
/// Cost    O(length of the passes / radius * passes near); about 3 us a step of a tenth of the radius.
/// Source  own; the spiral's step and the look of a steady cut follow from the contact in closed form, see
///         docs/adaptive.md.
LayerPasses plan_adaptive(const Layer& layer, const AdaptiveOptions& options, const Tolerances& tol);

}  // namespace clearcut::plan::adaptive
