// Arcs in place of the small kinks between the moves of cuts, so that machines keep their speed there.
#pragma once

#include <optional>
#include <vector>

#include "geometry/route/legal_area.h"
#include "model/pass.h"
#include "plan/common/machine_clock.h"

namespace clearcut::plan::adaptive {

/// A joint with an arc in its place, tangential to both sides.
struct EasedJoint {
  Edge before, arc, after;
};

/// The arc that leaves `before` `taken` mm ahead of its end and joins `after`; nothing if no arc does within half of either.
std::optional<EasedJoint> eased_joint(const Edge& before, const Edge& after, double taken);

/// Where joints may be eased, and for what.
struct EasingJob {
  const LegalArea& legal;  ///< where the centre may be
  const MachineClock& clock;
  double at_wall = 0;  ///< mm; at the border of the legal area arcs deviate by no more
  double most = 0;     ///< mm; elsewhere
};

/// Eases the kinks within each run of cuts of a pass, where the machine is faster so. Returns the moves that changed, as they
/// were.
std::vector<Edge> ease_joints(Pass& pass, const EasingJob& job);

}  // namespace clearcut::plan::adaptive
