// Engagement of a cutter that widens a cleared disc, in closed form.
#pragma once

#include "geometry/vec2.h"

namespace clearcut::plan::adaptive {

/// A disc of cleared material.
struct Disc {
  Vec2 center;
  double radius = 0;  ///< mm
};

/// The greatest radius of a circle that the centre may run on inside a cleared disc of `cleared_radius`
/// without more than `engagement` radians; both about the same centre. From the law of cosines: with the
/// engagement beginning at distance cleared_radius, d = -R cos(theta) + sqrt(cleared^2 - R^2 sin(theta)^2).
double widened_circle(double cleared_radius, double tool_radius, double engagement);

}  // namespace clearcut::plan::adaptive
