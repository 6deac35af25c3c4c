#include "plan/adaptive_arcs.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace clearcut {
namespace {

/// Arcs flatter than this (sagitta, mm) are lines; wider than this (radius, mm) too.
constexpr double kFlat = 1e-4;
constexpr double kWidest = 5000;
/// Points that make an arc.
constexpr std::size_t kFewest = 5;
/// Cosine of the angle that the ends of one arc instead of two may be turned by: 0.25 degrees.
constexpr double kSmooth = 0.99999;

std::optional<Vec2> circle_center(Vec2 a, Vec2 b, Vec2 c) {
  const Vec2 u = b - a, v = c - a;
  const double d = 2 * cross(u, v);
  if (std::abs(d) < 1e-12) return std::nullopt;
  return a +
         Vec2{v.y * norm_squared(u) - u.y * norm_squared(v), u.x * norm_squared(v) - v.x * norm_squared(u)} /
             d;
}

Edge edge_through(Vec2 a, Vec2 b, Vec2 c) {
  const double sagitta = std::abs(cross(unit(c - a), b - a));
  const auto center = circle_center(a, b, c);
  if (sagitta < kFlat || !center || distance(*center, a) > kWidest) return Edge::line(a, c);
  return Edge::arc(a, c, *center, cross(b - a, c - b) > 0 ? Turn::kCounterClockwise : Turn::kClockwise);
}

/// The edge from first to last through a point between them, if all others are near it.
std::optional<Edge> fitted(std::span<const Vec2> points, double tolerance) {
  // Through three or four points there is an arc even where they turn a corner.
  const Edge edge = points.size() < kFewest
                        ? Edge::line(points.front(), points.back())
                        : edge_through(points.front(), points[points.size() / 2], points.back());
  if (std::abs(edge.sweep()) > 3) return std::nullopt;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    if (distance(edge, points[i]) > tolerance) return std::nullopt;
    // Between the points, too: their chords' middles may not stand off a different circle.
    const Vec2 middle = (points[i] + points[i + 1]) / 2.0;
    if (distance(edge, middle) > 2 * tolerance + norm_squared(points[i + 1] - points[i])) return std::nullopt;
  }
  return edge;
}

}  // namespace

Path fit_arcs(std::span<const Vec2> points, double tolerance) {
  Path out;
  for (std::size_t at = 0; at + 1 < points.size();) {
    std::size_t good = 1, bad = points.size() - at;
    Edge edge = Edge::line(points[at], points[at + 1]);
    const auto try_count = [&](std::size_t count) {
      const auto found = fitted(points.subspan(at, count + 1), tolerance);
      if (found) edge = *found;
      (found ? good : bad) = count;
      return found.has_value();
    };
    for (std::size_t count = kFewest - 1; count < bad && try_count(count);)
      count = std::min(count * 2, std::max(count + 1, bad - 1));
    while (bad - good > 1) try_count(good + (bad - good) / 2);
    out.push_back(edge);
    at += good;
  }
  return out;
}

namespace {

/// The edge from p along `heading` to q.
Edge tangent_edge(Vec2 p, Vec2 heading, Vec2 q) {
  const Vec2 way = q - p, normal = left_of(heading);
  const double aside = dot(normal, way);
  const double radius = std::abs(aside) < 1e-12 ? 1e300 : norm_squared(way) / (2 * aside);
  if (std::abs(radius) > kWidest) return Edge::line(p, q);
  return Edge::arc(p, q, p + normal * radius, radius > 0 ? Turn::kCounterClockwise : Turn::kClockwise);
}

/// Two edges that leave `a` and reach `b` in their headings, with tangents of the same length; none when the
/// headings turn too far.
std::optional<std::pair<Edge, Edge>> biarc(const CurvePoint& a, const CurvePoint& b) {
  const Vec2 v = b.point - a.point;
  const double along = dot(v, a.heading + b.heading), turned = 2 * (1 - dot(a.heading, b.heading));
  if (along <= 0 || turned > 2) return std::nullopt;
  const double d = turned < 1e-9 ? norm_squared(v) / (2 * along)
                                 : (std::sqrt(along * along + turned * norm_squared(v)) - along) / turned;
  const Vec2 joint = (a.point + b.point + (a.heading - b.heading) * d) / 2.0;
  if (distance(joint, a.point) < 1e-6 || distance(joint, b.point) < 1e-6) return std::nullopt;
  return std::pair{tangent_edge(a.point, a.heading, joint),
                   tangent_edge(b.point, -b.heading, joint).reversed()};
}

std::optional<std::pair<Edge, Edge>> fitted(std::span<const CurvePoint> points, double tolerance) {
  const auto pair = biarc(points.front(), points.back());
  if (!pair || std::abs(pair->first.sweep()) > 2 || std::abs(pair->second.sweep()) > 2) return std::nullopt;
  for (const CurvePoint& p : points) {
    if (std::min(distance(pair->first, p.point), distance(pair->second, p.point)) > tolerance)
      return std::nullopt;
  }
  return pair;
}

/// One arc where the two of a pair are the same to within `tolerance`.
void append_pair(const std::pair<Edge, Edge>& pair, double tolerance, Path& out) {
  const Vec2 from = pair.first.from, joint = pair.first.to, to = pair.second.to;
  const Edge whole = edge_through(from, joint, to);
  const double off = std::max(distance(whole, pair.first.at(0.5)), distance(whole, pair.second.at(0.5)));
  const bool smooth = dot(whole.tangent_at(0), pair.first.tangent_at(0)) > kSmooth &&
                      dot(whole.tangent_at(1), pair.second.tangent_at(1)) > kSmooth;
  if (smooth && off < tolerance) return out.push_back(whole);
  out.push_back(pair.first);
  out.push_back(pair.second);
}

}  // namespace

Path fit_biarcs(std::span<const CurvePoint> points, double tolerance) {
  Path out;
  for (std::size_t at = 0; at + 1 < points.size();) {
    std::size_t good = 1, bad = points.size() - at;
    std::optional<std::pair<Edge, Edge>> best;
    const auto try_count = [&](std::size_t count) {
      const auto found = fitted(points.subspan(at, count + 1), tolerance);
      if (found) best = found;
      (found ? good : bad) = count;
      return found.has_value();
    };
    for (std::size_t count = 2; count < bad && try_count(count);)
      count = std::min(count * 2, std::max(count + 1, bad - 1));
    while (bad - good > 1) try_count(good + (bad - good) / 2);
    if (best) {
      append_pair(*best, tolerance, out);
    } else {
      out.push_back(Edge::line(points[at].point, points[at + 1].point));
    }
    at += good;
  }
  return out;
}

}  // namespace clearcut
