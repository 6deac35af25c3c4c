// Features that are one upright circle: drilled, reamed or bored rather than cleared.
#pragma once

#include <optional>
#include <vector>

#include "base/tolerances.h"
#include "model/part.h"

namespace clearcut::stock {

/// A circle in plan. mm.
struct RoundHole {
  Vec2 center;
  double radius = 0;
};

/// The circle that bounds `feature`, where that is all there is: one outline, no islands, upright walls, no open
/// side. The arcs of the outline may differ by tol.join_gap, as those of drawings do; the smallest radius counts.
std::optional<RoundHole> round_hole_of(const Feature& feature, const Tolerances& tol);

/// Drills and reamers: they only go straight down.
bool only_plunges(const Tool& tool);

/// Whether a plunge of `tool` at its centre makes the whole hole: as wide to within tol.fit, and no narrower than
/// a residual of tol.uncut all round.
bool makes_hole(const Tool& tool, const RoundHole& hole, const Tolerances& tol);

/// The paths down that are there, in reach of its passes, when a workingstep begins, for cutters that are no wider: predrilled holes, and those that
/// earlier steps have made at least as deep as the step goes. Cost O(steps).
std::vector<PredrilledHole> holes_before(const Part& part, int workingstep, const Tolerances& tol);

}  // namespace clearcut::stock
