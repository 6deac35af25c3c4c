#include "geometry/edge.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/tolerances.h"
#include "base/units.h"

namespace clearcut::inline geometry {
namespace {

/// Rounding of places on an arc, per mm of its radius: counts on arcs of a kilometre and more.
constexpr double kTouchPerRadius = 1e-15;
/// Below this bulge the sagitta is under the rounding of the centre: a line is the more exact curve.
constexpr double kStraightBulge = 1e-8;
/// Newton rounds after which a crossing of circles is as exact as doubles allow.
constexpr int kRounds = 4;
/// Share of the distance at which edges meet: shorter steps towards a crossing change nothing.
constexpr double kConverged = 1e-3;
/// Edges meet at places within the touching distance of both: farther apart than twice this distance they do not meet. The
/// rest is for rounding.
constexpr double kSurelyApart = 4;

/// Radius of the circle through the middle between the two ends' radii, by one square root.
double circle_radius(const Edge& arc) {
  return std::sqrt(0.5 * (norm_squared(arc.from - arc.center) + norm_squared(arc.to - arc.center)));
}

/// Whether the ray from the centre along v meets the arc; no trigonometry. True for v = 0.
bool in_wedge(const Edge& arc, Vec2 v) {
  const bool ccw = arc.turn == Turn::kCounterClockwise;
  const Vec2 start = (ccw ? arc.from : arc.to) - arc.center;
  const Vec2 end = (ccw ? arc.to : arc.from) - arc.center;
  const bool after_start = cross(start, v) >= 0;
  const bool before_end = cross(v, end) >= 0;
  // end - start straight from the ends: exact for short arcs, whose cross product would drown in rounding.
  const Vec2 chord = ccw ? arc.to - arc.from : arc.from - arc.to;
  if (cross(start, chord) < 0) return after_start || before_end;
  // A short sweep: the two half-planes of nearly parallel ends also meet on the far side of the centre.
  return after_start && before_end && (dot(start, end) <= 0 || dot(start, v) >= 0);
}

double sweep_of(const Edge& arc) {
  const Vec2 u = arc.from - arc.center;
  const double sine = cross(u, arc.to - arc.from);
  const double angle = base::atan2(sine, dot(u, arc.to - arc.center));
  if (arc.turn == Turn::kCounterClockwise) return angle >= 0 ? angle : angle + 2 * kPi;
  return angle <= 0 ? angle : angle - 2 * kPi;
}

/// Signed angle from the arc's start to direction v, in the arc's own sense, in [0, 2 pi).
double angle_from_start(const Edge& arc, Vec2 v) {
  const Vec2 u = arc.from - arc.center;
  const double sign = arc.turn == Turn::kCounterClockwise ? 1.0 : -1.0;
  const double angle = sign * base::atan2(cross(u, v - u), dot(u, v));
  return angle >= 0 ? angle : angle + 2 * kPi;
}

/// Point of the arc's circle at `angle` (signed) past its start; relative to the start, so that huge radii
/// lose nothing near it.
Vec2 turned_point(const Edge& arc, double angle) {
  const Vec2 u = arc.from - arc.center;
  const double s = base::sin(angle / 2), c = base::cos(angle / 2);
  return arc.from + u * (-2 * s * s) + left_of(u) * (2 * s * c);
}

Nearest nearest_on_line(const Edge& line, Vec2 p) {
  const Vec2 d = line.to - line.from;
  const double t = std::clamp(dot(p - line.from, d) / norm_squared(d), 0.0, 1.0);
  const Vec2 q = t == 1.0 ? line.to : line.from + d * t;
  return {q, norm(p - q), t};
}

Nearest nearer_end(const Edge& edge, Vec2 p) {
  const double d0 = norm_squared(p - edge.from), d1 = norm_squared(p - edge.to);
  return d0 <= d1 ? Nearest{edge.from, std::sqrt(d0), 0.0} : Nearest{edge.to, std::sqrt(d1), 1.0};
}

/// mm. Distance below which two edges meet.
double touch_of(const Edge& a, const Edge& b) {
  double touch = kRoundingMm;
  for (const Edge* edge : {&a, &b}) {
    if (edge->is_arc()) touch = std::max(touch, kTouchPerRadius * norm(edge->from - edge->center));
  }
  return touch;
}

/// Distance (mm) beyond the whole circle or line of an edge, and the direction in which this distance grows.
struct Beyond {
  double distance = 0;
  Vec2 outward;
};
Beyond beyond(const Edge& edge, Vec2 p) {
  if (!edge.is_arc()) {
    const Vec2 normal = left_of(unit(edge.to - edge.from));
    return {dot(p - edge.from, normal), normal};
  }
  const Vec2 v = p - edge.center;
  return {norm(v) - circle_radius(edge), unit(v)};
}

/// Newton's step from a crossing towards one that is nearer to both whole curves.
Vec2 step_to_both(Vec2 p, const Edge& a, const Edge& b) {
  const Beyond from_a = beyond(a, p), from_b = beyond(b, p);
  const double det = cross(from_a.outward, from_b.outward);
  if (det == 0) return {0, 0};
  return (left_of(from_b.outward) * from_a.distance - left_of(from_a.outward) * from_b.distance) / det;
}

/// The candidate, moved onto both edges exactly: formulas of circles lose digits if a circle is huge or both edges
/// cross at a small angle.
std::optional<Vec2> place_on_both(Vec2 p, const Edge& a, const Edge& b, double touch) {
  for (int round = 0; round < kRounds; ++round) {
    if (distance(a, p) <= touch && distance(b, p) <= touch) return p;
    if (!a.is_arc() && !b.is_arc()) break;
    const Vec2 step = step_to_both(p, a, b);
    // The place is on both whole curves already, beyond an end of one of the edges.
    if (norm_squared(step) <= kConverged * kConverged * touch * touch) break;
    p = p + step;
  }
  return std::nullopt;
}

void line_line_candidates(const Edge& a, const Edge& b, std::vector<Vec2>& out) {
  const Vec2 u = a.to - a.from, v = b.to - b.from;
  const double det = cross(u, v);
  if (std::abs(det) <= 1e-14 * norm(u) * norm(v)) return;
  out.push_back(a.from + u * (cross(b.from - a.from, v) / det));
}

void line_circle_candidates(const Edge& line, const Edge& arc, std::vector<Vec2>& out) {
  const Vec2 u = unit(line.to - line.from);
  const Vec2 foot = line.from + u * dot(arc.center - line.from, u);
  const double h = cross(u, arc.center - line.from), r = circle_radius(arc);
  if (std::abs(std::abs(h) - r) <= kRoundingMm) return out.push_back(foot);
  if (std::abs(h) > r) return;
  const double half = std::sqrt((r - std::abs(h)) * (r + std::abs(h)));
  out.push_back(foot - u * half);
  out.push_back(foot + u * half);
}

void circle_circle_candidates(const Edge& a, const Edge& b, std::vector<Vec2>& out) {
  const double ra = circle_radius(a), rb = circle_radius(b);
  // Seen from the smaller circle, of whose radius the distances do not lose digits.
  if (ra > rb) return circle_circle_candidates(b, a, out);
  const Vec2 between = b.center - a.center;
  const double d = norm(between);
  if (d <= kRoundingMm) return;
  const Vec2 u = between / d;
  // Difference of squares factored: radii may be huge against their difference.
  const double x = 0.5 * (d + (ra - rb) * (ra + rb) / d);
  const double gap = std::min(std::abs(d - ra - rb), std::abs(d - std::abs(ra - rb)));
  if (gap <= kRoundingMm) return out.push_back(a.center + u * (x < 0 ? -ra : ra));
  if (std::abs(x) > ra) return;
  const double y = std::sqrt((ra - std::abs(x)) * (ra + std::abs(x)));
  out.push_back(a.center + u * x + left_of(u) * y);
  out.push_back(a.center + u * x - left_of(u) * y);
}

std::vector<Vec2> crossing_candidates(const Edge& a, const Edge& b) {
  std::vector<Vec2> out;
  if (!a.is_arc() && !b.is_arc()) {
    line_line_candidates(a, b, out);
  } else if (!a.is_arc()) {
    line_circle_candidates(a, b, out);
  } else if (!b.is_arc()) {
    line_circle_candidates(b, a, out);
  } else {
    circle_circle_candidates(a, b, out);
  }
  return out;
}

/// Whether all of `other` certainly lies on one side of a straight edge's line, too far from it to meet the edge: an edge in
/// a scan of many is told apart by a few products, without looking for the places at which both meet.
bool is_beside(const Edge& line, const Edge& other) {
  const double touch = kSurelyApart * touch_of(line, other);
  const Vec2 d = line.to - line.from;
  const double length_squared = norm_squared(d);
  if (other.is_arc()) {
    const double across = cross(d, other.center - line.from), reach = circle_radius(other) + touch;
    return across * across > reach * reach * length_squared;
  }
  const double first = cross(d, other.from - line.from), last = cross(d, other.to - line.from);
  const double least = touch * touch * length_squared;
  return (first > 0) == (last > 0) && first * first > least && last * last > least;
}

bool surely_apart(const Edge& a, const Edge& b) {
  return (!a.is_arc() && is_beside(a, b)) || (!b.is_arc() && is_beside(b, a));
}

/// Two meeting places are one when the edges stay together between them.
bool same_contact(Vec2 p, Vec2 q, const Edge& a, const Edge& b, double touch) {
  if (norm_squared(p - q) <= 4 * touch * touch) return true;
  return distance(b, nearest_point(a, (p + q) / 2.0)) <= 2 * touch;
}

}  // namespace

Edge Edge::from_bulge(Vec2 from, Vec2 to, double bulge) {
  if (std::abs(bulge) < kStraightBulge) return line(from, to);
  const Vec2 chord = to - from;
  const Vec2 center = lerp(from, to, 0.5) + left_of(chord) * ((1 - bulge) * (1 + bulge) / (4 * bulge));
  return arc(from, to, center, bulge > 0 ? Turn::kCounterClockwise : Turn::kClockwise);
}

double Edge::radius() const {
  return 0.5 * (norm(from - center) + norm(to - center));
}

double Edge::sweep() const {
  return is_arc() ? sweep_of(*this) : 0.0;
}

double Edge::length() const {
  return is_arc() ? std::abs(sweep()) * radius() : norm(to - from);
}

double Edge::bulge() const {
  return base::tan(sweep() / 4);
}

Vec2 Edge::at(double t) const {
  if (t <= 0) return from;
  if (t >= 1) return to;
  if (!is_arc()) return lerp(from, to, t);
  return turned_point(*this, t * sweep());
}

Vec2 Edge::tangent_at(double t) const {
  if (!is_arc()) return unit(to - from);
  const Vec2 radial = t >= 1   ? unit(to - center)
                      : t <= 0 ? unit(from - center)
                               : rotated(unit(from - center), t * sweep());
  return turn == Turn::kCounterClockwise ? left_of(radial) : -left_of(radial);
}

Edge Edge::reversed() const {
  return {to, from, center, static_cast<Turn>(-static_cast<int>(turn))};
}

Edge Edge::part(double t0, double t1) const {
  return {at(t0), at(t1), center, turn};
}

Box Edge::box() const {
  Box box;
  box.add(from);
  box.add(to);
  if (!is_arc()) return box;
  const double r = radius();
  for (const Vec2 axis : {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}}) {
    if (in_wedge(*this, axis)) box.add(center + axis * r);
  }
  return box;
}

double Edge::signed_area() const {
  const double triangle = 0.5 * cross(from, to);
  if (!is_arc()) return triangle;
  const double s = sweep(), s2 = s * s;
  // s - sin(s) by its series if the difference would cancel.
  const double bow = std::abs(s) < 0.1 ? s * s2 / 6 * (1 - s2 / 20 * (1 - s2 / 42)) : s - base::sin(s);
  const double r = radius();
  return triangle + 0.5 * r * r * bow;
}

Nearest nearest(const Edge& edge, Vec2 p) {
  if (!edge.is_arc()) return nearest_on_line(edge, p);
  const Vec2 v = p - edge.center;
  if (!in_wedge(edge, v)) return nearer_end(edge, p);
  const double d = norm(v), r = circle_radius(edge);
  if (d == 0) return {edge.from, r, 0.0};
  const double t = angle_from_start(edge, v) / std::abs(sweep_of(edge));
  // A direction exactly at the start may be computed as just short of a full turn.
  if (!(t <= 1)) return nearer_end(edge, p);
  return {edge.center + v * (r / d), std::abs(d - r), t};
}

Vec2 nearest_point(const Edge& edge, Vec2 p) {
  if (!edge.is_arc()) return nearest_on_line(edge, p).point;
  const Vec2 v = p - edge.center;
  if (!in_wedge(edge, v)) return nearer_end(edge, p).point;
  const double d = norm(v);
  return d == 0 ? edge.from : edge.center + v * (circle_radius(edge) / d);
}

double distance(const Edge& edge, Vec2 p) {
  if (!edge.is_arc()) {
    const Vec2 d = edge.to - edge.from, w = p - edge.from;
    const double along = dot(w, d), length_squared = norm_squared(d);
    if (along <= 0) return norm(w);
    if (along >= length_squared) return norm(p - edge.to);
    return std::abs(cross(d, w)) / std::sqrt(length_squared);
  }
  const Vec2 v = p - edge.center;
  if (in_wedge(edge, v)) return std::abs(norm(v) - circle_radius(edge));
  return std::sqrt(std::min(norm_squared(p - edge.from), norm_squared(p - edge.to)));
}

double distance(const Edge& a, const Edge& b) {
  if (!surely_apart(a, b) && !intersections(a, b).empty()) return 0;
  double best = std::min({distance(b, a.from), distance(b, a.to), distance(a, b.from), distance(a, b.to)});
  // Beyond the ends, only places on a common normal through the centres can be nearest.
  const auto try_normal = [&best](const Edge& arc, const Edge& other, Vec2 through) {
    const Vec2 v = through - arc.center;
    const double d = norm(v);
    if (d == 0) return;
    for (const double side : {1.0, -1.0}) {
      if (!in_wedge(arc, v * side)) continue;
      best = std::min(best, distance(other, arc.center + v * (side * circle_radius(arc) / d)));
    }
  };
  if (a.is_arc()) try_normal(a, b, b.is_arc() ? b.center : nearest_point(b, a.center));
  if (b.is_arc()) try_normal(b, a, a.is_arc() ? a.center : nearest_point(a, b.center));
  return best;
}

std::vector<Vec2> intersections(const Edge& a, const Edge& b) {
  const double touch = touch_of(a, b);
  std::vector<Vec2> found;
  const auto add = [&](Vec2 p, bool merge_contacts) {
    for (const Vec2 q : found) {
      if (distance(p, q) <= 2 * touch || (merge_contacts && same_contact(p, q, a, b, touch))) return;
    }
    found.push_back(p);
  };
  // Ends first, so that a shared vertex is returned bitwise and a shared stretch gives its ends.
  for (const Vec2 end : {a.from, a.to}) {
    if (distance(b, end) <= touch) add(end, false);
  }
  for (const Vec2 end : {b.from, b.to}) {
    if (distance(a, end) <= touch) add(end, false);
  }
  std::vector<Vec2> crossings;
  for (const Vec2 p : crossing_candidates(a, b)) {
    if (const auto place = place_on_both(p, a, b, touch)) crossings.push_back(*place);
  }
  for (const Vec2 p : crossings) add(p, true);
  return found;
}

void append_flattened(const Edge& edge, double chord, std::vector<Vec2>& out) {
  if (edge.is_arc()) {
    const double sweep = edge.sweep(), r = edge.radius();
    // 2 acos((r - e) / r) = 4 asin(sqrt(e / 2r)), without the cancellation; never over a quarter turn.
    const double step = std::min(4 * base::asin(std::sqrt(std::min(chord / (2 * r), 0.5))), kPi / 2);
    const int chords = static_cast<int>(std::ceil(std::abs(sweep) / step - 1e-9));
    for (int i = 1; i < chords; ++i) out.push_back(turned_point(edge, sweep * i / chords));
  }
  out.push_back(edge.to);
}

double length(const Path& path) {
  double sum = 0;
  for (const Edge& edge : path) sum += edge.length();
  return sum;
}

Path reversed(const Path& path) {
  Path out;
  out.reserve(path.size());
  for (auto edge = path.rbegin(); edge != path.rend(); ++edge) out.push_back(edge->reversed());
  return out;
}

Path beginning(const Path& path, double mm) {
  Path first;
  for (const Edge& edge : path) {
    const double own = edge.length();
    if (own >= mm) {
      if (mm > kSamePlaceMm) first.push_back(own - mm > kSamePlaceMm ? edge.part(0, mm / own) : edge);
      break;
    }
    first.push_back(edge);
    mm -= own;
  }
  return first;
}

Box box(const Path& path) {
  Box all;
  for (const Edge& edge : path) all.add(edge.box());
  return all;
}

namespace {

/// 1 - cosine of the largest change of direction between lines that are drawn as one (0.001 degree).
constexpr double kCollinear = 1.5e-10;

}  // namespace

Path line_path(std::span<const Vec2> points) {
  Path path;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i] == points[i - 1]) continue;
    const Edge edge = Edge::line(points[i - 1], points[i]);
    if (!path.empty() && dot(path.back().tangent_at(1), edge.tangent_at(0)) > 1 - kCollinear) {
      path.back().to = edge.to;
    } else {
      path.push_back(edge);
    }
  }
  return path;
}

}  // namespace clearcut::inline geometry
