#include "stock/horizon.h"

#include <algorithm>
#include <cmath>

namespace clearcut {
namespace {

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

Vec2 turned_to(Vec2 v, double cosine, double sine) {
  return {v.x * cosine - v.y * sine, v.x * sine + v.y * cosine};
}

double sine_of(double cosine) {
  return std::sqrt((1 - cosine) * (1 + cosine));
}

}  // namespace

Horizon::Horizon(Vec2 center, double radius, Vec2 ahead, Part part)
    : center_(center),
      radius_(radius),
      inverse_(1 / radius),
      ahead_(ahead / std::sqrt(norm_squared(ahead))),
      looked_{-9, 9} {
  items_[0] = part == Part::kFront ? Span{-1, 1} : Span{-2, 2};
  look();
}

void Horizon::remove_disc(Vec2 at, double disc) {
  if (!may_meet(at, disc)) return;
  const Vec2 v = at - center_;
  const double squared = norm_squared(v), most = radius_ + disc;
  if (squared >= most * most || !may_cover(v, disc)) return;
  const double d = std::sqrt(squared);
  if (d + disc <= radius_) return;
  if (d + radius_ <= disc) return clear();
  const double cosine = (radius_ * radius_ + squared - disc * disc) / (2 * radius_ * d);
  remove_beyond(v / d, std::max(cosine, -1.0));
}

void Horizon::remove_beyond(Vec2 normal, double q) {
  Spans inside;
  add_beyond(normal, q, inside);
  if (inside.all) return clear();
  if (inside.count == 0) return;
  for (int i = 0; i < inside.count; ++i) remove_span(inside.items[i].from, inside.items[i].to);
  look();
}

// A bound of the swept part that all of what is left keeps is not looked at further.

void Horizon::remove_line(const SweptLine& line) {
  const Vec2 rest = rest_center_ - line.from;
  const double forward = dot(rest, line.along), aside = cross(line.along, rest);
  if (forward <= -rest_radius_ || forward >= line.length + rest_radius_ ||
      std::abs(aside) >= line.radius + rest_radius_ || !may_cover(line))
    return;
  const Vec2 w = center_ - line.from, left = left_of(line.along);
  const double along = dot(w, line.along), beside = cross(line.along, w);
  Spans outside;
  if (aside + rest_radius_ > line.radius) add_beyond(left, (line.radius - beside) / radius_, outside);
  if (aside - rest_radius_ < -line.radius) add_beyond(-left, (line.radius + beside) / radius_, outside);
  if (forward < rest_radius_) add_beyond(-line.along, along / radius_, outside);
  if (forward + rest_radius_ > line.length) add_beyond(line.along, (line.length - along) / radius_, outside);
  keep(outside);
}

void Horizon::remove_arc(const SweptArc& arc) {
  const Vec2 rest = rest_center_ - arc.center;
  const double before = dot(arc.before, rest), after = dot(arc.after, rest);
  if (before >= rest_radius_ || after >= rest_radius_ || !may_cover(arc)) return;
  const double outer = arc.ring + arc.radius, inner = arc.ring - arc.radius;
  const double away_from_rest = std::sqrt(norm_squared(rest));
  if (away_from_rest - rest_radius_ >= outer || away_from_rest + rest_radius_ <= inner) return;
  const Vec2 w = center_ - arc.center;
  const double squared = norm_squared(w), d = std::sqrt(squared), twice = 2 * d * radius_;
  const auto cosine_at = [&](double rho) {
    const double numerator = rho * rho - squared - radius_ * radius_;
    return twice > 0 ? numerator / twice : (numerator > 0 ? 2.0 : -2.0);
  };
  const Vec2 away = d > 0 ? w / d : Vec2{1, 0};
  Spans outside;
  if (away_from_rest + rest_radius_ > outer) add_beyond(away, cosine_at(outer), outside);
  if (inner > 0 && away_from_rest - rest_radius_ < inner) add_beyond(-away, -cosine_at(inner), outside);
  if (before > -rest_radius_) add_beyond(arc.before, -dot(arc.before, w) / radius_, outside);
  if (after > -rest_radius_) add_beyond(arc.after, -dot(arc.after, w) / radius_, outside);
  keep(outside);
}

void Horizon::Spans::add(double from, double to) {
  int place = count++;
  for (; place > 0 && items[place - 1].from > from; --place) items[place] = items[place - 1];
  items[place] = {from, to};
}

void Horizon::add_beyond(Vec2 normal, double q, Spans& spans) const {
  if (q >= 1) return;
  if (q <= -1) {
    spans.all = true;
    return;
  }
  const double sine = sine_of(q);
  const Vec2 n = seen(normal);
  const double from = pseudo_angle(turned_to(n, q, -sine)), to = pseudo_angle(turned_to(n, q, sine));
  if (from <= to) {
    spans.add(from, to);
  } else {
    spans.add(-3, to);
    spans.add(from, 3);
  }
}

/// A full set drops its narrowest item: less than is left is reported rather than none at all.
void Horizon::append(Span span) {
  if (!(span.to > span.from)) return;
  if (count_ < kCapacity) {
    items_[count_++] = span;
    return;
  }
  Span* narrowest = std::min_element(
      items_, items_ + count_, [](const Span& a, const Span& b) { return a.to - a.from < b.to - b.from; });
  if (narrowest->to - narrowest->from >= span.to - span.from) return;
  std::move(narrowest + 1, items_ + count_, narrowest);
  items_[count_ - 1] = span;
}

void Horizon::remove_span(double from, double to) {
  const Span* met = std::find_if(items_, items_ + count_, [&](const Span& item) { return item.to > from; });
  if (met == items_ + count_ || met->from >= to) return;
  Span old[kCapacity];
  const int old_count = count_;
  std::copy(items_, items_ + count_, old);
  count_ = 0;
  for (int i = 0; i < old_count; ++i) {
    append({old[i].from, std::min(old[i].to, from)});
    append({std::max(old[i].from, to), old[i].to});
  }
}

void Horizon::Spans::merge() {
  int merged = 0;
  for (int i = 1; i < count; ++i) {
    if (items[i].from <= items[merged].to) {
      items[merged].to = std::max(items[merged].to, items[i].to);
    } else {
      items[++merged] = items[i];
    }
  }
  count = std::min(count, merged + 1);
}

/// Keeps what lies in one of the spans.
void Horizon::keep(Spans& spans) {
  if (spans.all || count_ == 0) return;
  if (spans.count == 0) return clear();
  spans.merge();
  Span old[kCapacity];
  const int old_count = count_;
  std::copy(items_, items_ + count_, old);
  count_ = 0;
  int k = 0;
  for (int i = 0; i < old_count; ++i) {
    while (k < spans.count && spans.items[k].to <= old[i].from) ++k;
    for (int j = k; j < spans.count && spans.items[j].from < old[i].to; ++j)
      append({std::max(spans.items[j].from, old[i].from), std::min(spans.items[j].to, old[i].to)});
  }
  look();
}

void Horizon::look() {
  if (count_ == 0) return;
  look_at_ends();
  const Span hull{items_[0].from, items_[count_ - 1].to};
  if (hull.from == looked_.from && hull.to == looked_.to) return;
  looked_ = hull;
  rest_center_ = center_;
  rest_radius_ = radius_ * (1 + 1e-12) + 1e-12;
  if (hull.to - hull.from > 2) return;  // more than a half turn
  const Vec2 a = way_of(hull.from), b = way_of(hull.to);
  const Vec2 from = a / std::sqrt(norm_squared(a)), to = b / std::sqrt(norm_squared(b));
  // The disc about the chord's middle holds the arc.
  const Vec2 middle = (from + to) / 2.0;
  rest_center_ =
      center_ + Vec2{dot({ahead_.x, -ahead_.y}, middle), dot({ahead_.y, ahead_.x}, middle)} * radius_;
  rest_radius_ = radius_ * std::sqrt(norm_squared(to - from)) / 2 * (1 + 1e-12) + 1e-12;
}

void Horizon::look_at_ends() {
  known_ends_ = 0;
  if (count_ > kFewSpans || items_[0].to - items_[0].from >= 4) return;
  const auto unit_way = [this](double pseudo) {
    const Vec2 way = way_of(pseudo);
    return Vec2{dot({ahead_.x, -ahead_.y}, way), dot({ahead_.y, ahead_.x}, way)} /
           std::sqrt(norm_squared(way));
  };
  for (int i = 0; i < count_; ++i)
    ends_[i] = {unit_way(items_[i].from), unit_way(items_[i].to), items_[i].to - items_[i].from >= 2};
  known_ends_ = count_;
}

/// v: from the centre to the disc's.
bool Horizon::may_cover(Vec2 v, double disc) const {
  if (known_ends_ == 0) return true;
  const double most = disc * disc;
  return std::any_of(ends_, ends_ + known_ends_, [&](const Ends& span) {
    return norm_squared(span.from * radius_ - v) <= most || norm_squared(span.to * radius_ - v) <= most ||
           span.holds(v);
  });
}

bool Horizon::may_cover(const SweptLine& line) const {
  if (known_ends_ == 0) return true;
  const Vec2 w = (center_ - line.from) * inverse_, left = left_of(line.along);
  const double along = dot(w, line.along), beside = cross(line.along, w), wide = line.radius * inverse_,
               length = line.length * inverse_;
  return !std::all_of(ends_, ends_ + known_ends_, [&](const Ends& span) {
    return span.is_beyond(left, wide - beside) || span.is_beyond(-left, wide + beside) ||
           span.is_beyond(-line.along, along) || span.is_beyond(line.along, length - along);
  });
}

bool Horizon::may_cover(const SweptArc& arc) const {
  if (known_ends_ == 0) return true;
  const Vec2 w = center_ - arc.center;
  const double outer = arc.ring + arc.radius, inner = std::max(0.0, arc.ring - arc.radius);
  const double before = -dot(arc.before, w) * inverse_, after = -dot(arc.after, w) * inverse_;
  return !std::all_of(ends_, ends_ + known_ends_, [&](const Ends& span) {
    const double from = norm_squared(w + span.from * radius_), to = norm_squared(w + span.to * radius_);
    return (std::min(from, to) >= outer * outer && !span.holds(-w)) ||
           (std::max(from, to) <= inner * inner && !span.holds(w)) || span.is_beyond(arc.before, before) ||
           span.is_beyond(arc.after, after);
  });
}

AngleSet Horizon::angles() const {
  const auto angle = [](double pseudo) {
    const Vec2 way = way_of(pseudo);
    return std::atan2(way.y, way.x);
  };
  AngleInterval found[kCapacity];
  for (int i = 0; i < count_; ++i) found[i] = {angle(items_[i].from), angle(items_[i].to)};
  return AngleSet({found, static_cast<std::size_t>(count_)});
}

}  // namespace clearcut
