#include "plan/adaptive/trace/arc_aimer.h"

#include <algorithm>
#include <cmath>

#include "plan/adaptive/trace/arcs.h"

namespace clearcut::plan::adaptive {
namespace {

// In tool radii:
constexpr double kLook = 0.4;   // between looks at an arc before it is taken
constexpr double kAside = 0.1;  // between looks at where an arc runs
constexpr double kFirst = 1.0;  // length of an arc that is tried first
constexpr double kShortestArc = 0.02;
constexpr double kLongestArc = 12;
constexpr double kRightTurn = 1.0;  // tightest radius to the right
constexpr double kOffWall = 0.005;  // off a wall, where cuts are traced
constexpr double kRise = 0.5;       // length in which the contact comes back to its limit
// Of arcs from wall to wall, in tool radii:
constexpr double kTightestAcross = 0.3;
constexpr double kLongestAcross = 3.5;
constexpr double kLookAcross = 0.3;  // between looks
// Radians:
constexpr double kBelow = 0.06;  // by which long arcs may stay below the limit
constexpr double kShortBelow = 2.0;
constexpr double kLongBelow = 0.01;
constexpr double kAimed = 0.006;        // contact this near to what was aimed at is good
constexpr double kMostTurn = 2.0;       // of one arc
constexpr double kAcrossAbove = 0.015;  // the limit, on arcs from wall to wall
constexpr double kAsideTurn = 0.25;     // of an arc between looks at where it runs
constexpr double kLargestOff = 1.27;    // off a wall
constexpr int kCloseLooks = 8;
constexpr double kFlatTurn = 5e-10;  // of half a stride that is straight
/// Factors between curvatures that are tried for an arc from wall to wall, and that are as good as the same; most tries, and most of
/// them after closer looks. Share of its length that it may lose.
constexpr double kOtherCurvature = 1.15;
constexpr double kCloseCurvature = 1.05;
constexpr int kMostAcross = 7;
constexpr int kMostTighter = 5;
constexpr double kMostLost = 0.11;
/// Radians. Kinks between arcs: with 500 mm/s2 and a junction deviation of 0.01 mm no brake up to 2500 mm/min.
constexpr double kMostKink = 0.15;
/// Radians below the limit from where arcs rise to it without a kink; and corrections until one is aimed.
constexpr double kMostRise = 0.1;
constexpr int kMostBends = 5;
/// Radians above the limit that they are aimed at: they swing about it.
constexpr double kBent = 0.008;
/// Share of its length that an arc aimed at a wall may turn out longer.
constexpr double kToWall = 0.2;

/// u turned by the angle of the direction v.
Vec2 turned(Vec2 u, Vec2 v) {
  return {u.x * v.x - u.y * v.y, u.x * v.y + u.y * v.x};
}

/// Along a shot, one look after the other: cheaper than each of its own.
class Strides {
 public:
  Strides(const Course& from, const Shot& shot, double stride)
      : at_{from.point, shot.kink == 0 ? from.heading : rotated(from.heading, shot.kink)} {
    const double half = shot.curvature * stride / 2;
    half_turn_ = {std::cos(half), std::sin(half)};
    chord_ = std::abs(half) < kFlatTurn ? stride : 2 * half_turn_.y / shot.curvature;
  }

  const Heading& next() {
    const Vec2 middle = turned(at_.heading, half_turn_);
    at_ = {at_.point + middle * chord_, turned(middle, half_turn_)};
    return at_;
  }

 private:
  Heading at_;
  Vec2 half_turn_;
  double chord_ = 0;
};

}  // namespace

Heading after(const Course& from, const Shot& shot, double length) {
  return Strides(from, shot, length).next();
}

Edge edge_of(const Course& from, const Shot& shot) {
  const Vec2 to = after(from, shot, shot.length).point;
  const double radius = 1 / shot.curvature, sagitta = shot.length * shot.length * shot.curvature / 8;
  if (std::abs(sagitta) < kShortestMove) return Edge::line(from.point, to);
  return Edge::arc(from.point, to, from.point + rotated(left_of(from.heading), shot.kink) * radius,
                   radius > 0 ? Turn::kCounterClockwise : Turn::kClockwise);
}

Edge arc_to(const Course& from, double kink, Vec2 p) {
  const Vec2 heading = rotated(from.heading, kink);
  // The sagitta is a quarter of how far p is aside of the heading.
  if (std::abs(cross(heading, p - from.point)) < 4 * kShortestMove) return Edge::line(from.point, p);
  return tangent_arc(from.point, heading, p);
}

ArcAimer::ArcAimer(const Ground& ground, const Regions& area, double limit)
    : ground_(ground), area_(area), radius_(ground.tool_radius()), limit_(limit) {}

double ArcAimer::contact_after(const Course& from, const Shot& shot, double length) const {
  return contact_at(after(from, shot, length));
}

double ArcAimer::contact_at(const Heading& at) const {
  return ground_.contact(at.point, at.heading);
}

std::optional<Shot> ArcAimer::shoot(const Course& from) const {
  std::optional<Shot> best;
  double good = 0, bad = 2 * kLongestArc * radius_;
  double length = std::clamp(from.usual, kShortestArc * radius_, kFirst * radius_);
  double guess = from.curvature;
  for (int i = 0; i < 12; ++i) {
    const auto shot = steady_shot(from, length, guess);
    if (shot) {
      best = shot;
      guess = shot->curvature;
      good = length;
    } else {
      bad = length;
    }
    if (bad < good * 1.4 || good >= kLongestArc * radius_ || (best && best->meets_wall)) break;
    length = good == 0 ? length / 2 : std::min(good * 2, std::sqrt(good * bad));
    if (length < kShortestArc * radius_) break;
  }
  if (best) return best;
  return shoot_closely(from, guess);
}

/// The arc of this length, or up to the wall ahead, if it keeps the contact steady.
std::optional<Shot> ArcAimer::steady_shot(const Course& from, double length, double guess) const {
  auto shot = aim(from, length, guess, 1);
  if (!shot) return std::nullopt;
  const double ahead = length_inside(from, *shot);
  const bool to_wall = ahead < length;
  if (to_wall) {
    if (ahead < kShortestArc * radius_) return Shot{shot->curvature, ahead, 0, true};
    shot = aim(from, ahead, shot->curvature, 1);
    if (!shot) return std::nullopt;
  }
  if (!is_steady(from, *shot)) shot = bend(from, *shot);
  if (!shot || !is_steady(from, *shot)) return std::nullopt;
  if (to_wall) {
    const double beyond = ahead * (1 + kToWall);
    shot->length = length_inside(from, {shot->curvature, beyond, shot->kink});
    shot->meets_wall = shot->length < beyond;
    if (!shot->meets_wall) shot->length = ahead;
  }
  return shot;
}

/// The arc of this length at whose end, or at the worst of as many places as `looks`, the contact is at the limit, or
/// as near below as turns allow.
std::optional<Shot> ArcAimer::aim(const Course& from, double length, double guess, int looks) const {
  const double rightmost = std::max(-1 / (kRightTurn * radius_), -kMostTurn / length);
  const double leftmost = std::min(1 / from.tightest, kMostTurn / length);
  double right = rightmost, left = leftmost;  // too much contact, too little
  const double slope = length + length * length / (2 * radius_ * std::sin(limit_));
  Shot shot{std::clamp(guess, right, left), length};
  std::optional<Shot> best;
  for (int i = 0; i < 8; ++i) {
    double excess = contact_after(from, shot, length) - limit_;
    // Closer to each other where the arc begins.
    for (int k = 1; k < looks; ++k)
      excess = std::max(excess, contact_after(from, shot, length * k * k / (looks * looks)) - limit_);
    if (excess <= kAimed) best = shot;
    if (std::abs(excess) <= kAimed) break;
    if (shot.curvature == (excess > 0 ? leftmost : rightmost)) break;
    (excess > 0 ? right : left) = shot.curvature;
    const double next = shot.curvature + excess / slope;
    if (next > right && next < left) {
      shot.curvature = next;
    } else if (excess > 0 ? left == leftmost : right == rightmost) {
      shot.curvature = excess > 0 ? left : right;
    } else {
      shot.curvature = (right + left) / 2;
    }
  }
  return best;
}

/// The shot with a kink before it, so that the contact is at the limit in its middle, too.
std::optional<Shot> ArcAimer::bend(const Course& from, Shot shot) const {
  if (from.contact < limit_ - kMostRise) return std::nullopt;
  const double whole = shot.length, half = whole / 2, q = 1 / (radius_ * std::sin(limit_));
  for (int i = 0; i < kMostBends; ++i) {
    const double at_half = contact_after(from, shot, half) - limit_ - kBent,
                 at_end = contact_after(from, shot, whole) - limit_ - kBent;
    if (std::max(std::abs(at_half), std::abs(at_end)) <= kAimed) return shot;
    // The contact falls by 1 per radian of heading and by q per mm to the left.
    const double a = 1 + q * half, b = half + q * half * half / 2, c = 1 + q * whole,
                 d = whole + q * whole * whole / 2;
    shot.kink += (at_half * d - at_end * b) / (a * d - b * c);
    shot.curvature += (at_end * a - at_half * c) / (a * d - b * c);
    if (std::abs(shot.kink) > kMostKink || shot.curvature > 1 / from.tightest ||
        shot.curvature < -1 / (kRightTurn * radius_) || std::abs(shot.curvature) * whole > kMostTurn)
      return std::nullopt;
  }
  return std::nullopt;
}

/// Whether the contact keeps to its limit all along, and does not stay far below.
bool ArcAimer::is_steady(const Course& from, const Shot& shot) const {
  const int looks = static_cast<int>(shot.length / (kLook * radius_)) + 2;
  double missing = 0;
  Strides strides(from, shot, shot.length / (looks + 1));
  for (int i = 1; i <= looks; ++i) {
    const double contact = contact_at(strides.next());
    if (contact > limit_ + kAboveLimit) return false;
    missing += std::max(0.0, limit_ - contact) * shot.length / looks;
  }
  const double rise = std::max(0.0, limit_ - from.contact) * kRise * radius_;
  return missing <=
         kBelow * (std::min(shot.length, kShortBelow * radius_) + radius_) + kLongBelow * shot.length + rise;
}

std::optional<Shot> ArcAimer::shoot_closely(const Course& from, double guess) const {
  for (const double share : {8, 2}) {
    if (const auto shot = aim(from, share * kShortestArc * radius_, guess, kCloseLooks)) return shot;
  }
  return std::nullopt;
}

std::optional<Crossing> ArcAimer::across(const Course& from, double guess) const {
  const double tightest = 1 / (kTightestAcross * radius_);
  std::optional<Crossing> best;
  double exceeding = 0, missing = tightest;
  double curvature = guess;
  for (int i = 0; i < kMostAcross && missing > exceeding * kCloseCurvature; ++i) {
    Crossing crossing;
    const Fit fit = cross(from, curvature, crossing);
    if (fit == Fit::kFits) best = crossing;
    (fit == Fit::kExceeds ? exceeding : missing) = curvature;
    if (exceeding == 0) {
      curvature /= kOtherCurvature;
    } else {
      curvature = best || missing < curvature * kOtherCurvature
                      ? (exceeding + missing) / 2
                      : std::min(tightest, curvature * kOtherCurvature);
    }
  }
  return best;
}

bool ArcAimer::meets_wall(const Course& from, double curvature) const {
  const double longest = kLongestAcross * radius_;
  return length_inside(from, {curvature, longest}) < longest;
}

/// How the arc of that curvature up to the wall ahead does, which is `crossing`.
ArcAimer::Fit ArcAimer::cross(const Course& from, double curvature, Crossing& crossing) const {
  const double longest = std::min(kLongestAcross * radius_, kMostTurn / curvature);
  Shot& shot = crossing.shot;
  shot = {curvature, length_inside(from, {curvature, longest}), 0, true};
  if (shot.length >= longest) return Fit::kMissesWall;
  const double full = 1 - std::cos(limit_);
  const int looks = static_cast<int>(shot.length / (kLookAcross * radius_)) + 3;
  Strides strides(from, shot, shot.length / looks);
  for (int i = 1; i < looks; ++i) {
    const double contact = contact_at(strides.next());
    if (contact > limit_ + kAcrossAbove) return Fit::kExceeds;
    crossing.lost += std::max(0.0, 1 - (1 - std::cos(contact)) / full) * shot.length / (looks - 1);
  }
  return Fit::kFits;
}

bool Crossing::loses_little() const {
  return lost <= kMostLost * shot.length;
}

std::optional<Shot> ArcAimer::to_wall(const Course& from, const Shot& shot) const {
  if (shot.meets_wall || shot.curvature <= 0 || !meets_wall(from, shot.curvature)) return std::nullopt;
  const auto crossing = across(from, shot.curvature);
  return crossing && crossing->loses_little() ? surely_within(from, crossing->shot) : std::nullopt;
}

std::optional<Shot> ArcAimer::surely_within(const Course& from, Shot across) const {
  for (int i = 0; i < kMostTighter; ++i) {
    const Edge edge = edge_of(from, across);
    if (ground_.length_within(edge, limit_ + kAboveLimit) >= edge.length()) return across;
    Crossing tighter;
    if (cross(from, across.curvature * kCloseCurvature, tighter) != Fit::kFits) return std::nullopt;
    across = tighter.shot;
  }
  return std::nullopt;
}

double ArcAimer::length_inside(const Course& from, const Shot& shot) const {
  // As near to each other that no wall is passed: those that bend into the area do so by the cutter's radius at least.
  const double by_length = shot.length / (kAside * radius_),
               by_turn = std::abs(shot.curvature) * shot.length / kAsideTurn;
  const int looks = static_cast<int>(std::max(by_length, by_turn)) + 1;
  const double off = length_off(from, shot);
  double inside = std::min(off, shot.length);
  Strides strides(from, shot, shot.length / looks);
  for (int i = 1; i <= looks; ++i) {
    const double length = shot.length * i / looks;
    const Vec2 p = strides.next().point;
    if (length <= off) continue;
    if (area_.contains(p)) {
      inside = length;
      continue;
    }
    double outside = length;
    for (int k = 0; k < 25; ++k) {
      const double middle = (inside + outside) / 2;
      (area_.contains(after(from, shot, middle).point) ? inside : outside) = middle;
    }
    return inside;
  }
  return shot.length;
}

bool ArcAimer::leaves_wall(const Course& from, const Shot& shot) const {
  const double off = length_off(from, shot);
  if (off <= 0 || off > shot.length / 2) return false;
  for (const double share : {0.15, 0.5, 1.0}) {
    if (!ground_.legal().contains(after(from, shot, share * off).point)) return false;
  }
  const int looks = static_cast<int>((shot.length - off) / (kAside * radius_)) + 1;
  for (int i = 0; i <= looks; ++i) {
    if (!area_.contains(after(from, shot, off + (shot.length - off) * i / looks).point)) return false;
  }
  return true;
}

double ArcAimer::length_off(const Course& from, const Shot& shot) const {
  if (!from.off_wall) return 0;
  // Over a length x it comes off by x slope + x^2 curvature / 2.
  const double slope = std::sin(*from.off_wall + shot.kink), aside = kOffWall * radius_,
               root = slope * slope + 2 * shot.curvature * aside;
  const double rate = root < 0 ? 0 : slope + std::sqrt(root);
  return rate > 0 ? 2 * aside / rate : 0;
}

double ArcAimer::turn_off(double radius) const {
  return std::min(kLargestOff, std::acos(std::max(-1.0, 1 - kOffWall * radius_ / radius)));
}

}  // namespace clearcut::plan::adaptive
