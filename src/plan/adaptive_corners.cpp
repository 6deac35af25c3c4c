#include "plan/adaptive_corners.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace clearcut {
namespace {

/// mm. Centres nearer than this to the corner are as good as in it; what may stay at a centre that was visited.
constexpr double kNearest = 1e-3;
constexpr double kVisited = 2.5e-3;
/// Tool radii. Walls that are not cut up to this near are not prepared.
constexpr double kPrepared = 0.7;
/// Factor between the distances at which a wall is looked at.
constexpr double kFarther = 1.25;
/// mm. Shorter arcs are lines.
constexpr double kShortArc = 0.006;
/// Radians kept off the limit, for films on the walls.
constexpr double kMargin = 0.03;
constexpr int kMostPasses = 40;
constexpr int kHalvings = 30;
/// A pass that comes no nearer than by this factor is none.
constexpr double kLeastGain = 0.98;

/// From u to v, > 0 to the left.
double angle_between(Vec2 u, Vec2 v) {
  return std::atan2(cross(u, v), dot(u, v));
}

/// The least number of (0, most] that holds, where larger ones do; `most` when none does.
template <typename Holds>
double least(double most, const Holds& holds) {
  double low = 0, high = most;
  for (int i = 0; i < kHalvings; ++i) (holds((low + high) / 2) ? high : low) = (low + high) / 2;
  return high;
}

class CornerCuts {
 public:
  CornerCuts(const Wall& wall, const Corner& corner, double limit)
      : wall_(wall), s_(corner.place.s), turn_(corner.turn), limit_(limit - kMargin) {}

  /// The first wall is cut up to a before the corner, the second from b after it.
  Path cuts(double a, double b, double film) {
    const double farthest = b;
    for (int i = 0; i < kMostPasses && left(a, b) > film; ++i) {
      const double x = least(a, [&](double at) { return seen(at, b) <= limit_; });
      const Vec2 heading = rotated(wall_.heading(s_ - x), std::max(0.0, seen(x, b) - limit_));
      const double next = least(b, [&](double to) { return is_within(before(x), heading, to, b); });
      if (next >= b * kLeastGain) break;
      if (!path_.empty()) path_.push_back(Edge::line(path_.back().to, before(a)));
      along(s_ - a, s_ - x);
      path_.push_back(tangent_arc(path_.empty() ? before(x) : path_.back().to, heading, after(next)));
      a = x;
      b = next;
    }
    // Between the places where it met the second wall, cusps stay there.
    if (!path_.empty()) along(s_ + b, s_ + farthest);
    return std::move(path_);
  }

 private:
  Vec2 before(double x) const { return wall_.at(s_ - x); }
  Vec2 after(double x) const { return wall_.at(s_ + x); }

  void along(double s_from, double s_to) {
    if (s_to - s_from < kNearest / 2) return;
    for (const Edge& edge : wall_.part(s_from, s_to)) path_.push_back(edge);
  }

  /// Angle from the heading on the first wall to the centre visited last on the second.
  double seen(double x, double b) const { return angle_between(wall_.heading(s_ - x), after(b) - before(x)); }

  /// Whether the arc to the second wall keeps the limit at its end.
  bool is_within(Vec2 from, Vec2 heading, double to, double b) const {
    const double chord = angle_between(heading, after(to) - from);
    return angle_between(rotated(heading, 2 * chord), after(b) - after(to)) <= limit_;
  }

  /// Thickness of what stays when the centre comes as near as a and b along the walls.
  double left(double a, double b) const {
    return a * b * std::sin(turn_) / std::sqrt(a * a + b * b + 2 * a * b * std::cos(turn_));
  }

  static Edge tangent_arc(Vec2 from, Vec2 heading, Vec2 to) {
    const Vec2 way = to - from, normal = left_of(heading);
    const double aside = dot(normal, way), squared = norm_squared(way);
    if (squared < kShortArc * kShortArc || aside < 1e-6) return Edge::line(from, to);
    return Edge::arc(from, to, from + normal * (squared / (2 * aside)), Turn::kCounterClockwise);
  }

  const Wall& wall_;
  double s_, turn_, limit_;
  Path path_;
};

/// Distance from the corner to the first centre on a wall that touches nothing.
std::optional<double> first_visited(const Wall& wall, double s, double sign, const Ground& ground) {
  for (double x = kNearest; x < kPrepared * ground.tool_radius(); x *= kFarther) {
    if (!ground.touches(wall.at(s + sign * x), kVisited)) return x;
  }
  return std::nullopt;
}

}  // namespace

std::vector<Corner> corners_of(const Walls& walls, double limit) {
  std::vector<Corner> corners;
  for (std::size_t w = 0; w < walls.count(); ++w) {
    const Loop& loop = walls.wall(w).loop();
    double s = 0;
    for (std::size_t e = 0; e < loop.size(); ++e) {
      const Vec2 before = loop[(e + loop.size() - 1) % loop.size()].tangent_at(1),
                 after = loop[e].tangent_at(0);
      const double turn = std::atan2(cross(before, after), dot(before, after));
      if (turn > limit) corners.push_back({{w, s}, turn});
      s += loop[e].length();
    }
  }
  return corners;
}

Path corner_cuts(const Walls& walls, const Corner& corner, const Ground& ground, double limit, double film) {
  const Wall& wall = walls.wall(corner.place.wall);
  const auto a = first_visited(wall, corner.place.s, -1, ground),
             b = first_visited(wall, corner.place.s, 1, ground);
  if (!a || !b) return {};
  return CornerCuts(wall, corner, limit).cuts(*a, *b, film);
}

}  // namespace clearcut
