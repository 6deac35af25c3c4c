#include <algorithm>

#include "base/elementary.h"
#include "base/tolerances.h"
#include "base/units.h"
#include "plan/contour/contour.h"

namespace clearcut::plan::contour {
namespace {

/// Radians. Interior angles up to this are corners; at greater ones the contour is smooth or reflex.
constexpr double kSmooth = kPi - 1e-6;

double interior_angle(const Edge& before, const Edge& after) {
  const Vec2 in = before.tangent_at(1), out = after.tangent_at(0);
  return kPi - base::atan2(cross(in, out), dot(in, out));
}

struct Corner {
  double angle = kPi;
  Vec2 at;
};

void add_corners(const Loop& loop, std::vector<Corner>& corners) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const double angle = interior_angle(loop[i], loop[(i + 1) % loop.size()]);
    if (angle < kSmooth) corners.push_back({angle, loop[i].to});
  }
}

double greatest_angle_of(const Loop& loop) {
  double greatest = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    greatest = std::max(greatest, interior_angle(loop[i], loop[(i + 1) % loop.size()]));
  return greatest;
}

/// Corners by angle, the sharpest first.
std::vector<Corner> sorted_corners(const Region& contour) {
  std::vector<Corner> corners;
  add_corners(contour.outer(), corners);
  for (const auto& island : contour.islands()) add_corners(island, corners);
  std::stable_sort(corners.begin(), corners.end(),
                   [](const Corner& a, const Corner& b) { return a.angle < b.angle; });
  return corners;
}

bool first_is_single(const std::vector<Corner>& sorted) {
  return !sorted.empty() && (sorted.size() == 1 || sorted[1].angle - sorted[0].angle > kSameAngleRad);
}

}  // namespace

double kappa(double alpha) {
  return (base::sin(alpha / 2) + 1) / 2;
}

double rho(double alpha, double radius, double w) {
  return (radius - w) * base::sin(alpha / 2) / (2 * radius) + 0.5;
}

double residual_size(double alpha, double radius, double overlap) {
  return (radius - 2 * radius * overlap) / base::sin(alpha / 2) - radius;
}

double passage_length(double step, double alpha) {
  return step / base::sin(alpha / 2);
}

double smallest_angle(const Region& contour) {
  const auto corners = sorted_corners(contour);
  return corners.empty() ? kPi : corners.front().angle;
}

double greatest_angle(const Region& contour) {
  double greatest = greatest_angle_of(contour.outer());
  for (const auto& island : contour.islands()) greatest = std::max(greatest, greatest_angle_of(island));
  return greatest;
}

double second_smallest_angle(const Region& contour) {
  const auto corners = sorted_corners(contour);
  if (corners.size() < 2) return kPi;
  return first_is_single(corners) ? corners[1].angle : corners[0].angle;
}

std::optional<Vec2> single_smallest_corner(const Region& contour) {
  const auto corners = sorted_corners(contour);
  return first_is_single(corners) ? std::optional(corners.front().at) : std::nullopt;
}

}  // namespace clearcut::plan::contour
