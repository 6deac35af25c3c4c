#include "plan/contour/corner_loop.h"

#include <algorithm>
#include <cmath>

namespace clearcut::plan::contour {
namespace {

/// mm. Loops shorter than this clear nothing.
constexpr double kShortest = 1e-3;
/// sin(alpha / 2) of corners too flat for a loop with sides.
constexpr double kFlattest = 0.999;

Path circle(Vec2 root, Vec2 tip) {
  const Vec2 center = lerp(root, tip, 0.5);
  return {Edge::arc(root, tip, center, Turn::kCounterClockwise),
          Edge::arc(tip, root, center, Turn::kCounterClockwise)};
}

/// `point` mirrored at the line from `root` along the unit vector `axis`.
Vec2 mirrored(Vec2 point, Vec2 root, Vec2 axis) {
  const Vec2 d = point - root;
  return root + axis * (2 * dot(d, axis)) - d;
}

/// A kite whose sides at the tip are parallel to the corner's; the other two sides are square to them.
Path kite(Vec2 root, Vec2 tip, double half_sine) {
  const Vec2 path = tip - root, axis = unit(path), across{-axis.y, axis.x};
  const double half_cosine = std::sqrt(1 - half_sine * half_sine), side = norm(path) * half_sine;
  const Vec2 foot = root + axis * (side * half_sine) + across * (side * half_cosine);
  const Vec2 other = mirrored(foot, root, axis);
  return {Edge::line(root, foot), Edge::line(foot, tip), Edge::line(tip, other), Edge::line(other, root)};
}

/// A loop that continues straight along `in`, on an arc through the tip, and back along `out`; symmetric about
/// the line to the tip.
Path tangent_loop(Vec2 root, Vec2 tip, double half_sine, Vec2 in) {
  const Vec2 path = tip - root, axis = unit(path);
  const double radius = norm(path) * half_sine / (1 + half_sine);
  const double straight = radius * std::sqrt(1 - half_sine * half_sine) / half_sine;
  const Vec2 center = tip - axis * radius, across{-axis.y, axis.x};
  const double side = dot(in, across) > 0 ? 1 : -1, half_cosine = std::sqrt(1 - half_sine * half_sine);
  const Vec2 leave = root + (axis * half_cosine + across * (side * half_sine)) * straight;
  const Vec2 back = mirrored(leave, root, axis);
  return {Edge::line(root, leave),
          Edge::arc(leave, back, center, side > 0 ? Turn::kClockwise : Turn::kCounterClockwise),
          Edge::line(back, root)};
}

}  // namespace

std::optional<Path> corner_loop(CornerLoop kind, Vec2 root, Vec2 tip, Vec2 in, Vec2 out, double radius) {
  const double far = distance(root, tip);
  if (far < kShortest || (kind == CornerLoop::kCircle && far > 2 * radius)) return std::nullopt;
  if (kind == CornerLoop::kCircle) return circle(root, tip);
  // The contour turns by pi - alpha at its corner.
  const double half_sine = std::sqrt(std::max(0.0, (1 + dot(in, out)) / 2));
  if (cross(in, out) <= 0 || half_sine > kFlattest || half_sine < 1 - kFlattest) return std::nullopt;
  const double half_width = kind == CornerLoop::kPwid ? far * half_sine * std::sqrt(1 - half_sine * half_sine)
                                                      : far * half_sine / (1 + half_sine);
  if (half_width > radius) return std::nullopt;
  if (kind == CornerLoop::kPwid) return kite(root, tip, half_sine);
  Path loop = tangent_loop(root, tip, half_sine, in);
  if (kind == CornerLoop::kSingle) return loop;
  Path twice = tangent_loop(root, lerp(root, tip, 0.5), half_sine, in);
  twice.insert(twice.end(), loop.begin(), loop.end());
  return twice;
}

}  // namespace clearcut::plan::contour
