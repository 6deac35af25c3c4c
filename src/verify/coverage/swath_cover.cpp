#include "verify/coverage/swath_cover.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/elementary.h"
#include "base/error.h"
#include "base/tolerances.h"
#include "base/units.h"

namespace clearcut::verify {
namespace {

constexpr int kHullPoints = 48;

bool before(Vec2 a, Vec2 b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

}  // namespace

void ConvexPolygon::add(Vec2 p) {
  CLEARCUT_ASSERT(count_ < kCapacity);
  points_[count_++] = p;
}

ConvexPolygon ConvexPolygon::square(Vec2 center, double half) {
  ConvexPolygon polygon;
  polygon.add({center.x - half, center.y - half});
  polygon.add({center.x + half, center.y - half});
  polygon.add({center.x + half, center.y + half});
  polygon.add({center.x - half, center.y + half});
  return polygon;
}

/// Computed by the monotone chain.
ConvexPolygon ConvexPolygon::hull(std::span<Vec2> points) {
  std::sort(points.begin(), points.end(), before);
  const auto end = std::unique(points.begin(), points.end());
  const int n = static_cast<int>(end - points.begin());
  ConvexPolygon polygon;
  if (n <= 2) {
    for (int i = 0; i < n; ++i) polygon.add(points[i]);
    return polygon;
  }
  if (n > kHullPoints) {
    Box box;
    for (int i = 0; i < n; ++i) box.add(points[i]);
    for (const Vec2 p : {box.min, Vec2{box.max.x, box.min.y}, box.max, Vec2{box.min.x, box.max.y}})
      polygon.add(p);
    return polygon;
  }
  std::array<Vec2, 2 * kHullPoints> chain;
  int k = 0;
  const auto push = [&](Vec2 p, int keep) {
    while (k >= keep && cross(chain[k - 1] - chain[k - 2], p - chain[k - 2]) <= 0) --k;
    chain[k++] = p;
  };
  for (int i = 0; i < n; ++i) push(points[i], 2);
  const int lower = k + 1;
  for (int i = n - 2; i >= 0; --i) push(points[i], lower);
  for (int i = 0; i < k - 1; ++i) polygon.add(chain[i]);
  return polygon;
}

Vec2 ConvexPolygon::centroid() const {
  Vec2 sum;
  for (const Vec2 p : points()) sum = sum + p;
  return count_ ? sum / count_ : sum;
}

double ConvexPolygon::area() const {
  double twice = 0;
  for (int i = 1; i + 1 < count_; ++i) twice += cross(points_[i] - points_[0], points_[i + 1] - points_[0]);
  return twice / 2;
}

ConvexPolygon ConvexPolygon::clipped(Vec2 normal, double offset) const {
  ConvexPolygon out;
  if (count_ == 1 && dot(normal, points_[0]) >= offset) return *this;
  for (int i = 0; i < count_ && count_ > 1; ++i) {
    const Vec2 a = points_[i], b = points_[(i + 1) % count_];
    const double da = dot(normal, a) - offset, db = dot(normal, b) - offset;
    if (da >= 0) out.add(a);
    if ((da < 0) != (db < 0)) out.add(lerp(a, b, da / (da - db)));
  }
  return out;
}

double ConvexPolygon::farthest_from(Vec2 p) const {
  double most = 0;
  for (const Vec2 q : points()) most = std::max(most, norm_squared(q - p));
  return std::sqrt(most);
}

double ConvexPolygon::nearest_to(Vec2 p) const {
  double least = std::numeric_limits<double>::infinity();
  bool inside = count_ > 2;
  for (int i = 0; i < count_; ++i) {
    const Vec2 a = points_[i], d = points_[(i + 1) % count_] - a;
    inside = inside && cross(d, p - a) >= 0;
    const double length = norm_squared(d);
    const double t = length > 0 ? std::clamp(dot(p - a, d) / length, 0.0, 1.0) : 0;
    least = std::min(least, norm_squared(a + d * t - p));
  }
  return inside ? 0 : std::sqrt(least);
}

namespace {

constexpr double kNoSwath = std::numeric_limits<double>::infinity();

double sign_of(const Edge& arc) {
  return arc.turn == Turn::kCounterClockwise ? 1.0 : -1.0;
}

/// Whether all points are in the sector of an arc of at most half a turn.
bool in_sector(std::span<const Vec2> points, const Edge& arc) {
  const Vec2 from = arc.from - arc.center, to = arc.to - arc.center;
  const double sign = sign_of(arc);
  if (sign * cross(from, to) < 0)
    return false;  // more than half a turn, which does not occur in divided swaths
  return std::all_of(points.begin(), points.end(), [&](Vec2 p) {
    const Vec2 v = p - arc.center;
    return sign * cross(from, v) >= 0 && sign * cross(v, to) >= 0;
  });
}

double excess_over_arc(const ConvexPolygon& cell, const Edge& arc) {
  const double by_ends = std::min(cell.farthest_from(arc.from), cell.farthest_from(arc.to));
  if (!in_sector(cell.points(), arc)) return by_ends;
  const double r = arc.radius();
  const double by_ring = std::max(cell.farthest_from(arc.center) - r, r - cell.nearest_to(arc.center));
  return std::min(by_ends, by_ring);
}

/// Removes the strip beside a line from the cell, if the cell is beside the line and extends beyond only one side of
/// the strip.
ConvexPolygon rest_after_line(const ConvexPolygon& cell, const Edge& line, double radius) {
  const double length = std::sqrt(norm_squared(line.to - line.from));
  const Vec2 d = (line.to - line.from) / length, n = left_of(d);
  double low = kNoSwath, high = -kNoSwath;
  for (const Vec2 p : cell.points()) {
    const double along = dot(p - line.from, d), aside = dot(p - line.from, n);
    if (along < 0 || along > length) return cell;
    low = std::min(low, aside);
    high = std::max(high, aside);
  }
  const double offset = dot(line.from, n);
  if (low >= -radius) return cell.clipped(n, offset + radius);
  if (high <= radius) return cell.clipped(-n, -offset + radius);
  return cell;
}

/// The same for the ring beside an arc. The part outside the outer circle is cut off by a chord of it, the part
/// inside the inner circle by a tangent.
ConvexPolygon rest_after_arc(const ConvexPolygon& cell, const Edge& arc, double radius) {
  if (!in_sector(cell.points(), arc)) return cell;
  const double ring = arc.radius();
  const bool inner_left = cell.nearest_to(arc.center) < ring - radius;
  const bool outer_left = cell.farthest_from(arc.center) > ring + radius;
  if (inner_left == outer_left) return cell;
  const Vec2 toward = cell.centroid() - arc.center;
  const double distance = std::sqrt(norm_squared(toward));
  if (distance <= 0) return cell;
  const Vec2 u = toward / distance;
  if (inner_left) return cell.clipped(-u, -dot(u, arc.center) - (ring - radius));
  double cosine = 1;
  for (const Vec2 p : cell.points()) {
    const Vec2 v = p - arc.center;
    const double rho = std::sqrt(norm_squared(v));
    if (rho <= 0) return cell;
    cosine = std::min(cosine, dot(u, v) / rho);
  }
  return cell.clipped(u, dot(u, arc.center) + (ring + radius) * cosine);
}

double sagitta(const Edge& edge) {
  if (!edge.is_arc()) return 0;
  return edge.radius() * (1 - base::cos(std::min(std::abs(edge.sweep()) / 2, kPi)));
}

double distance_to_chord(const Edge& edge, Vec2 p) {
  return distance(Edge::line(edge.from, edge.to), p);
}

/// mm; greatest distance of the points of an arc of less than half a turn from the circle of another arc. The
/// greatest distance is at an end, or at the point nearest to or farthest from that circle's centre.
double deviation_from_circle(const Edge& arc, const Edge& circle) {
  const Vec2 between = arc.center - circle.center;
  const double apart = std::sqrt(norm_squared(between)), radius = arc.radius(), r = circle.radius();
  double most = std::max(std::abs(distance(arc.from, circle.center) - r),
                         std::abs(distance(arc.to, circle.center) - r));
  for (const double side : {radius, -radius}) {
    if (apart <= 0) continue;
    const Vec2 p = arc.center + between * (side / apart);
    if (!in_sector({&p, 1}, arc)) continue;
    most = std::max(most, std::abs(std::abs(apart + side) - r));
  }
  return most;
}

double deviation_from_arc(const Edge& curve, const Edge& path) {
  const std::array<Vec2, 3> points{curve.from, curve.at(0.5), curve.to};
  if (!in_sector(points, path)) return kNoSwath;
  if (curve.is_arc() && std::abs(curve.sweep()) < kPi &&
      distance(curve.center, path.center) < 0.5 * curve.radius()) {
    return deviation_from_circle(curve, path);
  }
  const double r = path.radius(), bow = sagitta(curve);
  const double far = std::max(distance(curve.from, path.center), distance(curve.to, path.center)) + bow;
  const double near = distance_to_chord(curve, path.center) - bow;
  // The curve leaves the sector by at most its own sagitta.
  return std::max(far - r, r - near) + bow;
}

}  // namespace

double excess_over(const ConvexPolygon& cell, const Swath& swath) {
  if (swath.path.is_arc()) return excess_over_arc(cell, swath.path) - swath.radius;
  // The distance to a line is convex, so it is greatest at a corner.
  double most = 0;
  for (const Vec2 p : cell.points()) most = std::max(most, distance(swath.path, p));
  return most - swath.radius;
}

ConvexPolygon rest_after(const ConvexPolygon& cell, const Swath& swath) {
  if (swath.path.from == swath.path.to) return cell;
  return swath.path.is_arc() ? rest_after_arc(cell, swath.path, swath.radius)
                             : rest_after_line(cell, swath.path, swath.radius);
}

double deviation_of(const Edge& curve, const Edge& path) {
  const double by_ends = std::max(distance(path, curve.from), distance(path, curve.to));
  if (!path.is_arc()) return by_ends + sagitta(curve);
  const double half = curve.from == curve.to ? 0 : curve.length() / 2;
  return std::min(deviation_from_arc(curve, path), distance(path, curve.at(0.5)) + half);
}

void append_extremes(const Edge& edge, const Box& square, std::vector<Vec2>& out) {
  std::vector<double> cuts{0, 1};
  const Vec2 a = square.min, c = square.max, b{c.x, a.y}, d{a.x, c.y};
  for (const Edge& side : {Edge::line(a, b), Edge::line(b, c), Edge::line(c, d), Edge::line(d, a)}) {
    for (const Vec2 p : intersections(edge, side)) cuts.push_back(nearest(edge, p).t);
  }
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    if (!square.contains(edge.at((cuts[i] + cuts[i + 1]) / 2))) continue;
    const Edge part = edge.part(cuts[i], cuts[i + 1]);
    out.push_back(part.from);
    out.push_back(part.to);
    if (!edge.is_arc() || part.from == part.to) continue;
    // Each half of the arc is inside the triangle of its ends and the intersection of the tangents there.
    for (const Edge& half : {part.part(0, 0.5), part.part(0.5, 1)}) {
      const double quarter = base::tan(half.sweep() / 4);
      if (half.from == half.to || std::abs(half.sweep()) > 2.5) continue;
      const Vec2 middle = half.at(0.5), chord = (half.from + half.to) / 2.0;
      out.push_back(half.from);
      // The intersection's height over the chord is the sagitta times 2 / (1 - tan^2(sweep / 4)).
      out.push_back(chord + (middle - chord) * (2 / (1 - quarter * quarter)));
    }
  }
}

namespace {}  // namespace

WallResidual::WallResidual(const CoverageQuestion& question) : question_(question) {
  if (question.part->greatest_draft_offset() > 0) {
    for (const Wall& wall : question.part->walls())
      if (wall.stands_at(question.z))
        greatest_draft_ = std::max(greatest_draft_, wall.draft_offset(question.z));
  }
  if (question.allowance <= 0) return;
  const Box near = box(*question.target).grown(question.allowance);
  for (const Wall& outline : question.part->outlines_beyond()) {
    if (outline.stands_at(question.z) && outline.edge.box().overlaps(near)) beyond_.push_back(outline);
  }
}

bool WallResidual::holds(Vec2 p) const {
  if (!may_be()) return false;
  bool found = false;
  const std::vector<Wall>& walls = question_.part->walls();
  question_.part->wall_tree().nearest(p, question_.allowance + greatest_draft_, [&](int i) {
    found = found || (walls[i].stands_at(question_.z) &&
                      distance(walls[i].edge, p) <
                          question_.allowance + question_.part->draft_offset(walls[i], question_.z, p));
    return false;
  });
  return found || std::any_of(beyond_.begin(), beyond_.end(), [&](const Wall& outline) {
           return distance(outline.edge, p) < question_.allowance;
         });
}

bool WallResidual::may_hold(Vec2 center, double reach) const {
  if (!may_be()) return false;
  const std::vector<Wall>& walls = question_.part->walls();
  bool found = false;
  question_.part->wall_tree().nearest(center, question_.allowance + greatest_draft_ + reach, [&](int i) {
    const double residual = question_.allowance + walls[i].draft_offset(question_.z);
    found = found || (walls[i].stands_at(question_.z) && distance(walls[i].edge, center) < residual + reach);
    return false;
  });
  return found || std::any_of(beyond_.begin(), beyond_.end(), [&](const Wall& outline) {
           return distance(outline.edge, center) < question_.allowance + reach;
         });
}

bool WallResidual::holds_on_one_wall(const ConvexPolygon& polygon, Vec2 center, double reach) const {
  const double greatest = question_.allowance + greatest_draft_;
  const std::vector<Wall>& walls = question_.part->walls();
  bool found = false;
  question_.part->wall_tree().nearest(center, greatest, [&](int i) {
    found = found || (walls[i].stands_at(question_.z) && wall_holds(walls[i], polygon, center, reach));
    return false;
  });
  return found || std::any_of(beyond_.begin(), beyond_.end(), [&](const Wall& outline) {
           return wall_holds(outline, polygon, center, reach);
         });
}

bool WallResidual::wall_holds(const Wall& wall, const ConvexPolygon& polygon, Vec2 center,
                              double reach) const {
  const double residual = question_.allowance + wall.draft_offset(question_.z);
  if (wall.edge.is_arc()) {
    if (distance(wall.edge, center) + reach > residual) return false;
  } else if (excess_over(polygon, {wall.edge, residual}) > kRoundingMm) {
    return false;
  }
  const std::vector<Edge> ends = wall.flat_ends(question_.z);
  return std::all_of(ends.begin(), ends.end(), [&](const Edge& end) {
    const Vec2 outward = left_of(end.tangent_at(0));
    return std::all_of(polygon.points().begin(), polygon.points().end(),
                       [&](Vec2 p) { return dot(p - end.from, outward) <= kRoundingMm; });
  });
}

}  // namespace clearcut::verify
