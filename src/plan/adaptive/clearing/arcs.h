// Arcs in paths: fitted to a run of points, to two points and a heading, in place of two edges, and in place of the
// small kinks between the moves of cuts, so that machines keep their speed there.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/edge.h"
#include "geometry/route/legal_area.h"
#include "model/layer.h"
#include "plan/common/machine_clock.h"

namespace clearcut::plan::adaptive {

/// Arcs and lines, one after the other, as few as keep every point within `tolerance` mm. The points lie
/// along a smooth curve and no two are equal. Cost O(n log n).
Path fit_arcs(std::span<const Vec2> points, double tolerance);

/// The arc from one point to another that begins along `heading`, a unit vector; a line if `to` lies straight
/// ahead.
Edge tangent_arc(Vec2 from, Vec2 heading, Vec2 to);

/// One arc or line that stays within `tolerance` mm of two successive edges; nothing if there is none.
std::optional<Edge> joined(const Edge& first, const Edge& second, double tolerance);

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
