// Which directions around a cutter's centre are still in material, kept without trigonometry.
#pragma once

#include "geometry/vec2.h"
#include "stock/angle_set.h"

namespace clearcut {

/// A line that cutters swept: what the kernel needs of it.
struct SweptLine {
  Vec2 from;
  Vec2 along;  ///< unit
  double length = 0;
  double radius = 0;
};

/// An arc of less than a half turn that cutters swept.
struct SweptArc {
  Vec2 center;
  double ring = 0;    ///< radius of the arc
  Vec2 before;        ///< unit, square to the ray through the start, away from the arc
  Vec2 after;         ///< unit, square to the ray through the end, away from the arc
  double radius = 0;  ///< of the cutter
};

/// The circle of a cutter, or its front half, less what sweeps cover.
///
/// Directions are told apart by a pseudo-angle that grows with the angle from `ahead`: 0 ahead, 1 on the left, +-2
/// behind, -1 on the right. Angles are computed once, for the result. Exact to rounding.
class Horizon {
 public:
  enum class Part { kFront, kWhole };
  /// `ahead`: any length > 0; the result is told from it.
  Horizon(Vec2 center, double radius, Vec2 ahead, Part part);

  bool empty() const { return count_ == 0; }
  /// Whether a disc of `reach` about `at` may cover any of what is left.
  bool may_meet(Vec2 at, double reach) const {
    const double far = reach + rest_radius_;
    return norm_squared(at - rest_center_) <= far * far;
  }
  void clear() { count_ = 0; }
  void remove_disc(Vec2 at, double disc);
  /// The rectangle, or part of a ring, between the discs at the ends.
  void remove_line(const SweptLine& line);
  void remove_arc(const SweptArc& arc);
  /// Directions u with dot(normal, u) > q, normal of length 1.
  void remove_beyond(Vec2 normal, double q);

  AngleSet angles() const;

 private:
  struct Span {
    double from = 0;
    double to = 0;
  };
  /// Up to four arcs of directions as ascending spans.
  struct Spans {
    Span items[8];
    int count = 0;
    bool all = false;
    void add(double from, double to);
    void merge();
  };

  Vec2 seen(Vec2 u) const { return {dot(ahead_, u), cross(ahead_, u)}; }
  void add_beyond(Vec2 normal, double q, Spans& spans) const;
  void remove_span(double from, double to);
  void keep(Spans& spans);
  void append(Span span);
  void look();
  void look_at_ends();
  // Whether a shape may cover any of what is left: no more than a bound of it, but without a root or a division.
  bool may_cover(const SweptLine& line) const;
  bool may_cover(const SweptArc& arc) const;
  bool may_cover(Vec2 v, double disc) const;

  static constexpr int kCapacity = AngleSet::kCapacity;
  const Vec2 center_;
  const double radius_;
  const double inverse_;  ///< of the radius
  const Vec2 ahead_;
  int count_ = 1;
  Span items_[kCapacity];
  /// Where a span begins and ends, directions of length 1.
  struct Ends {
    Vec2 from, to;
    bool wide = false;  ///< a half turn or more
    /// Whether the direction v, of any length, may be between.
    bool holds(Vec2 v) const {
      return wide ? !(cross(to, v) > 0 && cross(v, from) > 0) : cross(from, v) >= 0 && cross(v, to) >= 0;
    }
    /// Whether dot(normal, u) >= q for all directions u between.
    bool is_beyond(Vec2 normal, double q) const {
      return dot(normal, from) >= q && dot(normal, to) >= q && !holds(-normal);
    }
  };
  /// More spans than this are not looked at one by one.
  static constexpr int kFewSpans = 8;
  Ends ends_[kFewSpans];
  int known_ends_ = 0;  ///< of all spans, or 0
  // Everything left lies within rest_radius_ of rest_center_.
  Span looked_;
  Vec2 rest_center_;
  double rest_radius_ = 0;
};

}  // namespace clearcut
