#include "stock/engagement_arcs.h"

#include <algorithm>

#include "base/elementary.h"
#include "base/error.h"
#include "base/tolerances.h"
#include "base/units.h"

namespace clearcut::stock {

AngleSet::AngleSet(std::span<const AngleInterval> items) {
  CLEARCUT_ASSERT(items.size() <= kCapacity);
  for (const AngleInterval& item : items) {
    if (item.to > item.from) items_[count_++] = item;
  }
}

AngleSet& AngleSet::operator=(const AngleSet& other) {
  count_ = other.count_;
  std::copy(other.items_, other.items_ + other.count_, items_);
  return *this;
}

double AngleSet::measure() const {
  double sum = 0;
  for (const AngleInterval& item : intervals()) sum += item.width();
  return sum;
}

namespace {

/// Sine. A circle crossing a line or circle at a smaller angle is treated as crossing at this angle: at a
/// tangent the rate of change would be infinite.
constexpr double kTangent = 1e-6;

/// Grows with the angle of v from the x axis, from -2 to 2. v has any length > 0.
double pseudo_angle(Vec2 v) {
  const double q = 1 - v.x / (std::abs(v.x) + std::abs(v.y));
  return v.y < 0 ? -q : q;
}

/// The direction with the given pseudo-angle, of any length.
Vec2 direction_of(double pseudo) {
  const double q = std::abs(pseudo);
  return {1 - q, std::copysign(q <= 1 ? q : 2 - q, pseudo)};
}

/// A radius enlarged so that rounding cannot have made it too small.
double enclosing(double radius) {
  return radius * (1 + 1e-12) + 1e-12;
}

Vec2 right_of(Vec2 v) {
  return {v.y, -v.x};
}

}  // namespace

bool Swept::comes_within(Vec2 p, double far) const {
  const double far_squared = far * far;
  if (kind == Kind::kDisc) return norm_squared(p - from) <= far_squared;
  const bool is_before = dot(before, p - from) > 0, is_after = dot(after, p - to) > 0;
  if (is_before && norm_squared(p - from) <= far_squared) return true;
  if (is_after && norm_squared(p - to) <= far_squared) return true;
  if (is_before || is_after) return false;
  if (kind == Kind::kLine) return std::abs(cross(after, p - from)) <= far;
  const double squared = norm_squared(p - center), outer = ring + far, inner = ring - far;
  return squared <= outer * outer && (inner <= 0 || squared >= inner * inner);
}

EngagementArcs::EngagementArcs(Vec2 center, double radius, Vec2 ahead, Part part)
    : center_(center),
      radius_(radius),
      inverse_(1 / radius),
      ahead_(ahead * (1 / std::sqrt(norm_squared(ahead)))),
      rest_center_(center),
      rest_radius_(enclosing(radius)) {
  const Vec2 right = right_of(ahead_);
  items_[0] = part == Part::kFront ? Span{{-1, right.x, right.y, 0, 0}, {1, -right.x, -right.y, 0, 0}}
                                   : Span{{-2, -ahead_.x, -ahead_.y, 0, 0}, {2, -ahead_.x, -ahead_.y, 0, 0}};
}

double EngagementArcs::Span::width() const {
  const double angle =
      base::atan2(cross(from.direction(), to.direction()), dot(from.direction(), to.direction()));
  return is_wide() && angle <= 0 ? angle + 2 * kPi : std::max(angle, 0.0);
}

/// The end where a bound crosses a span, corrected if rounding moved it past an end of the span or past straight
/// behind.
EngagementArcs::End EngagementArcs::end_in(const Span& span, const Bound& bound, Vec2 direction) const {
  const double order = pseudo_angle({dot(ahead_, direction), cross(ahead_, direction)});
  const double turn = 4, before = span.from.order - order, after = order - span.to.order;
  if (before > 0) return before <= after + turn ? span.from : span.to;
  if (after > 0) return after <= before + turn ? span.to : span.from;
  const Vec2 normal = bound.normal + direction * bound.round;
  return {order, direction.x, direction.y, normal.x, normal.y};
}

/// The bound for being within another circle: |w + radius u|^2 <= its_radius^2, with w the vector from that circle's
/// centre to the cutter's.
EngagementArcs::Bound EngagementArcs::within_circle(Vec2 w, double its_radius) const {
  const double squared = norm_squared(w);
  return {w, (its_radius * its_radius - squared - radius_ * radius_) * (0.5 * inverse_), squared, radius_};
}

void EngagementArcs::remove_beyond(Vec2 normal, double q) {
  Bounds bounds;
  bounds.add({-normal, -q, 1, 0});
  remove_within(bounds);
}

bool EngagementArcs::remove(const Swept& swept) {
  if (swept.kind == Swept::Kind::kDisc) return remove_disc(swept.from, swept.radius);
  if (!swept.comes_within(rest_center_, swept.radius + rest_radius_)) return false;
  const double before = dot(swept.before, rest_center_ - swept.from);
  const double after = dot(swept.after, rest_center_ - swept.to);
  bool changed = false;
  if (before < rest_radius_ && after < rest_radius_) changed = remove_between(swept, before, after);
  if (swept.round_start && may_pass(swept.from, swept.before))
    changed |= remove_disc(swept.from, swept.radius);
  if (swept.round_end && may_pass(swept.to, swept.after)) changed |= remove_disc(swept.to, swept.radius);
  return changed;
}

bool EngagementArcs::remove_disc(Vec2 at, double disc) {
  if (!may_meet(at, disc)) return false;
  Bounds bounds;
  bounds.add(within_circle(center_ - at, disc));
  const double room = radius_ - disc + kRoundingMm;
  if (room >= 0 && bounds.items[0].squared <= room * room) return false;
  return remove_within(bounds);
}

/// Removes the rectangle, or part of a ring, between the planes across the ends of `swept`. Bounds around all
/// remaining directions are skipped.
bool EngagementArcs::remove_between(const Swept& swept, double before, double after) {
  Bounds bounds;
  if (swept.kind == Swept::Kind::kLine) {
    bound_strip(swept, bounds);
  } else {
    bound_ring(swept, bounds);
  }
  if (before > -rest_radius_) bounds.add(within_line(swept.before, swept.from, 0));
  if (after > -rest_radius_)
    bounds.add(within_line(swept.after, swept.to, swept.round_end ? 0 : kRoundingMm));
  return remove_within(bounds);
}

void EngagementArcs::bound_strip(const Swept& line, Bounds& bounds) const {
  const Vec2 left = left_of(line.after);
  const double aside = dot(left, rest_center_ - line.from);
  if (aside + rest_radius_ > line.radius) bounds.add(within_line(left, line.from, line.radius));
  if (aside - rest_radius_ < -line.radius) bounds.add(within_line(-left, line.from, line.radius));
}

void EngagementArcs::bound_ring(const Swept& arc, Bounds& bounds) const {
  const double outer = arc.ring + arc.radius, inner = arc.ring - arc.radius;
  const double squared = norm_squared(rest_center_ - arc.center);
  const double kept = outer - rest_radius_, hollow = inner + rest_radius_;
  if (kept <= 0 || squared > kept * kept) bounds.add(within_circle(center_ - arc.center, outer));
  if (inner <= 0 || squared >= hollow * hollow) return;
  const Bound hole = within_circle(center_ - arc.center, inner);
  bounds.add({-hole.normal, -hole.most, hole.squared, -radius_});
}

EngagementArcs::Side EngagementArcs::side_of(const Bound& bound, const Span& span) {
  const bool from_beyond = dot(bound.normal, span.from.direction()) > bound.most;
  const bool to_beyond = dot(bound.normal, span.to.direction()) > bound.most;
  if (from_beyond != to_beyond) return from_beyond ? Side::kFromBeyond : Side::kToBeyond;
  // Both ends are on one side: the bound crosses the span twice or not at all.
  const bool meets = bound.most * bound.most < bound.squared;
  if (from_beyond)
    return (bound.most >= 0 || meets) && span.holds(-bound.normal) ? Side::kMiddleWithin : Side::kBeyond;
  return (bound.most < 0 || meets) && span.holds(bound.normal) ? Side::kMiddleBeyond : Side::kWithin;
}

/// The end where a bound crosses a span, on the left (1) or right (-1) of the bound's normal; the part beyond begins
/// on the right.
EngagementArcs::End EngagementArcs::crossing(const Bound& bound, double side, const Span& span) const {
  const double inverse = 1 / bound.squared;
  const double half = std::sqrt(std::max(0.0, bound.squared - bound.most * bound.most));
  const Vec2 direction =
      bound.normal * (bound.most * inverse) + left_of(bound.normal) * (side * half * inverse);
  return end_in(span, bound, direction);
}

/// Adds the parts of a span beyond a bound crossing it.
void EngagementArcs::add_beyond(const Bound& bound, Side side, const Span& span, Pieces& pieces) const {
  switch (side) {
    case Side::kFromBeyond:
      return pieces.add({span.from, crossing(bound, 1, span)});
    case Side::kToBeyond:
      return pieces.add({crossing(bound, -1, span), span.to});
    case Side::kMiddleBeyond:
      return pieces.add({crossing(bound, -1, span), crossing(bound, 1, span)});
    case Side::kMiddleWithin:
      pieces.add({span.from, crossing(bound, 1, span)});
      return pieces.add({crossing(bound, -1, span), span.to});
    case Side::kWithin:
    case Side::kBeyond:
      return;
  }
}

void EngagementArcs::Pieces::add(const Span& span) {
  if (!(span.to.order > span.from.order)) return;
  int place = count++;
  for (; place > 0 && items[place - 1].from.order > span.from.order; --place) items[place] = items[place - 1];
  items[place] = span;
}

void EngagementArcs::Pieces::merge() {
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

/// Removes the directions within all bounds.
bool EngagementArcs::remove_within(const Bounds& bounds) {
  bool changed = false;
  for (int i = 0; i < count_;) {
    Crossed crossed;
    if (is_beyond_any(bounds, items_[i], crossed)) {
      ++i;
    } else {
      i = cut(i, crossed, changed);
    }
  }
  if (changed && count_ > 0) bound_rest();
  return changed;
}

/// Whether the whole span is beyond one of the bounds. If not, `crossed` gets the bounds that cross it.
bool EngagementArcs::is_beyond_any(const Bounds& bounds, const Span& span, Crossed& crossed) {
  for (int k = 0; k < bounds.count; ++k) {
    const Side side = side_of(bounds.items[k], span);
    if (side == Side::kBeyond) return true;
    if (side == Side::kWithin) continue;
    crossed.bounds[crossed.count] = &bounds.items[k];
    crossed.sides[crossed.count++] = side;
  }
  return false;
}

/// Keeps the parts of a span beyond one of the bounds crossing it; returns the index after these parts.
int EngagementArcs::cut(int place, const Crossed& crossed, bool& changed) {
  Span& span = items_[place];
  // In nearly all cases one end moves.
  if (crossed.count == 1 && (crossed.sides[0] == Side::kFromBeyond || crossed.sides[0] == Side::kToBeyond)) {
    const bool keeps_from = crossed.sides[0] == Side::kFromBeyond;
    const End end = crossing(*crossed.bounds[0], keeps_from ? 1 : -1, span);
    End& moved = keeps_from ? span.to : span.from;
    changed |= moved.order != end.order;
    moved = end;
    return span.to.order > span.from.order ? place + 1 : replace(place, nullptr, 0);
  }
  Pieces pieces;
  for (int k = 0; k < crossed.count; ++k) add_beyond(*crossed.bounds[k], crossed.sides[k], span, pieces);
  if (crossed.count > 1) pieces.merge();
  if (pieces.count == 1 && pieces.items[0].from.order == span.from.order &&
      pieces.items[0].to.order == span.to.order)
    return place + 1;
  changed = true;
  return replace(place, pieces.items, pieces.count);
}

/// Puts pieces in place of a span; returns the index after them.
int EngagementArcs::replace(int place, const Span* pieces, int count) {
  if (count == 1) {
    items_[place] = pieces[0];
    return place + 1;
  }
  if (count == 0) {
    std::move(items_ + place + 1, items_ + count_, items_ + place);
    --count_;
    return place;
  }
  // If the set is full, its narrowest spans are dropped one by one.
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

/// Drops the narrowest span of a full set: reporting slightly less than is left is better than nothing.
void EngagementArcs::drop_narrowest() {
  Span* narrowest = std::min_element(items_, items_ + count_, [](const Span& a, const Span& b) {
    return a.to.order - a.from.order < b.to.order - b.from.order;
  });
  std::move(narrowest + 1, items_ + count_, narrowest);
  --count_;
}

/// Sets the disc around all remaining directions: the part of the circle opposite to the widest gap.
void EngagementArcs::bound_rest() {
  int first = 0;
  double widest = items_[0].from.order + 4 - items_[count_ - 1].to.order;
  for (int i = 1; i < count_; ++i) {
    const double gap = items_[i].from.order - items_[i - 1].to.order;
    if (gap <= widest) continue;
    widest = gap;
    first = i;
  }
  if (widest < 2) {  // more than a half turn is left
    rest_center_ = center_;
    rest_radius_ = enclosing(radius_);
    return;
  }
  const Vec2 from = items_[first].from.direction(),
             to = items_[first == 0 ? count_ - 1 : first - 1].to.direction();
  // The disc about the middle of the chord holds the arc.
  rest_center_ = center_ + (from + to) * (0.5 * radius_);
  rest_radius_ = enclosing(0.5 * radius_ * std::sqrt(norm_squared(to - from)));
}

AngleSet EngagementArcs::angles() const {
  const auto angle = [](const End& end) {
    const Vec2 direction = direction_of(end.order);
    return base::atan2(direction.y, direction.x);
  };
  AngleInterval found[kCapacity];
  for (int i = 0; i < count_; ++i) found[i] = {angle(items_[i].from), angle(items_[i].to)};
  return AngleSet({found, static_cast<std::size_t>(count_)});
}

double EngagementArcs::measure() const {
  double sum = 0;
  for (int i = 0; i < count_; ++i) sum += items_[i].width();
  return sum;
}

/// Radians to the left that an end moves per mm of the cutter's advance.
double EngagementArcs::drift(const End& end) const {
  const Vec2 normal = end.normal();
  const double least = kTangent * std::sqrt(norm_squared(normal)),
               across = dot(normal, left_of(end.direction()));
  if (least == 0) return 0;
  return -dot(normal, ahead_) /
         (radius_ * (std::abs(across) < least ? std::copysign(least, across) : across));
}

EngagementChange EngagementArcs::change() const {
  EngagementChange change;
  for (int i = 0; i < count_; ++i) {
    const Span& span = items_[i];
    change.per_mm += drift(span.to) - drift(span.from);
    change.per_radian += (span.to.normal() == Vec2{}) - (span.from.normal() == Vec2{});
  }
  return change;
}

Vec2 EngagementArcs::middle_of_widest() const {
  const Span& widest = *std::max_element(items_, items_ + count_,
                                         [](const Span& a, const Span& b) { return a.width() < b.width(); });
  const Vec2 from = widest.from.direction(), to = widest.to.direction();
  // Square to the chord; a whole circle has none.
  const Vec2 middle = widest.is_wide() ? right_of(to - from) : from + to;
  return middle == Vec2{} ? ahead_ : unit(middle);
}

}  // namespace clearcut::stock
