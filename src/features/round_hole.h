// Features that consist of one upright circle: they are drilled, reamed or bored instead of cleared.
#pragma once

#include <optional>
#include <vector>

#include "base/tolerances.h"
#include "model/part.h"

namespace clearcut::features {

/// A circle in plan view. mm.
struct RoundHole {
  Vec2 center;
  double radius = 0;
};

/// The circle that bounds `feature`, if there is nothing else: one outline, no islands, walls without draft,
/// no open side. Arcs of the outline may differ by tol.join_gap, as in drawings; the smallest radius counts.
std::optional<RoundHole> round_hole_of(const Feature& feature, const Tolerances& tol);

/// z down to which a step clears its feature as wide as its tool is: a drill ends in a point.
double full_depth(const Part& part, const Workingstep& step);

/// Whether a plunge of `tool` at its centre makes the whole hole: its diameter is greater than the hole's by at
/// most tol.fit, or smaller by at most tol.uncut, up to rounding.
bool makes_hole(const Tool& tool, const RoundHole& hole, const Tolerances& tol);

/// mm. A hole may be made by a drill that is wider or narrower than it by this much, where no other cutter makes it.
inline constexpr double kNearDrill = 0.05;

/// Whether the drill's diameter, mm, is the hole's or so near that it may be taken for it.
bool is_near_size(double drill, double hole);

/// Whether the step's tool only goes straight down and is narrower than its round hole, on which no other step works, and nobody named
/// the tool for it: what it would drill is another hole than the one that is drawn.
bool is_too_narrow_for_hole(const Part& part, const Workingstep& step, const Tolerances& tol);

/// The holes that exist within reach of a workingstep's passes when it begins, and in which a cutter no wider
/// than they are can go down: predrilled ones, and those that earlier steps made at least as deep as this
/// step goes. Cost O(steps).
std::vector<PredrilledHole> holes_before(const Part& part, int workingstep, const Tolerances& tol);

}  // namespace clearcut::features
