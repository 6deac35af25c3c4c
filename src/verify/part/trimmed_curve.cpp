#include "verify/part/trimmed_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/elementary.h"
#include "base/units.h"

namespace clearcut::verify {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// mm. Far above the rounding of distances.
constexpr double kDistanceRounding = 1e-9;

double length_of(Vec2 a) {
  return std::sqrt(norm_squared(a));
}

/// mm^2; from p to the straight line from a to b.
double squared_distance(Vec2 a, Vec2 b, Vec2 p) {
  const Vec2 along = b - a, off = p - a;
  const double whole = norm_squared(along);
  const double t = whole > 0 ? std::clamp(dot(off, along) / whole, 0.0, 1.0) : 0;
  return norm_squared(off - along * t);
}

/// Curves that together contain the outline of all points within d of an edge.
std::vector<Edge> outline_within(const Edge& edge, double d) {
  std::vector<Edge> out = circle(edge.from, d);
  for (const Edge& half : circle(edge.to, d)) out.push_back(half);
  for (const Edge& side : {edge, edge.reversed()}) {
    for (const Edge& curve : parallel(side, d, 0)) {
      if (curve.from != curve.to) out.push_back(curve);
    }
  }
  return out;
}

}  // namespace

std::vector<Edge> parallel(const Edge& edge, double d, double fit) {
  if (!edge.is_arc()) {
    const Vec2 aside = left_of(edge.to - edge.from) * (d / length_of(edge.to - edge.from));
    return {Edge::line(edge.from + aside, edge.to + aside)};
  }
  const double radius = edge.radius();
  const double shifted = edge.turn == Turn::kCounterClockwise ? radius - d : radius + d;
  if (shifted < -fit) return {};
  if (shifted <= fit) return {Edge::line(edge.center, edge.center)};
  const double k = shifted / radius;
  return {Edge::arc(edge.center + (edge.from - edge.center) * k, edge.center + (edge.to - edge.center) * k,
                    edge.center, edge.turn)};
}

std::vector<Edge> circle(Vec2 center, double radius) {
  const Vec2 a = center + Vec2{radius, 0}, b = center - Vec2{radius, 0};
  return {Edge::arc(a, b, center, Turn::kCounterClockwise), Edge::arc(b, a, center, Turn::kCounterClockwise)};
}

TrimmedCurve::TrimmedCurve(const Edge& curve) : curve_(curve) {
  if (curve.is_arc()) {
    sweep_ = curve.sweep();
    radius_ = curve.radius();
    length_ = std::abs(sweep_) * radius_;
    sagitta_ = length_ * std::abs(sweep_) / 8;
  } else {
    length_ = length_of(curve.to - curve.from);
  }
  find_middle();
}

Vec2 TrimmedCurve::at(double t) const {
  if (!curve_.is_arc()) return lerp(curve_.from, curve_.to, t);
  return curve_.center + rotated(curve_.from - curve_.center, sweep_ * t);
}

void TrimmedCurve::find_middle() {
  if (parts_.empty()) return;
  const double from = parts_.front().first, to = parts_.back().second;
  middle_ = at((from + to) / 2);
  half_ = length_ * (to - from) / 2;
}

/// Two straight lines that do not cross are nearest at an end of one of them. A chord that crosses the wall begins nearer to it than its
/// own length.
bool TrimmedCurve::stays_beyond(const Edge& wall, double d) const {
  if (wall.is_arc() || length_ >= d || std::abs(sweep_) > kPi / 2) return false;
  const double least = d + sagitta_ + kDistanceRounding, square = least * least;
  const Vec2 a = curve_.from, b = curve_.to;
  return squared_distance(wall.from, wall.to, a) > square &&
         squared_distance(wall.from, wall.to, b) > square && squared_distance(a, b, wall.from) > square &&
         squared_distance(a, b, wall.to) > square;
}

void TrimmedCurve::add_cuts(const Edge& wall, double d) {
  if (!curve_.is_arc() && !wall.is_arc()) return add_line_cuts(wall, d);
  if (!wall.is_arc()) return add_arc_cuts(wall, d);
  for (const Edge& limit : outline_within(wall, d)) {
    for (const Vec2 p : intersections(curve_, limit)) cuts_.push_back(nearest(curve_, p).t);
  }
}

/// A line meets the points within d of another line in one interval.
void TrimmedCurve::add_line_cuts(const Edge& wall, double d) {
  const Vec2 u = (curve_.to - curve_.from) / length_, v = wall.to - wall.from;
  const double wall_length = length_of(v);
  double low = kInfinite, high = -kInfinite;
  const auto add = [&](double from, double to) {
    low = std::min(low, from / length_);
    high = std::max(high, to / length_);
  };
  for (const Vec2 end : {wall.from, wall.to}) {
    const double along = dot(end - curve_.from, u), aside = cross(u, end - curve_.from);
    if (std::abs(aside) >= d) continue;
    const double half = std::sqrt((d - aside) * (d + aside));
    add(along - half, along + half);
  }
  // Places at which the line is at distance d beside the wall, on either side.
  const double across = cross(v, u) / wall_length, start = cross(v, curve_.from - wall.from) / wall_length;
  for (const double side : {d, -d}) {
    if (std::abs(across) < 1e-14) break;
    const double t = (side - start) / across;
    const double foot = dot(curve_.from + u * t - wall.from, v) / wall_length;
    if (foot >= 0 && foot <= wall_length) add(t, t);
  }
  cuts_.push_back(low);
  cuts_.push_back(high);
}

/// Adds the intersections of the arc with the circles about the wall's ends and the lines beside it. Half angles are
/// computed from their tangents, because on an arc of kilometres a cosine cannot resolve micrometres.
void TrimmedCurve::add_arc_cuts(const Edge& wall, double d) {
  const Vec2 start = curve_.from - curve_.center;
  // The two directions from the arc's centre at an angle to v, given by the squares of sine and cosine of half the
  // angle, up to a common factor.
  const auto add = [&](Vec2 v, double sine_squared, double cosine_squared) {
    if (sine_squared < 0 || cosine_squared < 0) return;
    const double middle = base::atan2(cross(start, v), dot(start, v));
    const double half = 2 * base::atan2(std::sqrt(sine_squared), std::sqrt(cosine_squared));
    for (const double angle : {middle - half, middle + half}) {
      const double turned = std::fmod(sweep_ > 0 ? angle : -angle, 2 * kPi);
      cuts_.push_back((turned < 0 ? turned + 2 * kPi : turned) / std::abs(sweep_));
    }
  };
  for (const Vec2 end : {wall.from, wall.to}) {
    const Vec2 v = end - curve_.center;
    const double apart = length_of(v);
    const double over = apart - radius_, sum = apart + radius_;
    if (apart > 0) add(v, (d - over) * (d + over), (sum - d) * (sum + d));
  }
  const Vec2 normal = left_of(wall.to - wall.from) / length_of(wall.to - wall.from);
  const double aside = dot(wall.from - curve_.center, normal);
  add(normal, radius_ - (aside + d), radius_ + (aside + d));
  add(normal, radius_ - (aside - d), radius_ + (aside - d));
}

}  // namespace clearcut::verify
