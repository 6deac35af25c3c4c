#include "support/independent/drawn_outline.h"

#include <algorithm>
#include <cmath>

namespace clearcut::test_support {
namespace {

Vec2 turned_left(Vec2 v) {
  return {-v.y, v.x};
}

Side side_of(Vec2 from, Vec2 to, double bulge) {
  Side side{from, to};
  if (bulge == 0) return side;
  const Vec2 chord = to - from;
  const double size = std::hypot(chord.x, chord.y), sweep = 4 * std::atan(bulge);
  const double signed_radius = size / (2 * std::sin(sweep / 2));
  side.sweep = sweep;
  side.radius = std::abs(signed_radius);
  side.center = from + chord * 0.5 + turned_left(chord) * (signed_radius * std::cos(sweep / 2) / size);
  return side;
}

/// On which side of the chord p lies: > 0 to the left.
double left_of_chord(const Side& side, Vec2 p) {
  const Vec2 along = side.to - side.from, from = p - side.from;
  return along.x * from.y - along.y * from.x;
}

/// Whether p lies on the arc's own side of its chord: arcs here are less than half a circle, so that seen from the center, too.
bool is_beyond_chord(const Side& side, Vec2 p) {
  return left_of_chord(side, p) * side.sweep < 0;
}

double to_side(Vec2 p, const Side& side) {
  if (side.sweep == 0) return to_segment(p, side.from, side.to);
  const Vec2 from_center = p - side.center;
  const double away = std::hypot(from_center.x, from_center.y);
  const Vec2 nearest = side.center + from_center * (side.radius / std::max(away, 1e-12));
  if (is_beyond_chord(side, nearest)) return std::abs(away - side.radius);
  return std::min(std::hypot(p.x - side.from.x, p.y - side.from.y),
                  std::hypot(p.x - side.to.x, p.y - side.to.y));
}

}  // namespace

std::vector<Side> sides_of(const std::vector<BulgeVertex>& corners) {
  std::vector<Side> sides;
  for (std::size_t i = 0; i < corners.size(); ++i)
    sides.push_back(side_of(corners[i].point, corners[(i + 1) % corners.size()].point, corners[i].bulge));
  return sides;
}

void add_samples(const Side& side, double step, std::vector<Sample>& samples) {
  const Vec2 chord = side.to - side.from;
  const double size = std::hypot(chord.x, chord.y);
  const int count =
      1 + static_cast<int>((side.sweep == 0 ? size : std::abs(side.radius * side.sweep)) / step);
  const double start = std::atan2(side.from.y - side.center.y, side.from.x - side.center.x);
  for (int i = 0; i < count; ++i) {
    const double share = (i + 0.5) / count;
    if (side.sweep == 0) {
      samples.push_back({side.from + chord * share, turned_left(chord) * (-1 / size)});
      continue;
    }
    const double angle = start + side.sweep * share;
    const Vec2 away{std::cos(angle), std::sin(angle)};
    samples.push_back({side.center + away * side.radius, away * (side.sweep > 0 ? 1.0 : -1.0)});
  }
}

double to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a, from = p - a;
  const double squared = along.x * along.x + along.y * along.y;
  const double t = squared > 0 ? std::clamp((from.x * along.x + from.y * along.y) / squared, 0.0, 1.0) : 0.0;
  return std::hypot(from.x - t * along.x, from.y - t * along.y);
}

double signed_distance(Vec2 p, const std::vector<Side>& outline) {
  double nearest = HUGE_VAL;
  bool within = false;
  for (const Side& side : outline) {
    const Vec2 a = side.from, b = side.to;
    nearest = std::min(nearest, to_side(p, side));
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) within = !within;
    const bool in_bow = side.sweep != 0 && is_beyond_chord(side, p) &&
                        std::hypot(p.x - side.center.x, p.y - side.center.y) < side.radius;
    if (in_bow) within = !within;
  }
  return within ? -nearest : nearest;
}

}  // namespace clearcut::test_support
