#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "plan/contour.h"

namespace clearcut {
namespace {

/// Interior angles up to this are corners; beyond it the contour is smooth or reflex there.
constexpr double kSmooth = kPi - 1e-6;
/// Angles nearer than this are equal: a regular polygon has no single smallest angle.
constexpr double kSameAngle = 1e-6;

double interior_angle(const Edge& before, const Edge& after) {
  const Vec2 in = before.tangent_at(1), out = after.tangent_at(0);
  return kPi - std::atan2(cross(in, out), dot(in, out));
}

void add_angles(const Loop& loop, std::vector<double>& angles) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const double angle = interior_angle(loop[i], loop[(i + 1) % loop.size()]);
    if (angle < kSmooth) angles.push_back(angle);
  }
}

std::vector<double> sorted_corner_angles(const Region& contour) {
  std::vector<double> angles;
  add_angles(contour.outer(), angles);
  for (const auto& island : contour.islands()) add_angles(island, angles);
  std::sort(angles.begin(), angles.end());
  return angles;
}

}  // namespace

double kappa(double alpha) {
  return (std::sin(alpha / 2) + 1) / 2;
}

double rho(double alpha, double radius, double w) {
  return (radius - w) * std::sin(alpha / 2) / (2 * radius) + 0.5;
}

double residual_size(double alpha, double radius, double overlap) {
  return (radius - 2 * radius * overlap) / std::sin(alpha / 2) - radius;
}

double passage_length(double step, double alpha) {
  return step / std::sin(alpha / 2);
}

double smallest_angle(const Region& contour) {
  const auto angles = sorted_corner_angles(contour);
  return angles.empty() ? kPi : angles.front();
}

double second_smallest_angle(const Region& contour) {
  const auto angles = sorted_corner_angles(contour);
  if (angles.empty()) return kPi;
  if (angles.size() == 1) return kPi;
  return angles[1] - angles[0] > kSameAngle ? angles[1] : angles[0];
}

}  // namespace clearcut
