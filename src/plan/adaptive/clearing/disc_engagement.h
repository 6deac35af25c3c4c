// Engagement of a cutter that widens a cleared disc, in closed form.
#pragma once

#include "geometry/vec2.h"

namespace clearcut::plan::adaptive {

/// A disc of cleared material.
struct Disc {
  Vec2 center;
  double radius = 0;  ///< mm
};

/// mm; the greatest radius of a circle on which the centre may run inside a cleared disc of `cleared_radius`
/// mm so that the engagement is at most `engagement` radians. Both are about the same centre. By the law of
/// cosines, with R for tool_radius: -R cos(engagement) + sqrt(cleared_radius^2 - R^2 sin(engagement)^2).
double widened_circle(double cleared_radius, double tool_radius, double engagement);

}  // namespace clearcut::plan::adaptive
