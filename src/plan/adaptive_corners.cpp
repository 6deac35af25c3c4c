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
constexpr double kPrepared = 1.2;
/// Factor between the distances at which a wall is looked at.
constexpr double kFarther = 1.25;
/// mm. Shorter arcs are lines.
constexpr double kShortArc = 0.006;
/// Radians kept off the limit; and those more that are kept off it farther from the corner than kFar tool radii, for
/// films on the walls: the first that is enough.
constexpr double kMargin = 0.03;
constexpr double kMargins[] = {0, 0.05, 0.12, 0.22};
constexpr double kFar = 0.1;
/// Radians that are no excess.
constexpr double kAbove = 0.02;
/// mm. Shorter cuts are not looked at again.
constexpr double kTiny = 0.05;
constexpr int kMostPasses = 40;
/// The same where the walls are nearer to each other than this times the widest cut: a wider place is cut faster by what takes
/// as much as the limit lets it, whatever the hull.
constexpr int kMostNarrowPasses = 120;
constexpr double kNarrow = 2;
constexpr int kHalvings = 30;
constexpr int kArcLooks = 8;
/// Radians of turn above the limit from which on arcs back cut, too.
constexpr double kWideTurn = 0.45;
/// Share of what a spiral would gain from which on an arc does; radians of its arcs.
constexpr double kArcShare = 0.6;
constexpr double kSpiralTurn = 0.5;
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

/// Distances from the corner along its first wall, side 0, and its second, side 1.
class CornerCuts {
 public:
  /// `margin` radians are kept off the limit farther than kFar from the corner, less nearer to it.
  CornerCuts(const Wall& wall, const Corner& corner, const Ground& ground, double limit, double margin)
      : wall_(wall),
        legal_(ground.legal()),
        radius_(ground.tool_radius()),
        s_(corner.place.s),
        turn_(corner.turn),
        whole_(limit - kMargin),
        limit_(whole_),
        margin_(margin),
        far_(kFar * radius_) {}

  /// The first wall is cut up to a before the corner, the second from b after it.
  Path cuts(double a, double b, double film) {
    cut_[0] = first_[0] = a;
    cut_[1] = first_[1] = b;
    const bool to_and_fro = turn_ - whole_ > kWideTurn;
    const double widest = radius_ * (1 - std::cos(whole_));
    const bool narrow = distance(at(0, a), at(1, b)) < kNarrow * widest;
    const int most = narrow ? kMostNarrowPasses : kMostPasses;
    for (int i = 0, side = 0; i < most && left() > film; ++i, side = to_and_fro ? 1 - side : 0) {
      limit_ = whole_ - margin_ * std::min(1.0, std::max(cut_[0], cut_[1]) / far_);
      if (!to_and_fro || i == 0) go_along_first();
      if (!go_across(side)) break;
    }
    if (path_.empty() || left() > film) return {};
    clear_cusps();
    return std::move(path_);
  }

 private:
  Vec2 at(int side, double x) const { return wall_.at(side == 0 ? s_ - x : s_ + x); }
  /// Heading into the corner.
  Vec2 into(int side, double x) const { return side == 0 ? wall_.heading(s_ - x) : -wall_.heading(s_ + x); }
  /// Angles are > 0 to the side of the other wall.
  static Vec2 turned(int side, Vec2 u, double angle) { return rotated(u, side == 0 ? angle : -angle); }
  static double angle(int side, Vec2 u, Vec2 v) {
    return side == 0 ? angle_between(u, v) : angle_between(v, u);
  }

  /// Angle from the heading on a wall to the centre visited last on the other one.
  double seen(int side, double x) const {
    return angle(side, into(side, x), at(1 - side, cut_[1 - side]) - at(side, x));
  }

  /// As near on the first wall as the limit lets.
  void go_along_first() {
    if (!path_.empty()) path_.push_back(Edge::line(path_.back().to, at(0, cut_[0])));
    const double x = least(cut_[0], [&](double to) { return seen(0, to) <= limit_; });
    if (cut_[0] - x < kNearest / 2) return;
    for (const Edge& edge : wall_.part(s_ - cut_[0], s_ - x)) path_.push_back(edge);
    cut_[0] = x;
  }

  /// To the other wall, nearer than before: on an arc, or where that gains much less, on a spiral.
  bool go_across(int side) {
    const int other = 1 - side;
    const Vec2 from = at(side, cut_[side]);
    const double excess = seen(side, cut_[side]) - limit_;
    const Vec2 heading = turned(side, into(side, cut_[side]), std::max(0.0, excess));
    const double most = cut_[other];
    const double by_arc = least(most, [&](double to) { return is_within(side, from, heading, to); });
    const double by_spiral = excess > 0 ? spiral_end(side) : most;
    const double next = most - by_arc < kArcShare * (most - by_spiral) ? by_spiral : by_arc;
    if (next >= most * kLeastGain) return false;
    if (next == by_arc) {
      path_.push_back(tangent_arc(here(side), heading, at(other, next)));
    } else {
      go_round(side, next);
    }
    cut_[other] = next;
    return true;
  }

  Vec2 here(int side) const { return path_.empty() ? at(side, cut_[side]) : path_.back().to; }

  /// The spiral about the last centre on the other wall, with the heading `limit` off the direction to it: from the pole, the
  /// rays to the cutter shrink by exp(-turn / tan(limit)).
  double spiral_radius(double start, double turn) const { return start * std::exp(-turn / std::tan(limit_)); }

  /// Where it meets the other wall.
  double spiral_end(int side) const {
    const int other = 1 - side;
    const Vec2 pole = at(other, cut_[other]), ray = at(side, cut_[side]) - pole;
    return least(cut_[other], [&](double to) {
      const Vec2 end = at(other, to) - pole;
      return norm(end) <= spiral_radius(norm(ray), angle(side, ray, end));
    });
  }

  /// Along it, up to `next` on the other wall.
  void go_round(int side, double next) {
    const int other = 1 - side;
    const Vec2 pole = at(other, cut_[other]), ray = at(side, cut_[side]) - pole, end = at(other, next);
    const double whole = angle(side, ray, end - pole);
    const int arcs = static_cast<int>(whole / kSpiralTurn) + 1;
    for (int i = 1; i <= arcs; ++i) {
      const Vec2 from = here(side), way = pole - from;
      const double turn = whole * i / arcs;
      const Vec2 to = i == arcs ? end : pole + turned(side, unit(ray), turn) * spiral_radius(norm(ray), turn);
      path_.push_back(tangent_arc(from, turned(side, unit(way), -limit_), to));
    }
  }

  /// Whether the arc to the other wall keeps the limit at its end.
  bool is_within(int side, Vec2 from, Vec2 heading, double to) const {
    const int other = 1 - side;
    const double chord = angle(side, heading, at(other, to) - from);
    return angle(side, turned(side, heading, 2 * chord), at(other, cut_[other]) - at(other, to)) <= limit_;
  }

  /// Between the places where arcs met a wall, cusps stay on it.
  void clear_cusps() {
    if (turn_ - whole_ > kWideTurn) {
      go_to(at(0, cut_[0]));
      const Path along = wall_.part(s_ - first_[0], s_ - cut_[0]), back = reversed(along);
      path_.insert(path_.end(), back.begin(), back.end());
      // Between walls that curve into the area there is no straight way.
      if (!legal_.holds_line(path_.back().to, at(1, cut_[1])))
        path_.insert(path_.end(), along.begin(), along.end());
    }
    go_to(at(1, cut_[1]));
    for (const Edge& edge : wall_.part(s_ + cut_[1], s_ + first_[1])) path_.push_back(edge);
  }

  void go_to(Vec2 p) {
    if (distance(path_.back().to, p) > kNearest / 10) path_.push_back(Edge::line(path_.back().to, p));
  }

  /// Thickness of what stays.
  double left() const {
    const double a = cut_[0], b = cut_[1];
    return a * b * std::sin(turn_) / std::sqrt(a * a + b * b + 2 * a * b * std::cos(turn_));
  }

  static Edge tangent_arc(Vec2 from, Vec2 heading, Vec2 to) {
    const Vec2 way = to - from, normal = left_of(heading);
    const double aside = dot(normal, way), squared = norm_squared(way);
    if (squared < kShortArc * kShortArc || std::abs(aside) < 1e-6) return Edge::line(from, to);
    return Edge::arc(from, to, from + normal * (squared / (2 * aside)),
                     aside > 0 ? Turn::kCounterClockwise : Turn::kClockwise);
  }

  const Wall& wall_;
  const LegalArea& legal_;
  double radius_, s_, turn_, whole_, limit_, margin_, far_;
  double cut_[2] = {}, first_[2] = {};
  Path path_;
};

bool is_legal(const Edge& edge, const LegalArea& legal) {
  if (!edge.is_arc()) return legal.holds_line(edge.from, edge.to);
  for (int i = 0; i <= kArcLooks; ++i) {
    if (!legal.holds(edge.at(static_cast<double>(i) / kArcLooks))) return false;
  }
  return true;
}

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
      const double turn = angle_between(before, after);
      if (turn > limit) corners.push_back({{w, s}, turn});
      s += loop[e].length();
    }
  }
  return corners;
}

std::vector<WallPlace> places_of(const std::vector<Corner>& corners) {
  std::vector<WallPlace> places;
  for (const Corner& corner : corners) places.push_back(corner.place);
  return places;
}

Path corner_cuts(const Walls& walls, const Corner& corner, Ground& ground, double limit, double film) {
  const Wall& wall = walls.wall(corner.place.wall);
  const auto a = first_visited(wall, corner.place.s, -1, ground),
             b = first_visited(wall, corner.place.s, 1, ground);
  if (!a || !b) return {};
  for (const double margin : kMargins) {
    Path found = CornerCuts(wall, corner, ground, limit, margin).cuts(*a, *b, film);
    // Walls that curve much so near to the corner are not what the cuts were found for.
    const bool legal = std::all_of(found.begin(), found.end(),
                                   [&](const Edge& edge) { return is_legal(edge, ground.legal()); });
    if (!legal || found.empty()) continue;
    if (ground.keeps_limit(found, limit + kAbove, kTiny)) return found;
  }
  return {};
}

}  // namespace clearcut
