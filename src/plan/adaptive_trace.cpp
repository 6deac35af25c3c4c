#include "plan/adaptive_trace.h"

#include <algorithm>
#include <cmath>

namespace clearcut {
namespace {

// In tool radii:
constexpr double kStep = 0.1;   // between looks along walls
constexpr double kLook = 0.4;   // between looks at an arc before it is taken
constexpr double kAside = 0.1;  // between looks at where an arc runs
constexpr double kFirst = 1.0;  // length of an arc that is tried first
constexpr double kShortestArc = 0.02;
constexpr double kLongestArc = 12;
constexpr double kAir = 0.3;          // length without contact that ends a cut
constexpr double kRightTurn = 1.0;    // tightest radius to the right
constexpr double kLeastCut = 0.05;    // length in contact below which a cut is none
constexpr double kLeastTurn = 0.02;   // tightest radius off a wall
constexpr double kOffWall = 0.005;    // off a wall, where cuts are traced
constexpr double kEnoughWall = 0.03;  // advance along a wall for which no tighter turn is looked for
constexpr double kBeforeStop = 0.9;   // a stop this far ahead is one that cuts end before
constexpr double kShortWall = 0.2;    // of wall that a cut ends before rather than follow
constexpr double kThick = 0.5;        // before a stop: thicker material is cut like elsewhere
constexpr double kLeastLead = 0.1;    // of an arc before it comes to the wall that it leads off, tried
constexpr double kMostLead = 1.5;
constexpr double kLeadStep = 0.05;  // at this pitch
constexpr double kRise = 0.5;       // length in which the contact comes back to its limit
// Radians:
constexpr double kAbove = 0.025;  // by which arcs may exceed the limit
constexpr double kBelow = 0.06;   // by which long arcs may stay below it
constexpr double kShortBelow = 2.0;
constexpr double kLongBelow = 0.01;
constexpr double kAimed = 0.006;     // contact this near to what was aimed at is good
constexpr double kTouch = 0.02;      // less contact is none
constexpr double kLeaveStep = 0.15;  // between looks at an arc off the wall
constexpr int kLeastLeave = 4;       // looks that it takes at least to leave one wall and meet another
constexpr double kLeaveTurn = 1.6;   // length of that look
constexpr double kMostTurn = 2.0;    // of one arc
/// Radians of an arc between looks at where it runs.
constexpr double kAsideTurn = 0.25;
/// Of the stretch of wall in which the last place to leave it is.
constexpr int kMostHalvings = 4;
/// mm. Shorter moves are left out.
constexpr double kShortest = 1e-4;
/// Cosine between the direction of travel and a wall met, above which the cut goes on along the wall.
constexpr double kSlide = 0.5;
constexpr int kMostArcs = 20000;
constexpr int kCloseLooks = 8;
/// Radians. Kinks between arcs: with 500 mm/s2 and a junction deviation of 0.01 mm no brake up to 2500 mm/min.
constexpr double kMostKink = 0.15;
/// Radians below the limit from where arcs rise to it without a kink; and corrections until one is aimed.
constexpr double kMostRise = 0.1;
constexpr int kMostBends = 5;
/// Radians above the limit that they are aimed at: they swing about it.
constexpr double kBent = 0.008;
/// Share of its length that an arc aimed at a wall may turn out longer.
constexpr double kToWall = 0.2;
/// Length along a wall met over the distance from it.
constexpr double kMeetSlope = 8;
/// Changes between wall and open without cutting, after which a cut ends.
constexpr int kMostIdle = 4;

/// u turned by the angle of the direction v.
Vec2 turned(Vec2 u, Vec2 v) {
  return {u.x * v.x - u.y * v.y, u.x * v.y + u.y * v.x};
}

}  // namespace

Tracer::Tracer(Ground& ground, const Walls& walls, const Regions& area, double limit, AlongWalls along)
    : ground_(ground),
      walls_(walls),
      area_(area),
      radius_(ground.tool_radius()),
      limit_(limit),
      along_(along),
      step_(kStep * radius_) {}

Path Tracer::cut_from(const WallPlace& start, double material_s, const CanBegin& can_begin) {
  path_.clear();
  engaged_ = 0;
  place_ = start;
  material_s_ = material_s;
  can_begin_ = can_begin;
  first_departure_ = -1e300;
  return run(Next::kWall);
}

Path Tracer::cut_on(Vec2 from, Vec2 heading, double curvature) {
  path_.clear();
  engaged_ = 0;
  can_begin_ = {};
  state_ = {from, heading, curvature};
  tightest_ = radius_ / 2;
  contact_ = 0;
  return run(Next::kTrace);
}

Path Tracer::run(Next next) {
  int idle = 0;
  before_wall_ = {0, ground_.cuts()};
  while (next != Next::kDone && idle < kMostIdle) {
    const double before = engaged_;
    const std::size_t moves = path_.size();
    const bool on_wall = next == Next::kWall;
    next = on_wall ? follow_wall() : trace();
    idle = engaged_ > before + kLeastCut * radius_ ? 0 : idle + 1;
    if (on_wall && next == Next::kDone && path_.size() == moves) drop_way_to_wall();
  }
  if (path_.empty() && engaged_ < kLeastCut * radius_) return {};
  return path_;
}

/// The way to a wall that nothing was cut on.
void Tracer::drop_way_to_wall() {
  path_.resize(before_wall_.moves);
  ground_.forget_beyond(before_wall_.cuts);
}

double Tracer::wall_contact(double s) const {
  const Wall& wall = walls_.wall(place_.wall);
  return ground_.contact(wall.at(s), wall.heading(s));
}

Tracer::Next Tracer::follow_wall() {
  const Wall& wall = walls_.wall(place_.wall);
  const double first = place_.s;
  double s = first, cut_until = std::max(first, material_s_);
  while (s - first < wall.length() * 0.999) {
    const double end = wall.edge_end(s), next = std::min(s + step_, std::max(s + step_ / 3, end));
    // The heading may change where an edge ends.
    const double before = wall_contact(next - 1e-7),
                 contact = next < end ? before : std::max(before, wall_contact(next + 1e-7));
    if (contact > limit_ && walls_.to_stop({place_.wall, s}) < kBeforeStop * radius_ &&
        !ground_.touches(wall.at(next), kThick * radius_))
      break;
    if (contact > limit_) return depart(s, next);
    if (contact > kTouch) engaged_ += next - s;
    if (ground_.touches(wall.at(next), walls_.film({place_.wall, next}))) {
      cut_until = next;
    } else if (next - cut_until > along_.air) {
      break;
    }
    s = next;
  }
  append_wall(first, std::min(s, cut_until + along_.overrun));
  return Next::kDone;
}

/// Off the wall before `s_over`, as late and as gently as the contact allows.
Tracer::Next Tracer::depart(double s_clear, double s_over) {
  const double first = place_.s;
  const double natural = radius_ * (1 + std::cos(limit_)) / 2;
  double best = first, best_radius = 0;
  for (double radius = natural; radius > kLeastTurn * radius_; radius *= 0.6) {
    const double s = latest_departure(s_clear, s_over, radius, best);
    if (s <= best) continue;
    best = s;
    best_radius = radius;
    if (best - first > kEnoughWall * radius_) break;
  }
  if (best_radius > 0) {
    return leave(best, best_radius) ? Next::kTrace : Next::kDone;
  }
  append_wall(first, s_clear);
  return Next::kDone;
}

/// The last place up to `s_over` from which an arc of `radius` leaves the wall within the limit; -infinity
/// when there is none after `least`.
double Tracer::latest_departure(double s_clear, double s_over, double radius, double least) {
  double good = s_over, bad = s_over;
  while (!can_leave(good, radius)) {
    bad = good;
    good = good == s_over && s_clear > place_.s ? s_clear : good - step_ / 2;
    if (good <= least) return -1e300;
  }
  for (int i = 0; i < kMostHalvings && good < bad; ++i) {
    const double middle = (good + bad) / 2;
    (can_leave(middle, radius) ? good : bad) = middle;
  }
  return good;
}

/// Whether an arc to the left off the wall keeps the limit for a quarter turn, or until it meets a wall.
bool Tracer::can_leave(double s, double radius) {
  const Wall& wall = walls_.wall(place_.wall);
  const Vec2 from = wall.at(s), heading = wall.heading(s);
  const Vec2 center = from + left_of(heading) * radius;
  const double off = off_wall(radius);
  for (const double share : {0.15, 0.5, 1.0}) {
    if (!ground_.legal().contains(center + rotated(from - center, share * off))) return false;
  }
  const auto at = [&](int look) { return center + rotated(from - center, look * kLeaveStep); };
  int looks = 0;
  while (looks * kLeaveStep < kLeaveTurn && (looks * kLeaveStep <= off || area_.contains(at(looks)))) ++looks;
  if (looks <= kLeastLeave) return false;
  const auto exceeds = [&](int look) {
    return ground_.contact(at(look), rotated(heading, look * kLeaveStep)) > limit_;
  };
  // Where the last one failed the next one mostly fails, too.
  if (critical_look_ < looks && exceeds(critical_look_)) return false;
  for (int look = 0; look < looks; ++look) {
    if (look == critical_look_ || !exceeds(look)) continue;
    critical_look_ = look;
    return false;
  }
  const Edge first = Edge::arc(from, center + rotated(from - center, off), center, Turn::kCounterClockwise);
  return ground_.length_within(first, limit_ + kAbove) >= first.length();
}

/// Angle of an arc off a wall up to where it is well inside the area for cuts.
double Tracer::off_wall(double radius) const {
  return std::acos(std::clamp(1 - kOffWall * radius_ / radius, 0.3, 1.0));
}

bool Tracer::leave(double s, double radius) {
  const double first = place_.s;
  place_.s = s;
  if (first_departure_ < -1e299) first_departure_ = s;
  if (path_.empty() && can_begin_) {
    const auto shot = set_off(s, radius);
    if (shot && leaves_wall(*shot) && begin_beside(edge_of(*shot), 2 * length_off(*shot))) return true;
  }
  if (!append_wall(first, s)) return false;
  const auto shot = set_off(s, radius);
  if (shot && leaves_wall(*shot)) {
    const double within = ground_.length_within(edge_of(*shot), limit_ + kAbove);
    if (within > 2 * length_off(*shot)) return go(*shot, within) > 0;
  }
  const auto [from, heading, curvature] = state_;
  const double turn = off_wall(radius);
  const Vec2 center = from + left_of(heading) * radius;
  state_ = {center + rotated(from - center, turn), rotated(heading, turn), 1 / radius};
  contact_ = ground_.contact(state_.point, state_.heading);
  return append(Edge::arc(from, state_.point, center, Turn::kCounterClockwise));
}

/// mm. Of an arc to the left off a wall, up to where it is well inside the area for cuts. Twice as much is to be taken.
double Tracer::length_off(const Shot& shot) const {
  return off_wall(1 / shot.curvature) / shot.curvature;
}

/// With the arc off the wall, begun before it comes to the wall. Whether at least so much of it was taken.
bool Tracer::begin_beside(const Edge& off, double least) {
  const auto gate = off.turn == Turn::kCounterClockwise ? gate_before(off) : std::nullopt;
  if (!gate || !ground_.is_legal(Edge::arc(*gate, off.from, off.center, off.turn))) return false;
  const Edge arc = Edge::arc(*gate, off.to, off.center, off.turn);
  const double length = arc.length(), lead = length - off.length();
  double within = ground_.length_within(arc, limit_ + kAbove);
  // Nothing leads on from a peak.
  if (within < length) within = std::min(within, ground_.length_within(arc, limit_ + kAbove / 2));
  if (within < lead + least || !can_begin_(*gate)) return false;
  const Edge part = within < length ? arc.part(0, within / length) : arc;
  state_ = {part.to, part.tangent_at(1), 1 / off.radius()};
  contact_ = ground_.contact(state_.point, state_.heading);  // before it is cut
  usual_ = within - lead;
  take(part);
  return true;
}

/// The arc aimed off the wall at s.
std::optional<Tracer::Shot> Tracer::set_off(double s, double radius) {
  const Wall& wall = walls_.wall(place_.wall);
  tightest_ = std::min(radius, radius_ / 2);
  usual_ = radius;
  state_ = {wall.at(s), wall.heading(s), 1 / radius};
  contact_ = limit_;
  on_wall_ = true;
  const auto shot = shoot();
  on_wall_ = false;
  return shot;
}

/// The last free place on its circle before the arc; none where more would stay on the wall than may.
std::optional<Vec2> Tracer::gate_before(const Edge& arc) const {
  const double radius = arc.radius();
  const WallPlace material{place_.wall, std::min(material_s_, place_.s)};
  const double follows = place_.s - material.s, farthest = std::min(radius, kMostLead * radius_),
               stays = distance(arc.center, walls_.point(material)) - radius;
  if (follows > radius / 2 || stays > walls_.film(material)) return std::nullopt;
  for (double lead = std::max(kLeastLead * radius_, follows / 2); lead < farthest;
       lead += kLeadStep * radius_) {
    const Vec2 gate = arc.center + rotated(arc.from - arc.center, -lead / radius);
    if (!ground_.touches(gate, Ground::kFree)) return gate;
  }
  return std::nullopt;
}

/// Whether an arc aimed from the wall on gets off it.
bool Tracer::leaves_wall(const Shot& shot) const {
  if (shot.curvature <= 0) return false;
  const double off = length_off(shot);
  if (off > shot.length / 2) return false;
  for (const double share : {0.15, 0.5, 1.0}) {
    if (!ground_.legal().contains(after(shot, share * off).point)) return false;
  }
  const int looks = static_cast<int>((shot.length - off) / (kAside * radius_)) + 1;
  for (int i = 0; i <= looks; ++i) {
    if (!area_.contains(after(shot, off + (shot.length - off) * i / looks).point)) return false;
  }
  return true;
}

/// Whether all of it was taken; what would exceed the limit is left out.
bool Tracer::append_wall(double s_from, double s_to) {
  if (s_to <= s_from) return true;
  if (path_.empty() && can_begin_ && !can_begin_(walls_.point({place_.wall, s_from}))) return false;
  for (const Edge& edge : walls_.wall(place_.wall).part(s_from, s_to)) {
    if (!append(edge)) return false;
  }
  return true;
}

bool Tracer::append(const Edge& edge) {
  const double length = distance(edge.from, edge.to) < kShortest ? 0 : edge.length();
  if (length <= 0) return true;
  const double within = ground_.length_within(edge, limit_ + kAbove);
  if (within < kShortest) return false;
  take(within < length ? edge.part(0, within / length) : edge);
  return within >= length;
}

void Tracer::take(Edge edge) {
  if (!path_.empty()) edge.from = path_.back().to;  // the same point to rounding
  ground_.cut(edge);
  path_.push_back(edge);
}

Tracer::State Tracer::after(const Shot& shot, double length) const {
  const double half = shot.curvature * length / 2, sine = std::sin(half);
  const double chord = std::abs(half) < 5e-10 ? length : 2 * sine / shot.curvature;
  // The heading turns by half of it up to the chord's, and by the other half from there.
  const Vec2 turn{std::cos(half), sine},
      begin = shot.kink == 0 ? state_.heading : rotated(state_.heading, shot.kink),
      middle = turned(begin, turn);
  return {state_.point + middle * chord, turned(middle, turn), shot.curvature};
}

double Tracer::contact_after(const Shot& shot, double length) const {
  const State state = after(shot, length);
  return ground_.contact(state.point, state.heading);
}

Edge Tracer::edge_of(const Shot& shot) const {
  const Vec2 to = after(shot, shot.length).point;
  const double radius = 1 / shot.curvature, sagitta = shot.length * shot.length * shot.curvature / 8;
  if (std::abs(sagitta) < kShortest) return Edge::line(state_.point, to);
  return Edge::arc(state_.point, to, state_.point + rotated(left_of(state_.heading), shot.kink) * radius,
                   radius > 0 ? Turn::kCounterClockwise : Turn::kClockwise);
}

/// The arc of this length at whose end, or at the worst of as many places as `looks`, the contact is at the limit, or
/// as near below as turns allow.
std::optional<Tracer::Shot> Tracer::aim(double length, double guess, int looks) const {
  const double rightmost = std::max(-1 / (kRightTurn * radius_), -kMostTurn / length);
  const double leftmost = std::min(1 / tightest_, kMostTurn / length);
  double right = rightmost, left = leftmost;  // too much contact, too little
  const double slope = length + length * length / (2 * radius_ * std::sin(limit_));
  Shot shot{std::clamp(guess, right, left), length};
  std::optional<Shot> best;
  for (int i = 0; i < 8; ++i) {
    double excess = contact_after(shot, length) - limit_;
    // Closer to each other where the arc begins.
    for (int k = 1; k < looks; ++k)
      excess = std::max(excess, contact_after(shot, length * k * k / (looks * looks)) - limit_);
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
std::optional<Tracer::Shot> Tracer::bend(Shot shot) const {
  if (contact_ < limit_ - kMostRise) return std::nullopt;
  const double whole = shot.length, half = whole / 2, q = 1 / (radius_ * std::sin(limit_));
  for (int i = 0; i < kMostBends; ++i) {
    const double at_half = contact_after(shot, half) - limit_ - kBent,
                 at_end = contact_after(shot, whole) - limit_ - kBent;
    if (std::max(std::abs(at_half), std::abs(at_end)) <= kAimed) return shot;
    // The contact falls by 1 per radian of heading and by q per mm to the left.
    const double a = 1 + q * half, b = half + q * half * half / 2, c = 1 + q * whole,
                 d = whole + q * whole * whole / 2;
    shot.kink += (at_half * d - at_end * b) / (a * d - b * c);
    shot.curvature += (at_end * a - at_half * c) / (a * d - b * c);
    if (std::abs(shot.kink) > kMostKink || shot.curvature > 1 / tightest_ ||
        shot.curvature < -1 / (kRightTurn * radius_) || std::abs(shot.curvature) * whole > kMostTurn)
      return std::nullopt;
  }
  return std::nullopt;
}

/// Whether the contact keeps to its limit all along, and does not stay far below.
bool Tracer::is_steady(const Shot& shot) const {
  const int looks = static_cast<int>(shot.length / (kLook * radius_)) + 2;
  double missing = 0;
  for (int i = 1; i <= looks; ++i) {
    const double contact = contact_after(shot, shot.length * i / (looks + 1));
    if (contact > limit_ + kAbove) return false;
    missing += std::max(0.0, limit_ - contact) * shot.length / looks;
  }
  const double rise = std::max(0.0, limit_ - contact_) * kRise * radius_;
  return missing <=
         kBelow * (std::min(shot.length, kShortBelow * radius_) + radius_) + kLongBelow * shot.length + rise;
}

/// The longest arc that was found, up to the wall ahead.
std::optional<Tracer::Shot> Tracer::shoot() const {
  std::optional<Shot> best;
  double good = 0, bad = 2 * kLongestArc * radius_;
  double length = std::clamp(usual_, kShortestArc * radius_, kFirst * radius_);
  double guess = state_.curvature;
  for (int i = 0; i < 12; ++i) {
    const auto shot = steady_shot(length, guess);
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
  return shoot_closely(guess);
}

/// The arc of this length, or up to the wall ahead, if it keeps the contact steady.
std::optional<Tracer::Shot> Tracer::steady_shot(double length, double guess) const {
  auto shot = aim(length, guess, 1);
  if (!shot) return std::nullopt;
  const double ahead = length_inside(*shot);
  const bool to_wall = ahead < length;
  if (to_wall) {
    if (ahead < kShortestArc * radius_) return Shot{shot->curvature, ahead, 0, true};
    shot = aim(ahead, shot->curvature, 1);
    if (!shot) return std::nullopt;
  }
  if (!is_steady(*shot)) shot = bend(*shot);
  if (!shot || !is_steady(*shot)) return std::nullopt;
  if (to_wall) {
    const double beyond = ahead * (1 + kToWall);
    shot->length = length_inside({shot->curvature, beyond, shot->kink});
    shot->meets_wall = shot->length < beyond;
    if (!shot->meets_wall) shot->length = ahead;
  }
  return shot;
}

/// Where the contact cannot be kept up, or jumps: short arcs, looked at closely.
std::optional<Tracer::Shot> Tracer::shoot_closely(double guess) const {
  for (const double share : {8, 2}) {
    if (const auto shot = aim(share * kShortestArc * radius_, guess, kCloseLooks)) return shot;
  }
  return std::nullopt;
}

/// Length of the arc inside the area for cuts.
double Tracer::length_inside(const Shot& shot) const {
  // As near to each other that no wall is passed: those that bend into the area do so by the cutter's radius at least.
  const double by_length = shot.length / (kAside * radius_),
               by_turn = std::abs(shot.curvature) * shot.length / kAsideTurn;
  const int looks = static_cast<int>(std::max(by_length, by_turn)) + 1;
  const double off = on_wall_ && shot.curvature > 0 ? length_off(shot) : 0;
  double inside = std::min(off, shot.length);
  for (int i = 1; i <= looks; ++i) {
    const double length = shot.length * i / looks;
    if (length <= off) continue;
    if (area_.contains(after(shot, length).point)) {
      inside = length;
      continue;
    }
    double outside = length;
    for (int k = 0; k < 25; ++k) {
      const double middle = (inside + outside) / 2;
      (area_.contains(after(shot, middle).point) ? inside : outside) = middle;
    }
    return inside;
  }
  return shot.length;
}

Tracer::Next Tracer::trace() {
  air_ = 0;
  for (int i = 0; i < kMostArcs; ++i) {
    const auto shot = shoot();
    if (!shot) return Next::kDone;
    const double inside = length_inside(*shot);
    if (inside < shot->length || shot->meets_wall) return meet_wall(*shot, inside);
    double gone = go(*shot);
    if (gone < kShortestArc * radius_ && gone < shot->length) {
      const auto closely = shoot_closely(shot->curvature);
      if (closely && length_inside(*closely) == closely->length) gone += go(*closely);
    }
    if (gone < kShortestArc * radius_ && gone < shot->length) return Next::kDone;
    if (contact_ > kTouch) {
      engaged_ += gone;
      air_ = 0;
    } else if ((air_ += gone) > kAir * radius_) {
      return Next::kDone;
    }
  }
  return Next::kDone;
}

/// Takes the arc up to where its contact is too high; the length taken.
double Tracer::go(const Shot& shot) {
  const Edge edge = edge_of(shot);
  return go(shot,
            distance(edge.from, edge.to) < kShortest ? 0 : ground_.length_within(edge, limit_ + kAbove));
}

/// The same where the contact is known to be within its limit for so long.
double Tracer::go(const Shot& shot, double within) {
  const Edge edge = edge_of(shot);
  // Nothing leads on from a peak.
  if (within < shot.length && contact_after(shot, within) > limit_ + kAbove)
    within = ground_.length_within(edge, limit_ + kAbove / 2);
  if (within < kShortest) return 0;
  contact_ = contact_after(shot, within);  // before it is cut
  take(within < shot.length ? edge.part(0, within / shot.length) : edge);
  state_ = after(shot, within);
  usual_ = within;
  return within;
}

/// Runs up to the wall where the arc leaves the area, and on along it where it is met at a small angle.
Tracer::Next Tracer::meet_wall(const Shot& shot, double inside) {
  if (inside > kShortest) {
    const double gone = go({shot.curvature, inside, shot.kink});
    if (gone < inside) return gone < kShortestArc * radius_ ? Next::kDone : Next::kTrace;
  }
  const Vec2 p = state_.point;
  WallPlace met;
  double nearest = 1e300;
  for (std::size_t w = 0; w < walls_.count(); ++w) {
    const auto hit = walls_.wall(w).nearest(p);
    if (hit.distance >= nearest) continue;
    nearest = hit.distance;
    met = {w, hit.s};
  }
  if (dot(state_.heading, walls_.wall(met.wall).heading(met.s)) < kSlide ||
      !walls_.touches_after({met.wall, met.s + kShortWall * radius_}, radius_))
    return Next::kDone;
  if (met.wall == place_.wall && met.s < place_.s + kLeastCut * radius_ && met.s > place_.s - radius_)
    return Next::kDone;
  met.s += kMeetSlope * nearest;
  const Vec2 to = walls_.wall(met.wall).at(met.s);
  before_wall_ = {path_.size(), ground_.cuts()};
  if (!ground_.legal().holds_line(p, to) || !append(Edge::line(p, to))) return Next::kDone;
  place_ = met;
  material_s_ = met.s;
  return Next::kWall;
}

}  // namespace clearcut
