#include "plan/adaptive_trace.h"

#include <algorithm>
#include <cmath>

namespace clearcut {
namespace {

// In tool radii:
constexpr double kStep = 0.1;         // of the traced curve
constexpr double kTolerance = 0.003;  // of the arcs fitted to it
constexpr double kCommit = 12;        // length that is taken from the ground at once
constexpr double kAir = 0.3;          // length without contact that ends a cut
constexpr double kRightTurn = 1.0;    // tightest radius to the right
constexpr double kUnbend = 0.25;      // most that a step takes from the curvature, times the radius
constexpr double kLeastCut = 0.05;    // length in contact below which a cut is none
constexpr double kLeastTurn = 0.02;   // tightest radius off a wall
constexpr double kOffWall = 0.005;    // off a wall, where cuts are traced
constexpr double kEnoughWall = 0.03;  // advance along a wall for which no tighter turn is looked for
// Radians:
constexpr double kSlack = 0.006;     // contact this far below the limit is at its limit
constexpr double kTouch = 0.02;      // less contact is none
constexpr double kLeaveStep = 0.15;  // between looks at an arc off the wall
constexpr double kLeaveTurn = 1.6;   // length of that look
/// mm. Shorter moves are left out.
constexpr double kShortest = 1e-4;
/// Cosine between the direction of travel and a wall met, above which the cut goes on along the wall.
constexpr double kSlide = 0.5;
constexpr int kMostSteps = 100000;
/// Length along a wall met over the distance from it.
constexpr double kMeetSlope = 8;
/// Changes between wall and open without cutting, after which a cut ends.
constexpr int kMostIdle = 4;

}  // namespace

Tracer::Tracer(Ground& ground, const Walls& walls, const Regions& area, double limit)
    : ground_(ground),
      walls_(walls),
      area_(area),
      radius_(ground.tool_radius()),
      limit_(limit),
      step_(kStep * radius_) {}

Path Tracer::cut_from(const WallPlace& start, double material_s) {
  path_.clear();
  points_.clear();
  run_ = engaged_ = 0;
  place_ = start;
  material_s_ = material_s;
  first_departure_ = -1e300;
  return run(Next::kWall);
}

Path Tracer::cut_on(Vec2 from, Vec2 heading, double curvature) {
  path_.clear();
  run_ = engaged_ = 0;
  state_ = {from, heading, curvature};
  tightest_ = radius_ / 2;
  points_ = {{from, heading}};
  return run(Next::kTrace);
}

Path Tracer::run(Next next) {
  int idle = 0;
  while (next != Next::kDone && idle < kMostIdle) {
    const double before = engaged_;
    next = next == Next::kWall ? follow_wall() : trace();
    idle = engaged_ > before + kLeastCut * radius_ ? 0 : idle + 1;
  }
  if (path_.empty() && engaged_ < kLeastCut * radius_) return {};
  commit();
  return path_;
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
    const double next = std::min(s + step_, std::max(s + step_ / 3, wall.edge_end(s)));
    const double contact = std::max(wall_contact(next - 1e-7), wall_contact(next + 1e-7));
    if (contact > limit_) return depart(s, next);
    if (contact > kTouch) engaged_ += next - s;
    if (ground_.touches(wall.at(next), walls_.film({place_.wall, next}))) {
      cut_until = next;
    } else if (next - cut_until > kAir * radius_) {
      break;
    }
    s = next;
  }
  append_wall(first, std::min(s, cut_until));
  return Next::kDone;
}

/// Off the wall before `s_over`, as late and as gently as the contact allows.
Tracer::Next Tracer::depart(double s_clear, double s_over) {
  const double first = place_.s;
  const double natural = radius_ * (1 + std::cos(limit_)) / 2;
  double best = first, best_radius = 0;
  for (double radius = natural; radius > kLeastTurn * radius_; radius *= 0.6) {
    const double s = latest_departure(s_clear, s_over, radius);
    if (s <= best) continue;
    best = s;
    best_radius = radius;
    if (best - first > kEnoughWall * radius_) break;
  }
  if (best_radius > 0) {
    leave(best, best_radius);
    return Next::kTrace;
  }
  append_wall(first, s_clear);
  return Next::kDone;
}

/// The last place up to `s_over` from which an arc of `radius` leaves the wall within the limit; -infinity
/// when there is none after the place where the cutter is.
double Tracer::latest_departure(double s_clear, double s_over, double radius) const {
  double good = s_over, bad = s_over;
  while (!can_leave(good, radius)) {
    bad = good;
    good = good == s_over && s_clear > place_.s ? s_clear : good - step_ / 2;
    if (good < place_.s) return -1e300;
  }
  for (int i = 0; i < 5 && good < bad; ++i) {
    const double middle = (good + bad) / 2;
    (can_leave(middle, radius) ? good : bad) = middle;
  }
  return good;
}

/// Whether an arc to the left off the wall keeps the limit for a quarter turn, or until it meets a wall.
bool Tracer::can_leave(double s, double radius) const {
  const Wall& wall = walls_.wall(place_.wall);
  const Vec2 from = wall.at(s), heading = wall.heading(s);
  const Vec2 center = from + left_of(heading) * radius;
  const double off = off_wall(radius);
  for (const double share : {0.15, 0.5, 1.0}) {
    if (!ground_.legal().contains(center + rotated(from - center, share * off))) return false;
  }
  for (double turn = 0; turn < kLeaveTurn; turn += kLeaveStep) {
    const Vec2 p = center + rotated(from - center, turn);
    if (turn > off && !area_.contains(p)) return turn > 4 * kLeaveStep;
    if (ground_.contact(p, rotated(heading, turn)) > limit_) return false;
  }
  return true;
}

/// Angle of an arc off a wall up to where it is well inside the area for cuts.
double Tracer::off_wall(double radius) const {
  return std::acos(std::clamp(1 - kOffWall * radius_ / radius, 0.3, 1.0));
}

void Tracer::leave(double s, double radius) {
  const Wall& wall = walls_.wall(place_.wall);
  append_wall(place_.s, s);
  const double turn = off_wall(radius);
  const Vec2 from = wall.at(s), center = from + left_of(wall.heading(s)) * radius;
  state_ = {center + rotated(from - center, turn), rotated(wall.heading(s), turn), 1 / radius};
  append(Edge::arc(from, state_.point, center, Turn::kCounterClockwise));
  place_.s = s;
  if (first_departure_ < -1e299) first_departure_ = s;
  tightest_ = std::min(radius, radius_ / 2);
  points_ = {{state_.point, state_.heading}};
}

void Tracer::append_wall(double s_from, double s_to) {
  if (s_to <= s_from) return;
  commit();
  for (const Edge& edge : walls_.wall(place_.wall).part(s_from, s_to)) append(edge);
}

void Tracer::append(Edge edge) {
  if (!path_.empty()) edge.from = path_.back().to;  // the same point to rounding
  if (distance(edge.from, edge.to) < kShortest) return;
  ground_.cut(edge);
  path_.push_back(edge);
}

Tracer::State Tracer::stepped(const State& from, double curvature, double length) const {
  const double turn = curvature * length;
  const double chord = std::abs(turn) < 1e-9 ? length : 2 * std::sin(turn / 2) / curvature;
  return {from.point + rotated(from.heading, turn / 2) * chord, rotated(from.heading, turn), curvature};
}

/// Contact above the limit after a step at this curvature.
double Tracer::excess(double curvature) const {
  const State next = stepped(state_, curvature, std::min(step_, tightest_ / 2));
  return ground_.contact(next.point, next.heading) - limit_;
}

/// The curvature with the contact at its limit, or just below.
double Tracer::solve_curvature() const {
  const double left = 1 / tightest_;
  const double right = std::max(-1 / (kRightTurn * radius_),
                                state_.curvature - std::max(kUnbend / radius_, state_.curvature / 2));
  const double length = std::min(step_, tightest_ / 2);
  double low = std::clamp(state_.curvature, right, left), at_low = excess(low);  // low: contact too high
  if (at_low <= 0 && at_low > -kSlack) return low;
  double high = low, at_high = at_low;
  for (int i = 0; i < 12 && at_low <= 0; ++i) {
    if (low <= right) return right;
    high = low;
    at_high = at_low;
    low = std::max(right, low + std::max(at_low, -0.5) / length - 0.02 / radius_);
    at_low = excess(low);
    if (at_low <= 0 && at_low > -kSlack) return low;
  }
  for (int i = 0; i < 12 && at_high > 0; ++i) {
    if (high >= left) return left;
    low = high;
    at_low = at_high;
    high = std::min(left, high + at_high / length + 0.02 / radius_);
    at_high = excess(high);
    if (at_high <= 0 && at_high > -kSlack) return high;
  }
  for (int i = 0; i < 12 && at_high <= -kSlack; ++i) {
    const double share = std::clamp((at_high + kSlack / 2) / (at_high - at_low), 0.1, 0.9);
    const double middle = high + (low - high) * share;
    const double at_middle = excess(middle);
    if (at_middle > 0) {
      low = middle;
      at_low = at_middle;
    } else {
      high = middle;
      at_high = at_middle;
    }
  }
  return high;
}

Tracer::Next Tracer::trace() {
  const double length = std::min(step_, tightest_ / 2);
  double air = 0;
  for (int i = 0; i < kMostSteps; ++i) {
    const State next = stepped(state_, solve_curvature(), length);
    if (!area_.contains(next.point)) return meet_wall(next);
    const double contact = ground_.contact(next.point, next.heading);
    if (contact > limit_ + kSlack) return Next::kDone;
    if (contact > kTouch) {
      engaged_ += length;
      air = 0;
    } else if ((air += length) > kAir * radius_) {
      const auto tail = static_cast<std::size_t>(air / length) - 1;
      points_.resize(points_.size() > tail + 1 ? points_.size() - tail : 1, points_.front());
      return Next::kDone;
    }
    state_ = next;
    add_point(next.point, next.heading);
  }
  return Next::kDone;
}

/// Runs up to the wall before `next`, and on along it where it is met at a small angle.
Tracer::Next Tracer::meet_wall(const State& next) {
  double inside = 0, outside = 1;
  for (int i = 0; i < 30; ++i) {
    const double middle = (inside + outside) / 2;
    (area_.contains(lerp(state_.point, next.point, middle)) ? inside : outside) = middle;
  }
  const Vec2 p = lerp(state_.point, next.point, inside);
  WallPlace met;
  double nearest = 1e300;
  for (std::size_t w = 0; w < walls_.count(); ++w) {
    const auto hit = walls_.wall(w).nearest(p);
    if (hit.distance >= nearest) continue;
    nearest = hit.distance;
    met = {w, hit.s};
  }
  if (distance(p, points_.back().point) > kShortest)
    add_point(p, rotated(state_.heading, next.curvature * inside * distance(state_.point, next.point)));
  if (dot(next.heading, walls_.wall(met.wall).heading(met.s)) < kSlide || !walls_.touches_after(met, radius_))
    return Next::kDone;
  if (met.wall == place_.wall && met.s < place_.s + kLeastCut * radius_ && met.s > place_.s - radius_)
    return Next::kDone;
  commit();
  met.s += kMeetSlope * nearest;
  append(Edge::line(p, walls_.wall(met.wall).at(met.s)));
  place_ = met;
  material_s_ = met.s;
  return Next::kWall;
}

void Tracer::add_point(Vec2 p, Vec2 heading) {
  run_ += distance(points_.back().point, p);
  points_.push_back({p, heading});
  if (run_ > kCommit * radius_) commit();
}

/// Whether the edge stays where the cutter may be.
bool Tracer::is_legal(const Edge& edge) const {
  for (const double t : {0.15, 0.3, 0.5, 0.7, 0.85}) {
    if (!ground_.legal().contains(edge.at(t))) return false;
  }
  return true;
}

/// Fits arcs to the points and takes away what they sweep. Where arcs would run into a wall: straight from
/// point to point.
void Tracer::commit() {
  if (points_.size() > 1) {
    const Path fitted = fit_biarcs(points_, kTolerance * radius_);
    if (std::all_of(fitted.begin(), fitted.end(), [&](const Edge& edge) { return is_legal(edge); })) {
      for (const Edge& edge : fitted) append(edge);
    } else {
      for (std::size_t i = 1; i < points_.size(); ++i)
        append(Edge::line(points_[i - 1].point, points_[i].point));
    }
    points_ = {points_.back()};
  }
  run_ = 0;
}

}  // namespace clearcut
