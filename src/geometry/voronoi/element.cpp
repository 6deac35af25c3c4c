#include "geometry/voronoi/element.h"

#include <algorithm>
#include <cmath>

namespace clearcut::inline geometry::voronoi {
namespace {

Vec2 left_normal(const Edge& line) {
  const Vec2 d = line.to - line.from;
  return left_of(d) / norm(d);
}

std::optional<Vec2> nearer(Vec2 p, Vec2 q, Vec2 guess) {
  return norm_squared(p - guess) <= norm_squared(q - guess) ? p : q;
}

std::optional<Vec2> line_meets_line(const OffsetCurve& a, const OffsetCurve& b) {
  const double det = cross(a.direction, b.direction);
  if (std::abs(det) < 1e-12) return std::nullopt;
  return a.point + a.direction * (cross(b.point - a.point, b.direction) / det);
}

std::optional<Vec2> line_meets_circle(const OffsetCurve& line, const OffsetCurve& circle, Vec2 guess,
                                      double slack) {
  const Vec2 foot = line.point + line.direction * dot(circle.point - line.point, line.direction);
  const double h = std::abs(cross(line.direction, circle.point - line.point));
  if (h > circle.radius + slack) return std::nullopt;
  const double half = std::sqrt(std::max(0.0, (circle.radius - h) * (circle.radius + h)));
  return nearer(foot - line.direction * half, foot + line.direction * half, guess);
}

std::optional<Vec2> circle_meets_circle(const OffsetCurve& a, const OffsetCurve& b, Vec2 guess,
                                        double slack) {
  const Vec2 between = b.point - a.point;
  const double d = norm(between);
  if (d < 1e-9 || d > a.radius + b.radius + slack || d < std::abs(a.radius - b.radius) - slack)
    return std::nullopt;
  const Vec2 u = between / d;
  const double x =
      std::clamp(0.5 * (d + (a.radius - b.radius) * (a.radius + b.radius) / d), -a.radius, a.radius);
  const double y = std::sqrt((a.radius - std::abs(x)) * (a.radius + std::abs(x)));
  const Vec2 middle = a.point + u * x, side = left_of(u) * y;
  return nearer(middle + side, middle - side, guess);
}

/// A common normal and the places of the bisector on it.
struct CommonNormal {
  Vec2 direction;
  std::optional<Critical> lowest, highest;
};

CommonNormal normal_of_line_and_round(const Element& line, const Element& round) {
  const Vec2 n = left_normal(line.edge), b = round.edge.center;
  const double height = dot(b - line.edge.from, n);
  CommonNormal normal{n, {}, {}};
  if (round.wall == Wall::kConcave) {
    const double s = (round.radius - height) / 2;
    if (s >= 0) normal.highest = {b + n * s, height + s};
  } else {
    const double c = (height - round.radius) / 2;
    normal.lowest = {b - n * (round.radius + c), c};
  }
  return normal;
}

CommonNormal normal_of_rounds(const Element& a, const Element& b) {
  if (a.wall != Wall::kConcave && b.wall == Wall::kConcave) return normal_of_rounds(b, a);
  const Vec2 between = b.edge.center - a.edge.center;
  const double d = norm(between);
  if (d < 1e-9) return {};
  const Vec2 u = between / d;
  CommonNormal normal{u, {}, {}};
  if (a.wall != Wall::kConcave) {
    const double c = (d - a.radius - b.radius) / 2;
    normal.lowest = {a.edge.center + u * (a.radius + c), c};
  } else if (b.wall != Wall::kConcave) {
    const double low = (a.radius - d - b.radius) / 2, behind = (a.radius - d + b.radius) / 2;
    normal.lowest = {b.edge.center + u * (b.radius + low), low};
    if (behind >= 0) normal.highest = {a.edge.center - u * behind, a.radius - behind};
  } else {
    const double x = (a.radius - b.radius + d) / 2;
    if (x >= 0 && x <= d) normal.highest = {a.edge.center + u * x, a.radius - x};
  }
  return normal;
}

CommonNormal common_normal(const Element& a, const Element& b) {
  if (!a.is_round()) return normal_of_line_and_round(a, b);
  if (!b.is_round()) return normal_of_line_and_round(b, a);
  return normal_of_rounds(a, b);
}

}  // namespace

Element Element::of_edge(const Edge& edge) {
  if (!edge.is_arc()) return {Wall::kLine, edge, 0, -1};
  return {edge.turn == Turn::kCounterClockwise ? Wall::kConcave : Wall::kConvex, edge, edge.radius(), -1};
}

Element Element::of_point(Vec2 p) {
  return {Wall::kPoint, {p, p, p, Turn::kStraight}, 0, -1};
}

double distance(const Element& element, Vec2 p) {
  return element.is_point() ? norm(p - element.edge.from) : clearcut::distance(element.edge, p);
}

Vec2 away_from(const Element& element, Vec2 p) {
  const Vec2 foot = element.is_point() ? element.edge.from : nearest_point(element.edge, p);
  const double d = norm(p - foot);
  return d > 0 ? (p - foot) / d : Vec2{};
}

OffsetCurve offset_curve(const Element& element, double d) {
  const Edge& edge = element.edge;
  switch (element.wall) {
    case Wall::kLine: {
      const Vec2 n = left_normal(edge);
      return {true, edge.from + n * d, -left_of(n), 0, Turn::kStraight};
    }
    case Wall::kConcave:
      return {false, edge.center, {}, element.radius - d, Turn::kCounterClockwise};
    default:
      return {false, edge.center, {}, element.radius + d, Turn::kClockwise};
  }
}

std::optional<Vec2> meeting_near(const OffsetCurve& a, const OffsetCurve& b, Vec2 guess, double slack) {
  if (a.straight && b.straight) return line_meets_line(a, b);
  if ((!a.straight && a.radius <= 0) || (!b.straight && b.radius <= 0)) return std::nullopt;
  if (a.straight) return line_meets_circle(a, b, guess, slack);
  if (b.straight) return line_meets_circle(b, a, guess, slack);
  return circle_meets_circle(a, b, guess, slack);
}

std::optional<Critical> critical_between(const Element& a, const Element& b, Vec2 p, Vec2 q) {
  if (!a.is_round() && !b.is_round()) return std::nullopt;
  const CommonNormal normal = common_normal(a, b);
  const Vec2 middle = lerp(p, q, 0.5);
  // The normal crosses the bisector of an island inside an arc twice: p and q are near one of the two.
  const bool both = normal.lowest && normal.highest;
  const bool near_lowest =
      both ? norm_squared(normal.lowest->point - middle) < norm_squared(normal.highest->point - middle)
           : normal.lowest.has_value();
  const std::optional<Critical>& place = near_lowest ? normal.lowest : normal.highest;
  if (!place || place->clearance <= 0) return std::nullopt;
  if (cross(normal.direction, p - place->point) * cross(normal.direction, q - place->point) >= 0)
    return std::nullopt;
  // Smoothly joined walls have their whole common normal for a bisector: the place of largest clearance may be beyond
  // q.
  const double along = dot(place->point - p, q - p);
  if (!near_lowest && (along <= 0 || along >= norm_squared(q - p))) return std::nullopt;
  return place;
}

}  // namespace clearcut::inline geometry::voronoi
