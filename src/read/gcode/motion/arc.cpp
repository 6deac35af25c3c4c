#include "read/gcode/motion/arc.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/error.h"
#include "base/text.h"
#include "base/units.h"

namespace clearcut::read::gcode {

namespace {

constexpr double kSamePoint = 1e-7;   // mm; nearer ends mean a full circle
constexpr double kRoundRadii = 1e-3;  // mm; radii that agree better are one circle
constexpr double kSpiralPiece = kPi / 4;
constexpr double kWidestPiece = 1.5 * kPi;  // beyond it the centre through both ends is ill-conditioned

/// The centre nearest to `center` that is equally far from both ends.
Vec2 recentered(Vec2 from, Vec2 to, Vec2 center) {
  const Vec2 along = unit(to - from);
  return center - along * dot(center - (from + to) / 2, along);
}

double swept(Vec2 from, Vec2 to, Vec2 center, Turn turn) {
  const double side = turn == Turn::kCounterClockwise ? 1.0 : -1.0;
  const double angle = side * base::atan2(cross(from - center, to - from), dot(from - center, to - center));
  return angle > 0 ? angle : angle + 2 * kPi;
}

}  // namespace

ArcShape arc_about(Vec2 from, Vec2 to, Vec2 center, Turn turn, int turns, const RadiusRule& rule,
                   const std::string& place) {
  const double start = distance(from, center), end = distance(to, center);
  const double mismatch = std::abs(start - end);
  if (std::min(start, end) <= kSamePoint) {
    throw InputError(place, "arc of radius zero; correct I, J, K");
  }
  if (mismatch > rule.loose || (mismatch > rule.tight && mismatch > 0.001 * std::max(start, end))) {
    throw InputError(place, "arc whose radius is " + trimmed(start, 4) + " mm at its start and " +
                                trimmed(end, 4) +
                                " mm at its end; controls refuse it, post with more decimals");
  }
  const bool full = distance(from, to) <= kSamePoint;
  const double base = full ? 2 * kPi : swept(from, to, center, turn);
  return {from, to, center, turn, base + 2 * kPi * (turns - 1)};
}

ArcShape arc_of_radius(Vec2 from, Vec2 to, double radius, Turn turn, const RadiusRule& rule,
                       const std::string& place) {
  const double half = distance(from, to) / 2, size = std::abs(radius);
  if (half <= kSamePoint) {
    throw InputError(place, "arc by radius that ends where it starts; give its centre by I, J, K");
  }
  if (half > size + rule.tight) {
    throw InputError(place, "arc of radius " + trimmed(size, 4) + " mm cannot reach its end, " +
                                trimmed(2 * half, 4) + " mm away; correct R");
  }
  const double height = std::sqrt(std::max(0.0, (size - half) * (size + half)));
  const bool left = (turn == Turn::kCounterClockwise) == (radius > 0);
  const Vec2 center = (from + to) / 2 + left_of(unit(to - from)) * (left ? height : -height);
  return {from, to, center, turn, swept(from, to, center, turn)};
}

std::vector<Edge> arc_edges(const ArcShape& shape) {
  const Vec2 arm = shape.from - shape.center;
  const double start = norm(arm), end = distance(shape.to, shape.center);
  int pieces = static_cast<int>(std::ceil(shape.sweep / kWidestPiece - 1e-12));
  if (std::abs(start - end) > kRoundRadii) pieces = static_cast<int>(std::ceil(shape.sweep / kSpiralPiece));
  pieces = std::max(pieces, 1);
  const double side = shape.turn == Turn::kCounterClockwise ? 1.0 : -1.0;
  std::vector<Edge> edges;
  Vec2 from = shape.from;
  for (int k = 1; k <= pieces; ++k) {
    const double t = static_cast<double>(k) / pieces;
    const Vec2 to =
        k == pieces ? shape.to
                    : shape.center + rotated(unit(arm), side * shape.sweep * t) * std::lerp(start, end, t);
    edges.push_back(Edge::arc(from, to, recentered(from, to, shape.center), shape.turn));
    from = to;
  }
  return edges;
}

}  // namespace clearcut::read::gcode
