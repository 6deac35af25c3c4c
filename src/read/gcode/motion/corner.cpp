#include "read/gcode/motion/corner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "base/tolerances.h"

namespace clearcut::read::gcode {
namespace {

/// mm. Arcs whose radii differ within what controls allow have their tangent points beside themselves by this much.
constexpr double kBesideArc = 2e-3;

/// A line, or a circle where `radius` > 0, on which the centre of a rounding lies.
struct Locus {
  Vec2 place;  ///< on the line, or the circle's centre
  Vec2 along;  ///< of the line
  double radius = 0;
};

double turn_sign(const Edge& edge) {
  return edge.turn == Turn::kCounterClockwise ? 1 : edge.turn == Turn::kClockwise ? -1 : 0;
}

/// All places `offset` mm to the left of the edge, as far as it may be prolonged; nothing where an arc is smaller than that.
std::optional<Locus> beside(const Edge& edge, double offset) {
  if (!edge.is_arc()) {
    const Vec2 along = edge.tangent_at(0);
    return Locus{edge.from + left_of(along) * offset, along, 0};
  }
  const double radius = edge.radius() - turn_sign(edge) * offset;
  if (!(radius > kSamePlaceMm)) return std::nullopt;
  return Locus{edge.center, {}, radius};
}

std::vector<Vec2> line_meets_line(const Locus& a, const Locus& b) {
  const double across = cross(a.along, b.along);
  if (std::abs(across) <= kSameAngleRad) return {};
  return {a.place + a.along * (cross(b.place - a.place, b.along) / across)};
}

std::vector<Vec2> line_meets_circle(const Locus& line, const Locus& circle) {
  const double middle = dot(circle.place - line.place, line.along);
  const Vec2 foot = line.place + line.along * middle;
  const double squared = circle.radius * circle.radius - norm_squared(foot - circle.place);
  if (squared < 0) return {};
  const double half = std::sqrt(squared);
  return {foot - line.along * half, foot + line.along * half};
}

std::vector<Vec2> circle_meets_circle(const Locus& a, const Locus& b) {
  const Vec2 way = b.place - a.place;
  const double apart = norm(way);
  if (!(apart > kSamePlaceMm)) return {};
  const double middle = (apart * apart + a.radius * a.radius - b.radius * b.radius) / (2 * apart);
  const double squared = a.radius * a.radius - middle * middle;
  if (squared < 0) return {};
  const Vec2 along = way / apart, foot = a.place + along * middle;
  const Vec2 aside = left_of(along) * std::sqrt(squared);
  return {foot - aside, foot + aside};
}

std::vector<Vec2> meetings_of(const Locus& a, const Locus& b) {
  if (a.radius == 0 && b.radius == 0) return line_meets_line(a, b);
  if (a.radius == 0) return line_meets_circle(a, b);
  if (b.radius == 0) return line_meets_circle(b, a);
  return circle_meets_circle(a, b);
}

/// Where a circle about `center` touches the edge, prolonged where it is a line; nothing beside an arc's own sweep or beyond a line's ends.
std::optional<Vec2> touching(const Edge& edge, Vec2 center) {
  Vec2 place;
  if (edge.is_arc()) {
    const Vec2 arm = center - edge.center;
    if (!(norm(arm) > kSamePlaceMm)) return std::nullopt;
    place = edge.center + arm * (edge.radius() / norm(arm));
  } else {
    const Vec2 along = edge.tangent_at(0);
    place = edge.from + along * dot(center - edge.from, along);
  }
  if (distance(edge, place) > (edge.is_arc() ? kBesideArc : kSamePlaceMm)) return std::nullopt;
  return place;
}

std::optional<Edge> between(const Edge& like, Vec2 from, Vec2 to) {
  if (distance(from, to) <= kSamePlaceMm) return std::nullopt;
  Edge part = like;
  part.from = from;
  part.to = to;
  return part;
}

std::optional<JoinedCorner> rounded(const Edge& before, const Edge& after, double radius, double side) {
  const auto first = beside(before, side * radius), second = beside(after, side * radius);
  if (!first || !second) return std::nullopt;
  std::optional<JoinedCorner> found;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vec2 center : meetings_of(*first, *second)) {
    const auto begin = touching(before, center), end = touching(after, center);
    if (!begin || !end || distance(*begin, *end) <= kSamePlaceMm) continue;
    const double away = distance(center, before.to);
    if (away >= nearest) continue;
    nearest = away;
    found =
        JoinedCorner{between(before, before.from, *begin), between(after, *end, after.to),
                     Edge::arc(*begin, *end, center, side > 0 ? Turn::kCounterClockwise : Turn::kClockwise)};
  }
  return found;
}

std::optional<JoinedCorner> chamfered(const Edge& before, const Edge& after, double off) {
  if (before.is_arc() || after.is_arc()) return std::nullopt;
  if (off > before.length() + kSamePlaceMm || off > after.length() + kSamePlaceMm) return std::nullopt;
  const Vec2 begin = before.to - before.tangent_at(1) * off, end = after.from + after.tangent_at(0) * off;
  return JoinedCorner{between(before, before.from, begin), between(after, end, after.to),
                      Edge::line(begin, end)};
}

}  // namespace

std::optional<JoinedCorner> joined_corner(const Edge& before, const Edge& after, const Corner& corner) {
  const Vec2 in = before.tangent_at(1), out = after.tangent_at(0);
  const double across = cross(in, out);
  if (std::abs(across) <= kSameAngleRad) return std::nullopt;
  switch (corner.kind) {
    case CornerKind::kRounding:
      return rounded(before, after, corner.size, across > 0 ? 1 : -1);
    case CornerKind::kChamfer:
      return chamfered(before, after, corner.size);
    case CornerKind::kChamferLength:
      // Twice what is taken off each, times the cosine of half the angle by which the way turns.
      return chamfered(before, after, corner.size / (2 * std::sqrt((1 + dot(in, out)) / 2)));
  }
  return std::nullopt;
}

}  // namespace clearcut::read::gcode
