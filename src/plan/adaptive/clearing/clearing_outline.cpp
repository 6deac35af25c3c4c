#include "plan/adaptive/clearing/clearing_outline.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "geometry/route/legal_area.h"
#include "plan/adaptive/clearing/arcs.h"
#include "plan/adaptive/clearing/parameters.h"

namespace clearcut::plan::adaptive {
namespace {

/// Share of the widest cut that a wall pass can take within the limit; so much is left to it. Below 1,
/// because the engagement grows where a wall turns inwards.
constexpr double kWallShare = 0.62;
/// Radians. Where a wall turns inwards by more than this it has a corner.
constexpr double kCornerTurn = 0.1;
/// The distance from the wall may change along it by at most kTaperShare of the slope at which a wall pass
/// would meet the limit, and by at most kSteepestTaper.
constexpr double kTaperShare = 0.9;
constexpr double kSteepestTaper = 0.4;
/// A place must be this many times as wide as the distance that is kept from its walls.
constexpr double kLeastWidth = 7;
/// Number of bisections for the distance from the walls in a narrow place. Distances below kLeastAside tool
/// radii are set to zero.
constexpr int kHalvings = 16;
constexpr double kLeastAside = 0.25;
/// Shares of the tool radius: distance between the points of the outline, and on arcs round obstacles.
constexpr double kPitch = 0.1;
constexpr double kClosePitch = 0.02;
/// mm: distance of the outline's arcs from its points; below any gouge that counts.
constexpr double kTolerance = 3e-4;
/// Least number of points on an arc, so that fitting finds the arc again.
constexpr int kLeastParts = 6;
/// The same on a line: an arc through the ends alone of many short lines would run beyond their middles.
constexpr int kLeastPartsOfLine = 2;
/// Points times edges. Beyond this the search for narrow places takes too long, and everything is cleared up
/// to the walls.
constexpr double kMostWork = 3e7;

class FrontOutline {
 public:
  FrontOutline(const Region& legal, double tool_radius, double limit)
      : area_({legal}), radius_(tool_radius), limit_(limit) {
    const double wall_engagement = base::acos(1 - kWallShare * (1 - base::cos(limit)));
    taper_ = std::min(kSteepestTaper, kTaperShare * base::tan(limit - wall_engagement));
  }

  Loop around(const Loop& loop) {
    place_points(loop);
    keep_corners(loop);
    taper();
    narrow();
    return joined();
  }

 private:
  struct Point {
    Vec2 wall;
    Vec2 inwards;
    double s = 0;  ///< mm along the loop
    double aside = 0;
    bool corner = false;
  };

  /// mm; the widest cut that a cutter running along the edge can take within the limit.
  double widest_cut(const Edge& edge) const {
    const double straight = radius_ * (1 - base::cos(limit_));
    if (edge.turn != Turn::kCounterClockwise) return straight;
    // Inside an arc: the width between the circle that the cutter leaves and the one before it.
    const double across = radius_ * base::sin(limit_), along = edge.radius() + radius_ * base::cos(limit_);
    return std::clamp(edge.radius() + radius_ - base::hypot(along, across), 0.0, straight);
  }

  void place_points(const Loop& loop) {
    points_.clear();
    length_ = 0;
    for (const Edge& edge : loop) {
      // Round an obstacle the points are close, because chords between them would cut into it.
      const double pitch = (edge.turn == Turn::kClockwise ? kClosePitch : kPitch) * radius_;
      const int parts = std::max(edge.is_arc() ? kLeastParts : kLeastPartsOfLine,
                                 static_cast<int>(edge.length() / pitch) + 1);
      for (int i = 0; i < parts; ++i) {
        const double t = static_cast<double>(i) / parts;
        points_.push_back({edge.at(t), left_of(edge.tangent_at(t)), length_ + t * edge.length(),
                           kWallShare * widest_cut(edge), false});
      }
      length_ += edge.length();
    }
  }

  void keep_corners(const Loop& loop) {
    double at = 0;
    for (std::size_t e = 0; e < loop.size(); ++e) {
      const Vec2 before = loop[(e + loop.size() - 1) % loop.size()].tangent_at(1),
                 after = loop[e].tangent_at(0);
      const double turn = base::atan2(cross(before, after), dot(before, after));
      if (std::abs(turn) > kCornerTurn) keep_corner(at, RadiusShares::kCornerReach * radius_);
      at += loop[e].length();
    }
  }

  void keep_corner(double at, double zone) {
    for (Point& point : points_) {
      const double along = std::abs(point.s - at), away = std::min(along, length_ - along);
      if (away < zone) point.aside = 0;
      if (away == 0) point.corner = true;
    }
  }

  void taper() {
    const std::size_t n = points_.size();
    const auto limit_by = [&](Point& point, const Point& other) {
      point.aside = std::min(point.aside, other.aside + taper_ * distance(point.wall, other.wall));
    };
    for (std::size_t i = 1; i < 2 * n; ++i) limit_by(points_[i % n], points_[(i - 1) % n]);
    for (std::size_t i = 2 * n; i > 0; --i) limit_by(points_[(i - 1) % n], points_[i % n]);
  }

  /// Reduces the distance from a wall where another wall is near.
  void narrow() {
    bool narrower = false;
    for (Point& point : points_) {
      if (point.aside == 0 || is_wide(point, point.aside)) continue;
      double wide = 0, narrow = point.aside;
      for (int i = 0; i < kHalvings; ++i) {
        const double middle = (wide + narrow) / 2;
        (is_wide(point, middle) ? wide : narrow) = middle;
      }
      point.aside = wide < kLeastAside * radius_ ? 0 : wide;
      narrower = true;
    }
    if (narrower) taper();
  }

  bool is_wide(const Point& point, double aside) const {
    const double half = kLeastWidth / 2 * aside;
    const Vec2 p = point.wall + point.inwards * half;
    return area_.contains(p) && !area_.is_near_boundary(p, 0.95 * half);
  }

  Loop joined() const {
    const std::size_t n = points_.size();
    std::size_t first = 0;
    while (first < n && !points_[first].corner) ++first;
    if (first == n) first = 0;
    Loop loop;
    std::vector<Vec2> run;
    for (std::size_t i = 0; i <= n; ++i) {
      const Point& point = points_[(first + i) % n];
      run.push_back(point.wall + point.inwards * point.aside);
      if (i == 0 || (i < n && !point.corner)) continue;
      for (const Edge& edge : fit_arcs(run, kTolerance)) loop.push_back(edge);
      run = {run.back()};
    }
    return loop;
  }

  LegalArea area_;
  double radius_;
  double limit_;
  double taper_ = 0;  ///< greatest change of the distance from the wall, mm per mm along it
  double length_ = 0;
  std::vector<Point> points_;
};

}  // namespace

Region front_area(const Region& legal, double tool_radius, double limit) {
  double length = clearcut::length(legal.outer());
  for (const Loop& island : legal.islands()) length += clearcut::length(island);
  const double edges = static_cast<double>(legal.edges().size());
  if ((length / (kPitch * tool_radius) + edges) * edges > kMostWork) return legal;
  FrontOutline outline(legal, tool_radius, limit);
  std::vector<Loop> islands;
  for (const Loop& island : legal.islands()) islands.push_back(outline.around(island));
  return Region::from_valid_loops(outline.around(legal.outer()), std::move(islands));
}

}  // namespace clearcut::plan::adaptive
