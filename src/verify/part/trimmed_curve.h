// A curve without its parts near walls.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/edge.h"

namespace clearcut::verify {

/// The rest of an edge, as ascending disjoint intervals of its parameter. Keeps lengths and angles used by every cut.
class TrimmedCurve {
 public:
  using Interval = std::pair<double, double>;

  explicit TrimmedCurve(const Edge& curve);

  const Edge& curve() const { return curve_; }
  double length() const { return length_; }
  bool empty() const { return parts_.empty(); }
  bool whole() const { return parts_.size() == 1 && parts_.front() == Interval{0, 1}; }
  const std::vector<Interval>& parts() const { return parts_; }
  Vec2 at(double t) const;

  /// The rest is within half() mm of middle().
  Vec2 middle() const { return middle_; }
  double half() const { return half_; }

  /// Whether the whole curve is surely farther than d from a wall: for short curves beside straight walls. May return false although it
  /// is.
  bool stays_beyond(const Edge& wall, double d) const;
  /// Adds the parameters at which legality may change: all at which the curve is at distance d from `wall`, and
  /// perhaps others.
  void add_cuts(const Edge& wall, double d);
  /// Divides the rest at these parameters, and keeps the pieces with is_legal(point) true for their middle.
  template <typename IsLegal>
  void keep(IsLegal is_legal);

 private:
  void add_line_cuts(const Edge& wall, double d);
  void add_arc_cuts(const Edge& wall, double d);
  void find_middle();

  Edge curve_;
  double length_ = 0;
  double sweep_ = 0;
  double radius_ = 0;
  std::vector<Interval> parts_{{0, 1}};
  std::vector<double> cuts_;
  Vec2 middle_;
  double half_ = 0;
  double sagitta_ = 0;  ///< mm; no point of the curve is farther than this from its chord
};

template <typename IsLegal>
void TrimmedCurve::keep(IsLegal is_legal) {
  std::sort(cuts_.begin(), cuts_.end());
  std::vector<Interval> kept;
  for (const Interval& part : parts_) {
    double from = part.first;
    const auto keep_until = [&](double to) {
      if (to <= from) return;
      const bool legal = is_legal(at((from + to) / 2));
      if (legal && !kept.empty() && kept.back().second == from) {
        kept.back().second = to;
      } else if (legal) {
        kept.emplace_back(from, to);
      }
      from = to;
    };
    for (const double t : cuts_) {
      if (t > part.first && t < part.second) keep_until(t);
    }
    keep_until(part.second);
  }
  cuts_.clear();
  parts_ = std::move(kept);
  find_middle();
}

/// The curve at distance d on the left of an edge. Nothing if an arc has no such curve; a point (a line with
/// from == to) at its centre if the remaining radius is within `fit` of 0.
std::vector<Edge> parallel(const Edge& edge, double d, double fit);

/// The circle as two half circles.
std::vector<Edge> circle(Vec2 center, double radius);

}  // namespace clearcut::verify
