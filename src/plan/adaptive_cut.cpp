#include "plan/adaptive_cut.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace clearcut {
namespace {

constexpr int kSamples = 24;

double wrapped(double angle) {
  return std::remainder(angle, 2 * kPi);
}

/// Contact at one position: the cutter's circle outside `cleared`, within its front half.
double contact_at(double direction, const Disc& cleared, const Disc& next, double tool_radius) {
  const Vec2 p = next.center + direction_of(direction) * (next.radius - tool_radius);
  const Vec2 from_cleared = p - cleared.center;
  const double d = norm(from_cleared);
  if (d + tool_radius <= cleared.radius) return 0;
  if (d < 1e-12) return kPi;
  const double cosine =
      (cleared.radius * cleared.radius - d * d - tool_radius * tool_radius) / (2 * d * tool_radius);
  const double half = std::acos(std::clamp(cosine, -1.0, 1.0));
  const double middle = wrapped(angle_of(from_cleared) - direction);
  return std::max(0.0, std::min(middle + half, kPi) - std::max(middle - half, 0.0));
}

}  // namespace

double crescent_half_angle(const Disc& cleared, const Disc& next) {
  const double shift = distance(cleared.center, next.center);
  if (next.radius + shift <= cleared.radius) return 0;
  if (shift < 1e-12) return kPi;
  const double cosine = (cleared.radius * cleared.radius - next.radius * next.radius - shift * shift) /
                        (2 * shift * next.radius);
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

double crescent_engagement(const Disc& cleared, const Disc& next, double tool_radius) {
  const double half = crescent_half_angle(cleared, next);
  if (half == 0) return 0;
  const Vec2 shift = next.center - cleared.center;
  const double axis = norm(shift) < 1e-12 ? 0 : angle_of(shift);
  double greatest = 0;
  for (int i = 0; i <= kSamples; ++i) {
    const double direction = axis + half * (2.0 * i / kSamples - 1);
    greatest = std::max(greatest, contact_at(direction, cleared, next, tool_radius));
  }
  return greatest;
}

double widened_circle(double cleared_radius, double tool_radius, double engagement) {
  const double across = tool_radius * std::sin(engagement);
  const double inside = std::max(0.0, cleared_radius * cleared_radius - across * across);
  return -tool_radius * std::cos(engagement) + std::sqrt(inside);
}

}  // namespace clearcut
