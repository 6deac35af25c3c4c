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

/// How far moves may deviate from what was planned.
struct Deviation {
  const LegalArea& legal;  ///< where the centre may be
  double at_wall = 0;      ///< mm; at the border of the legal area
  double most = 0;         ///< mm; elsewhere
};

/// Eases the kinks within each run of cuts of a pass, where the machine is faster so. Returns the moves that changed, as they
/// were.
std::vector<Edge> ease_joints(Pass& pass, const Deviation& deviation, const MachineClock& clock);

/// mm. Programs are proven whose arcs have their centers within 1.07 m of zero in x and in y (docs/claim.md); arcs about centers
/// beyond this are nearly straight where the part is not itself as large.
inline constexpr double kFarthestCenter = 1000;
/// mm. Tighter arcs stay arcs wherever they are: those of parts of a metre.
inline constexpr double kNarrowArc = 400;

/// Whether an arc is so wide that its center is beyond kFarthestCenter.
bool is_wide_arc(const Edge& edge);

/// Writes the wide arcs of a pass as lines that deviate from them by no more than is permitted and stay in the legal area; arcs that no such
/// lines replace stay. Returns the arcs that were replaced.
std::vector<Edge> straighten_wide_arcs(Pass& pass, const Deviation& deviation);

}  // namespace clearcut::plan::adaptive
