#include "stock/horizon.h"

#include <algorithm>

#include "base/units.h"

namespace clearcut {
namespace {

/// mm. Of two discs in one place, as a cutter and where it stands, neither reaches out of the other.
constexpr double kCoincident = 1e-9;

/// Grows with the angle of v from the x axis: -2 .. 2. v of any length > 0.
double pseudo_angle(Vec2 v) {
  const double q = 1 - v.x / (std::abs(v.x) + std::abs(v.y));
  return v.y < 0 ? -q : q;
}

/// The direction of a pseudo-angle, not of unit length.
Vec2 way_of(double pseudo) {
  const double q = std::abs(pseudo);
  return {1 - q, std::copysign(q <= 1 ? q : 2 - q, pseudo)};
}

Vec2 right_of(Vec2 v) {
  return {v.y, -v.x};
}

}  // namespace

Horizon::Horizon(Vec2 center, double radius, Vec2 ahead, Part part)
    : center_(center), radius_(radius), inverse_(1 / radius), ahead_(ahead / std::sqrt(norm_squared(ahead))) {
  const Vec2 right = right_of(ahead_);
  items_[0] = part == Part::kFront ? Span{{-1, right.x, right.y}, {1, -right.x, -right.y}}
                                   : Span{{-2, -ahead_.x, -ahead_.y}, {2, -ahead_.x, -ahead_.y}};
  look();
}

double Horizon::Span::width() const {
  const double angle = std::atan2(cross(from.way(), to.way()), dot(from.way(), to.way()));
  return is_wide() && angle <= 0 ? angle + 2 * kPi : std::max(angle, 0.0);
}

/// A direction that is in the span but for rounding, which may carry it past an end, and past straight behind.
Horizon::End Horizon::end_in(const Span& span, Vec2 way) const {
  const double order = pseudo_angle({dot(ahead_, way), cross(ahead_, way)});
  const double turn = 4, before = span.from.order - order, after = order - span.to.order;
  if (before > 0) return before <= after + turn ? span.from : span.to;
  if (after > 0) return after <= before + turn ? span.to : span.from;
  return {order, way.x, way.y};
}

/// The circle about the cutter's centre is within another where |w + radius u|^2 <= its_radius^2, w from that
/// circle's centre to the cutter's.
Horizon::Bound Horizon::within_circle(Vec2 w, double its_radius) const {
  const double squared = norm_squared(w);
  return {w, (its_radius * its_radius - squared - radius_ * radius_) * (0.5 * inverse_), squared};
}

void Horizon::remove_disc(Vec2 at, double disc) {
  if (!may_meet(at, disc)) return;
  const Bound bound[] = {within_circle(center_ - at, disc)};
  const double room = radius_ - disc + kCoincident;
  if (room >= 0 && bound->squared <= room * room) return;
  remove_within(bound);
}

void Horizon::remove_beyond(Vec2 normal, double q) {
  const Bound bound[] = {{-normal, -q, 1}};
  remove_within(bound);
}

// A bound of the swept part that all of what is left keeps is not looked at further.

void Horizon::remove_line(const SweptLine& line) {
  const Vec2 rest = rest_center_ - line.from;
  const double forward = dot(rest, line.along), aside = cross(line.along, rest);
  if (forward <= -rest_radius_ || forward >= line.length + rest_radius_ ||
      std::abs(aside) >= line.radius + rest_radius_)
    return;
  const Vec2 w = center_ - line.from, left = left_of(line.along);
  const double along = dot(w, line.along), beside = cross(line.along, w);
  Bound bounds[4];
  std::size_t n = 0;
  if (aside + rest_radius_ > line.radius) bounds[n++] = within_line(left, line.radius - beside);
  if (aside - rest_radius_ < -line.radius) bounds[n++] = within_line(-left, line.radius + beside);
  if (forward < rest_radius_) bounds[n++] = within_line(-line.along, along);
  if (forward + rest_radius_ > line.length) bounds[n++] = within_line(line.along, line.length - along);
  remove_within({bounds, n});
}

void Horizon::remove_arc(const SweptArc& arc) {
  const Vec2 rest = rest_center_ - arc.center;
  const double before = dot(arc.before, rest), after = dot(arc.after, rest);
  if (before >= rest_radius_ || after >= rest_radius_) return;
  const double outer = arc.ring + arc.radius, inner = arc.ring - arc.radius;
  const double squared = norm_squared(rest);
  const auto lies_beyond = [&](double radius) { return radius <= 0 || squared >= radius * radius; };
  if (lies_beyond(outer + rest_radius_)) return;
  const double hollow = inner - rest_radius_;
  if (hollow > 0 && !lies_beyond(hollow)) return;
  const Vec2 w = center_ - arc.center;
  Bound bounds[4];
  std::size_t n = 0;
  if (lies_beyond(outer - rest_radius_)) bounds[n++] = within_circle(w, outer);
  if (inner > 0 && !lies_beyond(inner + rest_radius_)) {
    const Bound hole = within_circle(w, inner);
    bounds[n++] = {-hole.normal, -hole.most, hole.squared};
  }
  if (before > -rest_radius_) bounds[n++] = within_line(arc.before, -dot(arc.before, w));
  if (after > -rest_radius_) bounds[n++] = within_line(arc.after, -dot(arc.after, w));
  remove_within({bounds, n});
}

Horizon::Side Horizon::side_of(const Bound& bound, const Span& span) {
  const bool from_beyond = dot(bound.normal, span.from.way()) > bound.most;
  const bool to_beyond = dot(bound.normal, span.to.way()) > bound.most;
  if (from_beyond != to_beyond) return Side::kAcross;
  // Between two ends on one side the bound is crossed twice, if at all.
  const double least_squared = bound.most * bound.most;
  if (from_beyond)
    return (bound.most >= 0 || least_squared < bound.squared) && span.holds(-bound.normal) ? Side::kAcross
                                                                                           : Side::kBeyond;
  return (bound.most < 0 || least_squared < bound.squared) && span.holds(bound.normal) ? Side::kAcross
                                                                                       : Side::kWithin;
}

/// The parts of a span beyond a bound that crosses it.
void Horizon::add_beyond(const Bound& bound, const Span& span, Pieces& pieces) const {
  const bool from_beyond = dot(bound.normal, span.from.way()) > bound.most;
  const bool to_beyond = dot(bound.normal, span.to.way()) > bound.most;
  const double half = std::sqrt(std::max(0.0, bound.squared - bound.most * bound.most));
  const Vec2 middle = bound.normal * (bound.most / bound.squared),
             aside = left_of(bound.normal) * (half / bound.squared);
  const bool apart = from_beyond == to_beyond;
  // Beyond begins at middle - aside and ends at middle + aside.
  const End begin = !from_beyond || apart ? end_in(span, middle - aside) : span.from;
  const End end = !to_beyond || apart ? end_in(span, middle + aside) : span.to;
  if (from_beyond && to_beyond) {
    pieces.add({span.from, end});
    pieces.add({begin, span.to});
  } else {
    pieces.add({begin, end});
  }
}

void Horizon::Pieces::add(const Span& span) {
  if (!(span.to.order > span.from.order)) return;
  int place = count++;
  for (; place > 0 && items[place - 1].from.order > span.from.order; --place) items[place] = items[place - 1];
  items[place] = span;
}

void Horizon::Pieces::merge() {
  int merged = 0;
  for (int i = 1; i < count; ++i) {
    if (items[i].from.order <= items[merged].to.order) {
      if (items[i].to.order > items[merged].to.order) items[merged].to = items[i].to;
    } else {
      items[++merged] = items[i];
    }
  }
  count = std::min(count, merged + 1);
}

/// Takes away what lies within all bounds.
void Horizon::remove_within(std::span<const Bound> bounds) {
  bool changed = false;
  for (int i = 0; i < count_;) {
    const Span span = items_[i];
    const Bound* across[4];
    int crossing = 0;
    bool beyond = false;
    for (const Bound& bound : bounds) {
      const Side side = side_of(bound, span);
      beyond = side == Side::kBeyond;
      if (beyond) break;
      if (side == Side::kAcross) across[crossing++] = &bound;
    }
    if (beyond) {
      ++i;
      continue;
    }
    Pieces pieces;
    for (int k = 0; k < crossing; ++k) add_beyond(*across[k], span, pieces);
    pieces.merge();
    const bool whole = pieces.count == 1 && pieces.items[0].from.order == span.from.order &&
                       pieces.items[0].to.order == span.to.order;
    changed |= !whole;
    i = whole ? i + 1 : replace(i, pieces.items, pieces.count);
  }
  if (changed && count_ > 0) look();
}

/// Puts pieces where a span was; returns the place after them.
int Horizon::replace(int place, const Span* pieces, int count) {
  if (count == 1) {
    items_[place] = pieces[0];
    return place + 1;
  }
  if (count == 0) {
    std::move(items_ + place + 1, items_ + count_, items_ + place);
    --count_;
    return place;
  }
  // Up to count - 1 more than there is room for are dropped one by one.
  items_[place] = pieces[0];
  int next = place + 1;
  for (int i = 1; i < count; ++i) {
    std::move_backward(items_ + next, items_ + count_, items_ + count_ + 1);
    items_[next] = pieces[i];
    ++next;
    ++count_;
    if (count_ > kCapacity) {
      drop_narrowest();
      next = std::min(next, count_);
    }
  }
  return next;
}

/// A full set drops its narrowest item: less than is left is reported rather than none at all.
void Horizon::drop_narrowest() {
  Span* narrowest = std::min_element(items_, items_ + count_, [](const Span& a, const Span& b) {
    return a.to.order - a.from.order < b.to.order - b.from.order;
  });
  std::move(narrowest + 1, items_ + count_, narrowest);
  --count_;
}

/// What is left lies on the circle beside the widest gap.
void Horizon::look() {
  rest_center_ = center_;
  rest_radius_ = radius_ * (1 + 1e-12) + 1e-12;
  int first = 0;
  double widest = items_[0].from.order + 4 - items_[count_ - 1].to.order;
  for (int i = 1; i < count_; ++i) {
    const double gap = items_[i].from.order - items_[i - 1].to.order;
    if (gap <= widest) continue;
    widest = gap;
    first = i;
  }
  if (widest < 2) return;  // more than a half turn
  const Vec2 from = items_[first].from.way(), to = items_[first == 0 ? count_ - 1 : first - 1].to.way();
  // The disc about the chord's middle holds the arc.
  rest_center_ = center_ + (from + to) * (0.5 * radius_);
  rest_radius_ = radius_ * std::sqrt(norm_squared(to - from)) / 2 * (1 + 1e-12) + 1e-12;
}

AngleSet Horizon::angles() const {
  const auto angle = [](const End& end) {
    const Vec2 way = way_of(end.order);
    return std::atan2(way.y, way.x);
  };
  AngleInterval found[kCapacity];
  for (int i = 0; i < count_; ++i) found[i] = {angle(items_[i].from), angle(items_[i].to)};
  return AngleSet({found, static_cast<std::size_t>(count_)});
}

double Horizon::measure() const {
  double sum = 0;
  for (int i = 0; i < count_; ++i) sum += items_[i].width();
  return sum;
}

Vec2 Horizon::middle_of_widest() const {
  const Span& widest = *std::max_element(items_, items_ + count_,
                                         [](const Span& a, const Span& b) { return a.width() < b.width(); });
  const Vec2 from = widest.from.way(), to = widest.to.way();
  // Square to the chord, which is none of a whole circle.
  const Vec2 middle = widest.is_wide() ? right_of(to - from) : from + to;
  return middle == Vec2{} ? ahead_ : unit(middle);
}

}  // namespace clearcut
