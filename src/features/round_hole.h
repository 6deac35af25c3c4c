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

/// The circle bounding `feature`, if the feature has no other boundary: one outline, no islands, walls without draft,
/// no open side. Arcs of the outline may differ by tol.join_gap, as in drawings; the smallest radius counts.
std::optional<RoundHole> round_hole_of(const Feature& feature, const Tolerances& tol);

/// z down to which a step clears its feature to the tool's full width: a drill ends in a point.
double full_depth(const Part& part, const Workingstep& step);

/// Whether a plunge of `tool` at its centre makes the whole hole: its diameter is greater than the hole's by at
/// most tol.fit, or smaller by at most tol.uncut, up to rounding.
bool makes_hole(const Tool& tool, const RoundHole& hole, const Tolerances& tol);

/// mm. A hole may be made by a drill that is wider or narrower than the hole by this much, if no other cutter makes
/// the hole.
inline constexpr double kNearDrill = 0.05;

/// Whether the drill's diameter, mm, equals the hole's or is near enough to be used for the hole.
bool is_near_size(double drill, double hole);

/// Whether the tool is a drill whose point is longer than the feature is deep: a tip that ends on the floor leaves a cone
/// that is nowhere as wide as the drill.
bool is_shallower_than_point(const Feature& feature, const Tool& tool, const Tolerances& tol);

/// Whether the step's tool has only vertical moves and cannot make its round hole, because the tool is narrower or the hole
/// shallower than its point, no other step works on the hole, and the tool was not named by the user: the drilled hole would
/// differ from the drawn one.
bool leaves_hole_undone(const Part& part, const Workingstep& step, const Tolerances& tol);

/// The holes that exist within reach of a workingstep's passes when the step begins, and in which a cutter no wider
/// than the hole can descend: predrilled ones, and those made by earlier steps at least as deep as this step.
/// Cost O(steps).
std::vector<PredrilledHole> holes_before(const Part& part, int workingstep, const Tolerances& tol);

}  // namespace clearcut::features
