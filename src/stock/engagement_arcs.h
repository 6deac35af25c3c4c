// The engagement arcs: which directions around a cutter's centre are in material. Computed without trigonometric functions,
// because this is the innermost loop of planning and checking.
#pragma once

#include <cmath>
#include <span>

#include "geometry/vec2.h"
#include "stock/angle_set.h"

namespace clearcut::stock {

/// The area that a cutter swept along a point, a line, or an arc of less than a half turn: all points no farther than `radius`
/// from it. Lengths in mm.
///
/// Within the planes across its ends it is a rectangle or a part of a ring, beyond them it is round.
struct Swept {
  enum class Kind : unsigned char { kDisc, kLine, kArc };
  Kind kind = Kind::kDisc;
  bool round_start = true;  ///< false: another sweep covers what is beyond the start
  bool round_end = true;    ///< false: another sweep covers what is beyond the end, and a little before
  double radius = 0;        ///< of the cutter
  Vec2 from;                ///< beginning; of a disc: its centre
  Vec2 to;
  Vec2 before;      ///< unit, backwards at the start
  Vec2 after;       ///< unit, onwards at the end
  Vec2 center;      ///< of an arc
  double ring = 0;  ///< radius of an arc

  /// Whether the place, line or arc is no farther from p than `far` mm, > 0. Takes neither roots nor divisions.
  bool comes_within(Vec2 p, double far) const;
  bool covers(Vec2 p) const { return comes_within(p, radius); }
};

/// How fast the engagement changes.
struct EngagementChange {
  double per_mm = 0;      ///< radians per mm of going straight ahead
  double per_radian = 0;  ///< radians per radian of turning the heading to the left
};

/// The circle of a cutter, or its front half, minus the directions that lie in swept areas.
///
/// What is left are spans between two directions. A sweep is the part of the circle within up to four bounds, each a
/// line or a circle; most spans lie on one side of most of them, which their ends tell by a product each. Only where
/// a bound crosses a span a root is drawn. Exact to rounding.
class EngagementArcs {
 public:
  enum class Part { kFront, kWhole };
  /// `ahead`: the direction of travel, of any length > 0; resulting angles are measured from it.
  EngagementArcs(Vec2 center, double radius, Vec2 ahead, Part part);

  bool empty() const { return count_ == 0; }
  /// Whether a disc of `reach` about `at` may cover any of what is left.
  bool may_meet(Vec2 at, double reach) const {
    const double far = reach + rest_radius_;
    return norm_squared(at - rest_center_) <= far * far;
  }
  void clear() { count_ = 0; }
  /// Takes away the directions that `swept` covers. Whether any of them was left before.
  bool remove(const Swept& swept);
  /// Takes away the directions u with dot(normal, u) > q. `normal` is a unit vector.
  void remove_beyond(Vec2 normal, double q);

  /// What is left, as angles from `ahead` in [-pi, pi].
  AngleSet angles() const;
  /// Sum of its widths, radians.
  double measure() const;
  /// The number of separate intervals that are left.
  int parts() const { return count_; }
  /// How measure() changes as the cutter moves straight ahead and as `ahead` turns.
  EngagementChange change() const;
  /// The middle of the widest interval, as a unit vector. Something must be left.
  Vec2 middle_of_widest() const;

 private:
  /// Where a span begins or ends. No member is set before it is known: most of the many are never used.
  struct End {
    double order;  ///< grows with the angle from `ahead`: 0 ahead, 1 on the left, +-2 behind, -1 on the right
    double x, y;   ///< the direction, of length 1
    double nx, ny;  ///< across the line or circle that made it, of any length; none: it stays with `ahead`
    Vec2 direction() const { return {x, y}; }
    Vec2 normal() const { return {nx, ny}; }
  };
  struct Span {
    End from, to;
    bool is_wide() const { return to.order - from.order >= 2; }  ///< a half turn or more
    /// Whether the direction v, of any length, may be between.
    bool holds(Vec2 v) const {
      const bool after = cross(from.direction(), v) >= 0, before = cross(v, to.direction()) >= 0;
      return is_wide() ? after || before : after && before;
    }
    double width() const;
  };
  /// Directions u with dot(normal, u) <= most are within.
  struct Bound {
    Vec2 normal;
    double most;
    double squared;  ///< of the normal's length
    double round;    ///< mm; across the bound at the direction u is normal + round * u
  };
  /// Where a bound leaves the ends of a span, and what is between them if that is not where both ends are.
  enum class Side { kWithin, kBeyond, kFromBeyond, kToBeyond, kMiddleBeyond, kMiddleWithin };
  /// Bounds of what is taken away, all at once.
  struct Bounds {
    Bound items[4];
    int count = 0;
    void add(const Bound& bound) { items[count++] = bound; }
  };
  /// Bounds that cross a span.
  struct Crossed {
    const Bound* bounds[4];
    Side sides[4];
    int count = 0;
  };
  /// A few spans, ascending.
  struct Pieces {
    Span items[8];
    int count = 0;
    void add(const Span& span);
    void merge();
  };

  // Everything left lies within rest_radius_ of rest_center_.
  bool may_pass(Vec2 at, Vec2 normal) const { return dot(normal, rest_center_ - at) > -rest_radius_; }
  double drift(const End& end) const;
  bool remove_disc(Vec2 at, double disc);
  bool remove_between(const Swept& swept, double before, double after);
  void bound_strip(const Swept& line, Bounds& bounds) const;
  void bound_ring(const Swept& arc, Bounds& bounds) const;

  static Side side_of(const Bound& bound, const Span& span);
  Bound within_circle(Vec2 from_its_center, double its_radius) const;
  Bound within_line(Vec2 normal, Vec2 at, double beyond) const {
    return {normal, (dot(normal, at - center_) + beyond) * inverse_, 1, 0};
  }
  End crossing(const Bound& bound, double side, const Span& span) const;
  End end_in(const Span& span, const Bound& bound, Vec2 direction) const;
  bool remove_within(const Bounds& bounds);
  static bool is_beyond_any(const Bounds& bounds, const Span& span, Crossed& crossed);
  int cut(int place, const Crossed& crossed, bool& changed);
  int replace(int place, const Span* pieces, int count);
  void add_beyond(const Bound& bound, Side side, const Span& span, Pieces& pieces) const;
  void drop_narrowest();
  void bound_rest();

  static constexpr int kCapacity = AngleSet::kCapacity;
  const Vec2 center_;
  const double radius_;
  const double inverse_;  ///< of the radius
  const Vec2 ahead_;
  int count_ = 1;
  Span items_[kCapacity + 1];  ///< disjoint, ascending
  Vec2 rest_center_;
  double rest_radius_ = 0;
};

}  // namespace clearcut::stock
