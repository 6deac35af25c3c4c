#include "plan/adaptive/clearing/arcs.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace clearcut::plan::adaptive {
namespace {

/// mm. Arcs with a sagitta below kFlat or a radius above kWidest are replaced by lines.
constexpr double kFlat = 1e-4;
constexpr double kWidest = 5000;
/// Radians: greatest turn of an arc.
constexpr double kMostSweep = 3;
/// Radians: two edges are joined only if their headings at the joint differ by less.
constexpr double kSameHeading = 0.008;
/// mm. An arc whose end is nearer than this to the line along its heading is a line.
constexpr double kAside = 1e-6;
/// Smallest number of points that an arc is fitted to.
constexpr std::size_t kFewest = 5;

std::optional<Vec2> circle_center(Vec2 a, Vec2 b, Vec2 c) {
  const Vec2 u = b - a, v = c - a;
  const double d = 2 * cross(u, v);
  if (std::abs(d) < 1e-12) return std::nullopt;
  return a +
         Vec2{v.y * norm_squared(u) - u.y * norm_squared(v), u.x * norm_squared(v) - v.x * norm_squared(u)} /
             d;
}

/// The arc from a to c through b; a line if it is flat.
Edge edge_through(Vec2 a, Vec2 b, Vec2 c) {
  const double sagitta = std::abs(cross(unit(c - a), b - a));
  const auto center = circle_center(a, b, c);
  if (sagitta < kFlat || !center || distance(*center, a) > kWidest) return Edge::line(a, c);
  return Edge::arc(a, c, *center, cross(b - a, c - b) > 0 ? Turn::kCounterClockwise : Turn::kClockwise);
}

bool is_same_heading(Vec2 a, Vec2 b) {
  return dot(a, b) > 0 && std::abs(cross(a, b)) < kSameHeading;
}

/// The edge from the first point to the last through a middle one, if all others are within `tolerance` mm of
/// it.
std::optional<Edge> fitted(std::span<const Vec2> points, double tolerance) {
  // Fewer points always lie on some arc, even if they turn a corner.
  const Edge edge = points.size() < kFewest
                        ? Edge::line(points.front(), points.back())
                        : edge_through(points.front(), points[points.size() / 2], points.back());
  if (std::abs(edge.sweep()) > kMostSweep) return std::nullopt;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (i > 0 && distance(edge, points[i]) > tolerance) return std::nullopt;
    // Also between points, so that an arc of quite another circle through the points is not taken.
    const Vec2 middle = (points[i] + points[i + 1]) / 2.0;
    if (distance(edge, middle) > 2 * tolerance + norm_squared(points[i + 1] - points[i])) return std::nullopt;
  }
  return edge;
}

}  // namespace

Edge tangent_arc(Vec2 from, Vec2 heading, Vec2 to) {
  const Vec2 chord = to - from, normal = left_of(heading);
  const double aside = dot(normal, chord);
  if (std::abs(aside) < kAside) return Edge::line(from, to);
  return Edge::arc(from, to, from + normal * (norm_squared(chord) / (2 * aside)),
                   aside > 0 ? Turn::kCounterClockwise : Turn::kClockwise);
}

std::optional<Edge> joined(const Edge& first, const Edge& second, double tolerance) {
  const double sweep = first.sweep() + second.sweep();
  if (std::abs(sweep) > kMostSweep || first.is_arc() != second.is_arc() ||
      first.sweep() * second.sweep() < 0 || !is_same_heading(first.tangent_at(1), second.tangent_at(0)))
    return std::nullopt;
  const Edge whole =
      first.is_arc() ? edge_through(first.from, first.to, second.to) : Edge::line(first.from, second.to);
  if (whole.is_arc() != first.is_arc() || !is_same_heading(first.tangent_at(0), whole.tangent_at(0)) ||
      !is_same_heading(second.tangent_at(1), whole.tangent_at(1)))
    return std::nullopt;
  for (const Vec2 p : {first.at(0.5), first.to, second.at(0.5)}) {
    if (distance(whole, p) > tolerance) return std::nullopt;
  }
  return whole;
}

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

}  // namespace clearcut::plan::adaptive
