#include "verify/coverage/length_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

#include "base/elementary.h"
#include "base/units.h"
#include "geometry/box.h"

namespace clearcut::verify {
namespace {

/// Curves count as chords no farther from them than this share of the radius.
constexpr double kChordShare = 1e-3;
/// Errors of shares, in R^2: of the shares in the result, and of those by which points are chosen.
constexpr double kShareError = 0.01, kRoughError = 0.05;
/// A point is a candidate only with a share above this, in R^2, if its cell is not limited by other points.
constexpr double kLeastShare = 0.05;
/// Distance, in radii, of candidates along the boundary between its corners, and the greatest number of candidates.
constexpr double kCandidatePitch = 0.5;
constexpr std::size_t kMostCandidates = 1500;
/// Number of times that all chosen points are reconsidered.
constexpr int kRounds = 2;

/// Radii tried for circles of rings, in radii of the disc: the first, the ratio of successive ones, and their number.
constexpr double kFirstRing = 1.5, kWider = 1.2;
constexpr int kRingSizes = 24;
/// mm. Rings whose gain is less than that of others by this need no exact area.
constexpr double kSurelyLess = 1e-3;
/// Number of edges times candidates up to which points and rings are searched.
constexpr double kMostWork = 4e5;

using Polygon = std::vector<Vec2>;

/// Signed area of the triangle of `a`, `b` and the center of a disc, within the disc; both relative to the center.
double area_in_disc(Vec2 a, Vec2 b, double radius) {
  const double r2 = radius * radius, aa = norm_squared(a), bb = norm_squared(b);
  const auto sector = [&](Vec2 p, Vec2 q) { return 0.5 * r2 * base::atan2(cross(p, q), dot(p, q)); };
  if (aa <= r2 && bb <= r2) return 0.5 * cross(a, b);
  const Vec2 along = b - a;
  const double ll = norm_squared(along);
  if (ll == 0) return 0;
  const double middle = -dot(a, along) / ll, away = cross(a, along);
  const double rest = r2 * ll - away * away;
  if (rest <= 0) return sector(a, b);
  const double half = std::sqrt(rest) / ll;
  const double first = middle - half, last = middle + half;
  if (first >= 1 || last <= 0) return sector(a, b);
  const Vec2 in = first > 0 ? a + first * along : a, out = last < 1 ? a + last * along : b;
  double area = 0.5 * cross(in, out);
  if (first > 0) area += sector(a, in);
  if (last < 1) area += sector(out, b);
  return area;
}

/// The part of a polygon on the left of the line through `on` in direction `along`. Of a polygon that is not convex the
/// parts may be connected by edges run in both directions: its signed area is right.
Polygon cut_off(const Polygon& polygon, Vec2 on, Vec2 along) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double sa = cross(along, a - on), sb = cross(along, b - on);
    if (sa >= 0) result.push_back(a);
    if ((sa > 0 && sb < 0) || (sa < 0 && sb > 0)) result.push_back(lerp(a, b, sa / (sa - sb)));
  }
  return result;
}

/// Part of a polygon nearer to v than to w.
Polygon nearer(const Polygon& polygon, Vec2 v, Vec2 w) {
  const Vec2 to = w - v;
  return cut_off(polygon, lerp(v, w, 0.5), {-to.y, to.x});
}

/// The surroundings of a point of the area: the square of half side 2 R around it, and the area within it.
struct Surroundings {
  Vec2 at;
  Polygon cell;
  std::vector<Polygon> area;
};

/// Shares of points, each in the cell limited by the chosen ones.
class Shares {
 public:
  Shares(const Regions& area, double radius) : radius_(radius) {
    for (const Region& region : area) {
      outlines_.push_back(flattened(region.outer(), kChordShare * radius));
      for (const Loop& island : region.islands())
        outlines_.push_back(flattened(island, kChordShare * radius));
    }
    for (const Polygon& outline : outlines_) {
      Box box;
      for (const Vec2 p : outline) box.add(p);
      boxes_.push_back(box);
    }
    for (const Edge& edge : edges_of(area))
      if (edge.is_arc()) curves_ += edge.length();
  }

  /// The cells of points keep outside these.
  void set_rings(std::vector<LengthBoundRing> rings) { rings_ = std::move(rings); }

  /// mm2 of the area within a disc.
  double area_in(Vec2 center, double radius) const {
    double sum = 0;
    for (const Polygon& outline : outlines_)
      for (std::size_t i = 0; i < outline.size(); ++i)
        sum += area_in_disc(outline[i] - center, outline[(i + 1) % outline.size()] - center, radius);
    return std::max(0.0, sum);
  }

  /// mm; greatest distance of a place of the area.
  double farthest(Vec2 from) const {
    double most = 0;
    for (const Polygon& outline : outlines_)
      for (const Vec2 p : outline) most = std::max(most, distance(from, p));
    return most;
  }

  /// mm2; area between curves and their chords at most.
  double curve_error() const { return curves_ * kChordShare * radius_; }

  Surroundings surroundings_of(Vec2 v) const {
    const double half = 2 * radius_;
    const Box box{{v.x - half, v.y - half}, {v.x + half, v.y + half}};
    Surroundings here{v, {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}, {}};
    for (std::size_t i = 0; i < outlines_.size(); ++i) {
      if (!boxes_[i].overlaps(box)) continue;
      Polygon clipped = outlines_[i];
      for (std::size_t k = 0; k < 4 && !clipped.empty(); ++k)
        clipped = cut_off(clipped, here.cell[k], here.cell[(k + 1) % 4] - here.cell[k]);
      if (!clipped.empty()) here.area.push_back(std::move(clipped));
    }
    return here;
  }

  /// mm2; lower bound of the point's share, too small by at most `error` R^2.
  double share(Surroundings here, const std::vector<Vec2>& others, double error) const {
    for (const LengthBoundRing& ring : rings_) {
      const double from = ring.radius_mm + radius_, away = distance(here.at, ring.at);
      if (away <= from) return 0;
      if (away >= from + 2 * radius_) continue;
      const Vec2 to = unit(here.at - ring.at);
      const Vec2 on = ring.at + from * to;
      const Vec2 along{to.y, -to.x};
      here.cell = cut_off(here.cell, on, along);
      for (Polygon& polygon : here.area) polygon = cut_off(polygon, on, along);
    }
    for (const Vec2 w : others) {
      if (distance(here.at, w) >= 4 * radius_) continue;
      here.cell = nearer(here.cell, here.at, w);
      for (Polygon& polygon : here.area) polygon = nearer(polygon, here.at, w);
    }
    return least_outside(here, error * radius_ * radius_);
  }

 private:
  /// mm2 of a disc in the cell outside the area.
  double outside(const Surroundings& here, Vec2 center) const {
    double sum = 0;
    const auto add = [&](const Polygon& polygon, double sign) {
      for (std::size_t i = 0; i < polygon.size(); ++i)
        sum += sign * area_in_disc(polygon[i] - center, polygon[(i + 1) % polygon.size()] - center, radius_);
    };
    add(here.cell, 1);
    for (const Polygon& polygon : here.area) add(polygon, -1);
    return sum;
  }

  /// Least of outside() over all centers within the radius of the point. Branch and bound over squares of centers: a
  /// displacement by d changes the area by at most 2 R d.
  double least_outside(const Surroundings& here, double error) const {
    struct Square {
      double bound;
      Vec2 center;
      double half;
      bool operator<(const Square& other) const { return bound > other.bound; }
    };
    std::priority_queue<Square> squares;
    double best = std::numeric_limits<double>::infinity();
    const auto push = [&](Vec2 center, double half) {
      const double reach = half * std::numbers::sqrt2;
      const Vec2 to = center - here.at;
      const double away = norm(to);
      if (away - reach > radius_) return;
      const double value = outside(here, center);
      // The best value may be anywhere within the radius.
      if (away <= radius_) best = std::min(best, value);
      squares.push({value - 2 * radius_ * reach, center, half});
    };
    push(here.at, radius_);
    while (!squares.empty()) {
      const Square top = squares.top();
      // `best` may be infinite as long as no square's center is within the radius.
      if (top.bound > best - error || top.bound > best) break;
      squares.pop();
      const double half = 0.5 * top.half;
      for (const double x : {-half, half})
        for (const double y : {-half, half}) push(top.center + Vec2{x, y}, half);
      if (best <= error) return 0;
    }
    return std::max(0.0, squares.empty() ? best - error : std::min(best, squares.top().bound));
  }

  double radius_;
  std::vector<Polygon> outlines_;
  std::vector<Box> boxes_;
  std::vector<LengthBoundRing> rings_;
  double curves_ = 0;
};

/// Points of the boundary: its corners, then points between them.
std::vector<Vec2> boundary_points(const Regions& area, double pitch, std::size_t most) {
  std::vector<Vec2> points;
  double length = 0;
  for (const Edge& edge : edges_of(area)) {
    points.push_back(edge.at(0));
    length += edge.length();
  }
  if (points.size() >= most) {
    points.resize(most);
    return points;
  }
  const double step = std::max(pitch, length / static_cast<double>(most - points.size()));
  for (const Edge& edge : edges_of(area)) {
    const int parts = static_cast<int>(edge.length() / step) + 1;
    for (int i = 1; i < parts; ++i) points.push_back(edge.at(static_cast<double>(i) / parts));
  }
  return points;
}

/// Chooses points so that the sum of their shares is large.
class Choice {
 public:
  Choice(const Shares& shares, const std::vector<Vec2>& places, double radius)
      : shares_(shares), radius_(radius) {
    for (const Vec2 p : places) {
      Candidate candidate{shares_.surroundings_of(p), 0, false};
      candidate.share = shares_.share(candidate.here, {}, kRoughError);
      if (candidate.share > kLeastShare * radius * radius) candidates_.push_back(std::move(candidate));
    }
    std::stable_sort(candidates_.begin(), candidates_.end(),
                     [](const Candidate& a, const Candidate& b) { return a.share > b.share; });
    for (int round = 0; round < kRounds; ++round)
      for (Candidate& candidate : candidates_) reconsider(candidate);
  }

  std::vector<LengthBoundPoint> points() const {
    std::vector<LengthBoundPoint> points;
    for (const Candidate& one : candidates_) {
      if (!one.is_chosen) continue;
      const double share = shares_.share(one.here, chosen_near(one), kShareError);
      if (share > 0) points.push_back({one.here.at, share});
    }
    return points;
  }

 private:
  struct Candidate {
    Surroundings here;
    double share = 0;  ///< mm2; in its cell if chosen
    bool is_chosen = false;
  };

  std::vector<Vec2> chosen_near(const Candidate& of) const {
    std::vector<Vec2> near;
    for (const Candidate& one : candidates_)
      if (one.is_chosen && &one != &of && distance(one.here.at, of.here.at) < 4 * radius_)
        near.push_back(one.here.at);
    return near;
  }

  /// Chooses a point, or no longer, if all shares together become larger.
  void reconsider(Candidate& candidate) {
    std::vector<Candidate*> near;
    for (Candidate& one : candidates_)
      if (one.is_chosen && &one != &candidate && distance(one.here.at, candidate.here.at) < 4 * radius_)
        near.push_back(&one);
    const double own_before = candidate.is_chosen ? candidate.share : 0;
    candidate.is_chosen = !candidate.is_chosen;
    double gain = -own_before, own = 0;
    if (candidate.is_chosen) gain = own = shares_.share(candidate.here, chosen_near(candidate), kRoughError);
    std::vector<double> changed;
    for (const Candidate* one : near) {
      changed.push_back(shares_.share(one->here, chosen_near(*one), kRoughError));
      gain += changed.back() - one->share;
    }
    if (gain <= 0) {
      candidate.is_chosen = !candidate.is_chosen;
      return;
    }
    if (candidate.is_chosen) candidate.share = own;
    for (std::size_t i = 0; i < near.size(); ++i) near[i]->share = changed[i];
  }

  const Shares& shares_;
  double radius_;
  std::vector<Candidate> candidates_;
};

/// Subtracts the error of curves from the shares, from each alike.
void subtract_from(std::vector<LengthBoundPoint>& points, double error) {
  double sum = 0;
  for (const LengthBoundPoint& point : points) sum += point.mm2;
  if (sum <= error) points.clear();
  for (LengthBoundPoint& point : points) point.mm2 *= 1 - error / sum;
}

/// A ring, and how much longer it makes the bound, in mm.
struct RatedRing {
  LengthBoundRing ring;
  double gain = 0;
};

/// The best circle around a place that does not overlap those of the chosen rings. `points`: those chosen without rings,
/// whose shares are lost within the ring.
RatedRing best_ring(const Shares& shares, Vec2 at, const LengthBound& bound) {
  const double radius = bound.cutter_radius_mm;
  double room = std::numeric_limits<double>::infinity();
  for (const LengthBoundRing& ring : bound.rings)
    room = std::min(room, distance(at, ring.at) - ring.radius_mm);
  const double farthest = shares.farthest(at);
  RatedRing best;
  double area = 0;  // mm2; within the last circle computed, and in wider ones at least
  double size = kFirstRing * radius;
  for (int i = 0; i < kRingSizes; ++i, size *= kWider) {
    if (size > room) {
      size = room;
      i = kRingSizes;
    }
    const double reach = size + radius;
    if (farthest <= reach) break;
    if (2 * (size - radius) - area / (2 * radius) < best.gain - kSurelyLess) continue;
    area = shares.area_in(at, reach) + shares.curve_error();
    double lost = 0;
    for (const LengthBoundPoint& point : bound.points)
      if (distance(point.at, at) < reach + 0.5 * radius) lost += point.mm2;
    const double gain = 2 * (size - radius) - (area + lost) / (2 * radius);
    if (gain > best.gain) best = {{at, size, area}, gain};
  }
  return best;
}

/// Rings of narrow places, the best first, among those around the corners.
std::vector<LengthBoundRing> chosen_rings(const Shares& shares, const std::vector<Vec2>& corners,
                                          LengthBound bound) {
  std::vector<RatedRing> rated;
  for (const Vec2 p : corners)
    if (RatedRing one = best_ring(shares, p, bound); one.gain > 0) rated.push_back(one);
  while (!rated.empty()) {
    const auto best = std::max_element(
        rated.begin(), rated.end(), [](const RatedRing& a, const RatedRing& b) { return a.gain < b.gain; });
    const LengthBoundRing chosen = best->ring;
    bound.rings.push_back(chosen);
    std::erase_if(bound.points, [&](const LengthBoundPoint& point) {
      return distance(point.at, chosen.at) < chosen.radius_mm + 1.5 * bound.cutter_radius_mm;
    });
    for (RatedRing& one : rated)
      if (distance(one.ring.at, chosen.at) < one.ring.radius_mm + chosen.radius_mm)
        one = best_ring(shares, one.ring.at, bound);
    std::erase_if(rated, [](const RatedRing& one) { return one.gain <= 0; });
  }
  return bound.rings;
}

}  // namespace

double added_up(const LengthBound& bound) {
  const double radius = bound.cutter_radius_mm, disc = kPi * radius * radius;
  if (radius <= 0) return 0;
  double swept = bound.area_mm2, rings = 0, widest = 0, second = 0;
  for (const LengthBoundPoint& point : bound.points) swept += point.mm2;
  if (bound.rings.empty()) {
    if (!bound.closed) return std::max(0.0, (swept - bound.paths * disc) / (2 * radius));
    if (swept >= 4 * disc) return swept / (2 * radius);
    return std::max(0.0, 2 * kPi * (std::sqrt(std::max(0.0, swept) / kPi) - radius));
  }
  for (const LengthBoundRing& ring : bound.rings) {
    swept -= ring.mm2;
    const double width = ring.radius_mm - radius;
    rings += 2 * width;
    second = std::max(second, std::min(width, widest));
    widest = std::max(widest, width);
  }
  const double rest = std::max(0.0, swept) / (2 * radius);
  if (bound.closed) return rings + rest;
  // The first disc leaves out no more than there is.
  return std::max(0.0, rings - widest + rest - std::max(second, std::min(rest, disc / (2 * radius))));
}

LengthBound length_bound(const LengthBoundQuestion& question) {
  LengthBound bound;
  bound.cutter_radius_mm = question.radius;
  bound.paths = question.paths;
  bound.closed = question.closed;
  bound.area_mm2 = std::max(0.0, geometry::area(question.area) - question.left_out_mm2);
  const double edges = static_cast<double>(edges_of(question.area).size());
  if (question.left_out_mm2 == 0 && question.radius > 0 && edges > 0 && edges * edges < kMostWork) {
    const auto most = std::min(kMostCandidates, static_cast<std::size_t>(kMostWork / edges));
    const std::vector<Vec2> places = boundary_points(question.area, kCandidatePitch * question.radius, most);
    Shares shares(question.area, question.radius);
    bound.points = Choice(shares, places, question.radius).points();
    subtract_from(bound.points, shares.curve_error());
    bound.mm = added_up(bound);
    if (question.paths == 1) {
      LengthBound with = bound;
      const auto corners = std::min(places.size(), static_cast<std::size_t>(edges));
      with.rings = chosen_rings(
          shares, {places.begin(), places.begin() + static_cast<std::ptrdiff_t>(corners)}, bound);
      shares.set_rings(with.rings);
      if (!with.rings.empty()) {
        with.points = Choice(shares, places, question.radius).points();
        subtract_from(with.points, shares.curve_error());
        with.mm = added_up(with);
        if (with.mm > bound.mm) bound = std::move(with);
      }
    }
  }
  bound.mm = added_up(bound);
  return bound;
}

}  // namespace clearcut::verify
