// Engagement arcs: the directions around a cutter's centre with material at its circle, and sets of directions as
// intervals of angles. Computed without trigonometric functions, because planning and checking spend most of their
// time here.
#pragma once

#include <cmath>
#include <span>

#include "base/units.h"
#include "geometry/vec2.h"

namespace clearcut::stock {

/// Angles from `from` up to `to`, in radians, from <= to.
struct AngleInterval {
  double from = 0;
  double to = 0;
  double width() const { return to - from; }
};

/// A union of a few disjoint intervals in ascending order.
class AngleSet {
 public:
  /// The greatest number of intervals in a set.
  static constexpr int kCapacity = 48;

  AngleSet(double from, double to) : count_(1) { items_[0] = {from, to}; }
  /// `items`: disjoint, ascending, at most kCapacity; intervals of width 0 are left out.
  explicit AngleSet(std::span<const AngleInterval> items);
  AngleSet(const AngleSet& other) { *this = other; }
  /// Copies only the intervals in use, because sets are copied often and mostly hold one or two.
  AngleSet& operator=(const AngleSet& other);

  bool empty() const { return count_ == 0; }
  /// Sum of the widths, radians.
  double measure() const;
  std::span<const AngleInterval> intervals() const { return {items_, static_cast<std::size_t>(count_)}; }

 private:
  int count_ = 0;
  AngleInterval items_[kCapacity];
};

/// The area that a cutter swept along a point, a line, or an arc of less than half a turn: all points within `radius`
/// of its path. mm.
///
/// Between the planes across its ends it is a rectangle or a part of a ring; beyond them it is a half disc.
struct Swept {
  enum class Kind : unsigned char { kDisc, kLine, kArc };
  Kind kind = Kind::kDisc;
  bool round_start = true;  ///< false: another sweep covers the area beyond the start
  /// False: another sweep covers the area beyond the end, and a little before the end.
  bool round_end = true;
  double radius = 0;  ///< radius of the cutter
  Vec2 from;          ///< its beginning; for a disc the centre
  Vec2 to;
  Vec2 before;      ///< unit vector, backwards at the start
  Vec2 after;       ///< unit vector, forwards at the end
  Vec2 center;      ///< centre of an arc
  double ring = 0;  ///< radius of an arc

  /// Whether p is within `far` mm (> 0) of the point, line or arc. Uses neither roots nor divisions.
  bool comes_within(Vec2 p, double far) const;
  bool covers(Vec2 p) const { return comes_within(p, radius); }
};

/// Rate of change of the engagement.
struct EngagementChange {
  double per_mm = 0;      ///< radians per mm of straight advance
  double per_radian = 0;  ///< radians per radian of left turn of the heading
};

/// The circle of a cutter, or its front half, minus the directions in swept areas.
///
/// The rest is kept as spans between two directions. A swept area covers the part of the circle within up
/// to four bounds, each a line or a circle. Most spans are on one side of most bounds, as decided by one product for
/// each end; a square root is needed only if a bound crosses a span. Exact up to rounding.
class EngagementArcs {
 public:
  enum class Part { kFront, kWhole };
  /// `ahead`: the direction of travel, of any length > 0; angles are measured from it.
  EngagementArcs(Vec2 center, double radius, Vec2 ahead, Part part);

  bool empty() const { return count_ == 0; }
  /// Whether a disc of radius `reach` about `at` may cover some of the remaining directions.
  bool may_meet(Vec2 at, double reach) const {
    const double far = reach + rest_radius_;
    return norm_squared(at - rest_center_) <= far * far;
  }
  void clear() { count_ = 0; }
  /// Removes the directions covered by `swept`. True if some of them had remained.
  bool remove(const Swept& swept);
  /// Removes the directions u with dot(normal, u) > q; `normal` is a unit vector.
  void remove_beyond(Vec2 normal, double q);

  /// The remaining directions, as angles from `ahead` in [-pi, pi].
  AngleSet angles() const;
  /// Total width of the remaining directions, radians.
  double measure() const;
  /// The number of remaining separate intervals.
  int parts() const { return count_; }
  /// The change of measure() as the cutter moves straight ahead and as `ahead` turns.
  EngagementChange change() const;
  /// Unit vector to the middle of the widest interval; there must be one.
  Vec2 middle_of_widest() const;

 private:
  /// The beginning or end of a span. Members have no initial values, because most of the many objects are never
  /// used.
  struct End {
    double order;  ///< grows with the angle from `ahead`: 0 ahead, 1 on the left, +-2 behind, -1 on the right
    double x, y;   ///< the direction, a unit vector
    /// Normal of the line or circle that caused this end, of any length; zero: the end turns with `ahead`.
    double nx, ny;
    Vec2 direction() const { return {x, y}; }
    Vec2 normal() const { return {nx, ny}; }
  };
  /// The directions from one end to the other, counter-clockwise.
  struct Span {
    End from, to;
    bool is_wide() const { return to.order - from.order >= 2; }  ///< half a turn or more
    /// Whether the direction v, of any length, may be in the span.
    bool holds(Vec2 v) const {
      const bool after = cross(from.direction(), v) >= 0, before = cross(v, to.direction()) >= 0;
      return is_wide() ? after || before : after && before;
    }
    double width() const;
  };
  /// The directions u with dot(normal, u) <= most are within the bound.
  struct Bound {
    Vec2 normal;
    double most;
    double squared;  ///< squared length of the normal
    double round;    ///< mm; the normal of the bound at the direction u is normal + round * u
  };
  /// Position of the ends of a span relative to a bound, and of the middle if different from both.
  enum class Side { kWithin, kBeyond, kFromBeyond, kToBeyond, kMiddleBeyond, kMiddleWithin };
  /// The bounds of one swept area; a direction within all of them is removed.
  struct Bounds {
    Bound items[4];
    int count = 0;
    void add(const Bound& bound) { items[count++] = bound; }
  };
  /// The bounds crossing one span.
  struct Crossed {
    const Bound* bounds[4];
    Side sides[4];
    int count = 0;
  };
  /// A few spans, in ascending order.
  struct Pieces {
    Span items[8];
    int count = 0;
    void add(const Span& span);
    void merge();
  };

  // All remaining points of the circle are within rest_radius_ of rest_center_.
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
  const double inverse_;  ///< 1 / radius
  const Vec2 ahead_;
  int count_ = 1;
  Span items_[kCapacity + 1];  ///< disjoint, ascending
  Vec2 rest_center_;
  double rest_radius_ = 0;
};

}  // namespace clearcut::stock
