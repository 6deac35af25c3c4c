#include "plan/adaptive_corners.h"

#include <algorithm>
#include <cmath>
#include <optional>

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

class CornerCuts {
 public:
  CornerCuts(const Wall& wall, const Corner& corner, double limit)
      : wall_(wall),
        s_(corner.place.s),
        turn_(corner.turn),
        limit_(limit - kMargin),
        into_(wall.heading(s_ - 1e-6)) {}

  Path cuts(double a, double b, double film) {
    Path path;
    const double farthest = b;
    for (int i = 0; i < kMostPasses && left(a, b) > film; ++i) {
      const double x = std::min(a, b * std::sin(turn_ - limit_) / std::sin(limit_));
      const double to_pole = std::atan2(b * std::sin(turn_), x + b * std::cos(turn_));
      const double leaving = std::max(0.0, to_pole - limit_), chord = (leaving + turn_ - limit_) / 2;
      const double next = x * std::sin(chord) / std::sin(turn_ - chord);
      if (next >= b * 0.98) break;
      const Vec2 from = before(a), gate = before(x), to = after(next);
      if (!path.empty()) path.push_back(Edge::line(path.back().to, from));
      if (distance(from, gate) > kNearest / 2) path.push_back(Edge::line(from, gate));
      path.push_back(tangent_arc(path.empty() ? from : path.back().to, rotated(into_, leaving), to));
      a = x;
      b = next;
    }
    // Between the places where it met the second wall, cusps stay there.
    if (!path.empty())
      for (const Edge& edge : wall_.part(s_ + b, s_ + farthest)) path.push_back(edge);
    return path;
  }

 private:
  Vec2 before(double x) const { return wall_.at(s_ - x); }
  Vec2 after(double x) const { return wall_.at(s_ + x); }

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
  Vec2 into_;
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
