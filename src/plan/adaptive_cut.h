// Engagement of a cutter that widens cleared discs, in closed form.
#pragma once

#include "geometry/vec2.h"

namespace clearcut {

/// A disc of cleared material.
struct Disc {
  Vec2 center;
  double radius = 0;  ///< mm
};

/// The part of `next`'s circle outside `cleared`: half of its angle about the direction from cleared to next.
/// 0 when next lies inside cleared, pi when all of its circle is outside.
double crescent_half_angle(const Disc& cleared, const Disc& next);

/// Greatest contact angle of a cutter of `tool_radius` that cuts `next` counter-clockwise where only
/// `cleared` is free. Radians. The cutter's centre runs on the circle of next.radius - tool_radius.
double crescent_engagement(const Disc& cleared, const Disc& next, double tool_radius);

/// The greatest radius of a circle that the centre may run on inside a cleared disc of `cleared_radius`
/// without more than `engagement` of contact; both about the same centre. From the law of cosines: with the
/// contact beginning at distance cleared_radius, d = -R cos(theta) + sqrt(cleared^2 - R^2 sin(theta)^2).
double widened_circle(double cleared_radius, double tool_radius, double engagement);

}  // namespace clearcut
