#include "verify/legal_centers.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace clearcut {
namespace {

/// mm. Two walls end in one corner when their ends are this near.
constexpr double kCorner = 1e-6;
/// mm. Rounding of parallel curves: nearer than reach by this is not nearer.
constexpr double kRounding = 1e-7;
/// mm. A stretch where a cutter fits only with the allowance for fit must be this long to count as a slot;
/// less is the tip of a sharp corner.
constexpr double kSlot = 0.05;

using Interval = std::pair<double, double>;

bool is_point(const Edge& edge) {
  return edge.from == edge.to;
}

/// The curve at d on the left of an edge; empty if an arc has no curve there, a point if it shrinks to its
/// centre.
std::optional<Edge> parallel(const Edge& edge, double d, double fit) {
  if (!edge.is_arc()) {
    const Vec2 aside = left_of(unit(edge.to - edge.from)) * d;
    return Edge::line(edge.from + aside, edge.to + aside);
  }
  const double radius = edge.radius();
  const double shifted = edge.turn == Turn::kCounterClockwise ? radius - d : radius + d;
  if (shifted < -fit) return std::nullopt;
  if (shifted <= fit) return Edge::line(edge.center, edge.center);
  const double k = shifted / radius;
  return Edge::arc(edge.center + (edge.from - edge.center) * k, edge.center + (edge.to - edge.center) * k,
                   edge.center, edge.turn);
}

std::vector<Edge> circle(Vec2 center, double radius) {
  const Vec2 a = center + Vec2{radius, 0}, b = center - Vec2{radius, 0};
  return {Edge::arc(a, b, center, Turn::kCounterClockwise), Edge::arc(b, a, center, Turn::kCounterClockwise)};
}

/// Curves that together hold the outline of all points within d of an edge.
std::vector<Edge> outline_within(const Edge& edge, double d) {
  std::vector<Edge> out = circle(edge.from, d);
  for (const Edge& half : circle(edge.to, d)) out.push_back(half);
  for (const Edge& side : {edge, edge.reversed()}) {
    const auto curve = parallel(side, d, 0);
    if (curve && !is_point(*curve)) out.push_back(*curve);
  }
  return out;
}

/// Takes from `parts` of the curve the stretches that are not legal: `cuts` are all places where that may
/// change.
template <typename IsLegal>
void keep_legal(std::vector<Interval>& parts, std::vector<double>& cuts, IsLegal is_legal) {
  std::sort(cuts.begin(), cuts.end());
  std::vector<Interval> kept;
  for (const Interval& part : parts) {
    double from = part.first;
    const auto keep_until = [&](double to) {
      if (to <= from) return;
      const bool legal = is_legal((from + to) / 2);
      if (legal && !kept.empty() && kept.back().second == from) {
        kept.back().second = to;
      } else if (legal) {
        kept.emplace_back(from, to);
      }
      from = to;
    };
    for (const double t : cuts) {
      if (t > part.first && t < part.second) keep_until(t);
    }
    keep_until(part.second);
  }
  parts = std::move(kept);
}

void append_cuts(const Edge& curve, const Edge& wall, double d, std::vector<double>& cuts) {
  for (const Edge& limit : outline_within(wall, d)) {
    for (const Vec2 p : intersections(curve, limit)) cuts.push_back(nearest(curve, p).t);
  }
}

/// Whether [from, to] is inside one of the intervals.
bool is_inside(const std::vector<Interval>& intervals, const Interval& part) {
  return std::any_of(intervals.begin(), intervals.end(),
                     [&](const Interval& i) { return i.first <= part.first && part.second <= i.second; });
}

}  // namespace

LegalCenters::LegalCenters(const FinishedPart& part, double z, double reach, const Box& area,
                           const Tolerances& tol)
    : part_(part), z_(z), reach_(reach), fit_(tol.fit) {
  std::vector<int> walls;
  part.wall_tree().overlapping(area.grown(reach + part.greatest_lean()), [&](int i) {
    if (part.walls()[i].stands_at(z)) walls.push_back(i);
  });
  add_wall_curves(walls);
  add_corner_curves(walls);
  boundary_ = EdgeTree(std::move(found_));
}

void LegalCenters::add_wall_curves(const std::vector<int>& walls) {
  for (const int i : walls) {
    const Wall& wall = part_.walls()[i];
    const auto curve = parallel(wall.edge, reach_ + wall.lean(z_), fit_);
    if (!curve) continue;
    if (is_point(*curve)) {
      add_fit_point(curve->from);
    } else {
      add_legal_parts(*curve);
    }
  }
}

/// Arcs about the ends of walls where the part's corner points into the free area.
void LegalCenters::add_corner_curves(const std::vector<int>& walls) {
  std::vector<std::pair<Vec2, int>> starts;
  for (const int i : walls) starts.emplace_back(part_.walls()[i].edge.from, i);
  std::sort(starts.begin(), starts.end(), [](const auto& a, const auto& b) {
    return std::make_pair(a.first.x, a.second) < std::make_pair(b.first.x, b.second);
  });
  for (const int i : walls) {
    const Wall& wall = part_.walls()[i];
    const Vec2 corner = wall.edge.to, heading = wall.edge.tangent_at(1);
    const double d = reach_ + wall.lean(z_);
    bool matched = false;
    auto next = std::lower_bound(starts.begin(), starts.end(), corner.x - kCorner,
                                 [](const auto& start, double x) { return start.first.x < x; });
    for (; next != starts.end() && next->first.x <= corner.x + kCorner; ++next) {
      if (distance(next->first, corner) > kCorner) continue;
      matched = true;
      const Vec2 after = part_.walls()[next->second].edge.tangent_at(0);
      if (cross(heading, after) >= 0) continue;
      const Edge arc =
          Edge::arc(corner + left_of(heading) * d, corner + left_of(after) * d, corner, Turn::kClockwise);
      if (distance(arc.from, arc.to) > kRounding) add_legal_parts(arc);
    }
    if (matched) continue;
    for (const Edge& half : circle(corner, d)) add_legal_parts(half);
  }
}

void LegalCenters::add_fit_point(Vec2 p) {
  if (clearance_over_reach(p) >= -fit_) found_.push_back(Edge::line(p, p));
}

void LegalCenters::add_legal_parts(const Edge& curve) {
  const std::vector<Interval> fitting = legal_parts(curve, fit_);
  if (fitting.empty()) return;
  const std::vector<Interval> legal = legal_parts(curve, kRounding);
  const double length = curve.length();
  const auto add = [&](const Interval& part) {
    const Edge piece = curve.part(part.first, part.second);
    if (!is_point(piece) && part_.is_free(piece.at(0.5), z_)) found_.push_back(piece);
  };
  for (const Interval& part : legal) {
    if ((part.second - part.first) * length > kRounding) add(part);
  }
  for (const Interval& part : fitting) {
    if ((part.second - part.first) * length > kSlot && !is_inside(legal, part)) add(part);
  }
}

std::vector<Interval> LegalCenters::legal_parts(const Edge& curve, double allowed) const {
  std::vector<Interval> parts{{0, 1}};
  const double half = curve.length() / 2, upright = reach_ - allowed;
  const Vec2 middle = curve.at(0.5);
  part_.wall_tree().overlapping(curve.box().grown(reach_ + part_.greatest_lean()), [&](int i) {
    if (parts.empty()) return;
    const Wall& wall = part_.walls()[i];
    const double farthest = upright + wall.lean(z_);
    if (!wall.stands_at(z_) || distance(wall.edge, middle) >= farthest + half) return;
    if (distance(curve, wall.edge) >= farthest) return;
    std::vector<double> cuts;
    append_cuts(curve, wall.edge, upright, cuts);
    if (farthest > upright) append_cuts(curve, wall.edge, farthest, cuts);
    keep_legal(parts, cuts, [&](double t) {
      const Vec2 p = curve.at(t);
      return distance(wall.edge, p) >= upright + part_.lean(wall, z_, p);
    });
  });
  return parts;
}

/// Least over all walls of distance - reach, as far as it is negative; 0 otherwise.
double LegalCenters::clearance_over_reach(Vec2 p) const {
  double least = 0;
  const double far = reach_ + part_.greatest_lean();
  part_.wall_tree().nearest(p, far, [&](int i) {
    const Wall& wall = part_.walls()[i];
    if (!wall.stands_at(z_)) return false;
    const double apart = distance(wall.edge, p) - reach_;
    if (apart < wall.lean(z_)) least = std::min(least, apart - part_.lean(wall, z_, p));
    return false;
  });
  return least;
}

bool LegalCenters::contains(Vec2 p) const {
  return clearance_over_reach(p) >= -kRounding && part_.is_free(p, z_);
}

}  // namespace clearcut
