// Links that leave cuts and come to them along tangents, where the machine is faster on them than on straight ones.
#pragma once

#include <optional>
#include <vector>

#include "model/layer.h"
#include "plan/adaptive/clearing/remaining_stock.h"
#include "plan/common/machine_clock.h"

namespace clearcut::plan::adaptive {

/// One end of a link: where a cut ends or begins, and the circle that the link follows there.
struct LinkEnd {
  Vec2 point;
  Vec2 heading;       ///< of the cut there
  double radius = 0;  ///< mm; 0: the link turns on the spot
  bool left = true;   ///< to which side the circle lies
};

/// From `from` along its circle, straight to the circle of `to`, and along that; nothing if one circle holds the other.
std::optional<Path> smooth_link(const LinkEnd& from, const LinkEnd& to);

/// Two arcs with a common tangent at their joint, and with the given headings at both ends; none if no such pair exists.
std::optional<Path> biarc(Vec2 from, Vec2 heading, Vec2 to, Vec2 end_heading);

/// Replaces links within passes by smooth ones where the machine gains time and nothing stands on them.
///
/// `stock`: what the first pass begins with. All passes are removed from it.
/// Method  Each link is tried with circles of several radii at both ends, and as one or two tangential arcs; the fastest by the planner of the machine's control that
///         touches nothing is taken. Cuts stay as they are.
void smooth_links(std::vector<Pass>& passes, RemainingStock& stock, const MachineClock& clock);

}  // namespace clearcut::plan::adaptive
