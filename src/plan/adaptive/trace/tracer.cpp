#include "plan/adaptive/trace/tracer.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "plan/adaptive/clearing/arcs.h"
#include "plan/adaptive/clearing/parameters.h"

namespace clearcut::plan::adaptive {
namespace {

/// Share of the tool radius: the tightest radius with which a cut leaves a wall.
constexpr double kLeastTurn = 0.02;
/// Share of the tool radius: after this much advance along the wall no tighter departure is searched for.
constexpr double kEnoughWall = 0.03;
/// Share of the tool radius along a wall. A departure is moved back by up to this to the end of an edge,
/// which saves a move.
constexpr double kNoMove = 0.02;
/// Share of the tool radius. Before a stop (a corner), material thicker than this is cut off the wall as
/// elsewhere.
constexpr double kThick = 0.5;
/// Shares of the tool radius: one line or arc may replace several edges of a wall if it stays within
/// kBentWall of it; it may be longer by the factor kMostDetour.
constexpr double kBentWall = 0.1;
constexpr double kMostDetour = 1.1;
/// Radians: turn between samples along an arc off the wall, and how far it is sampled, a quarter turn. An arc
/// that meets another wall within fewer than kLeastLeave samples is not used.
constexpr double kLeaveStep = 0.15;
constexpr double kLeaveTurn = 1.6;
constexpr int kLeastLeave = 4;
/// Number of bisections in the search for the last place to leave a wall.
constexpr int kMostHalvings = 4;
/// Number of changes between wall and open without cutting, after which a cut ends.
constexpr int kMostIdle = 4;
/// mm along a wall: stands for no place.
constexpr double kNoPlaceOnWall = -1e300;

/// One line or arc from the first edge's beginning to the last edge's end; an arc if the last edge is one,
/// with the same heading at its end.
Edge as_one(std::span<const Edge> edges) {
  const Vec2 from = edges.front().from, to = edges.back().to;
  if (!edges.back().is_arc()) return Edge::line(from, to);
  return tangent_arc(to, -edges.back().tangent_at(1), from).reversed();
}

}  // namespace

Tracer::Tracer(RemainingStock& remaining, const Walls& walls, const Regions& area, double limit,
               AlongWalls along)
    : remaining_(remaining),
      walls_(walls),
      aimer_(remaining, area, limit),
      radius_(remaining.tool_radius()),
      limit_(limit),
      along_(along),
      step_(RadiusShares::kWallPitch * radius_) {}

Path Tracer::cut_from(const WallPlace& start, double material_s, const CanBegin& can_begin) {
  path_.clear();
  engaged_ = 0;
  place_ = start;
  material_s_ = material_s;
  can_begin_ = can_begin;
  first_departure_ = kNoPlaceOnWall;
  return run(Next::kWall);
}

Path Tracer::cut_on(Vec2 from, Vec2 heading, double curvature) {
  path_.clear();
  engaged_ = 0;
  can_begin_ = {};
  state_.point = from;
  state_.heading = heading;
  state_.curvature = curvature;
  state_.engagement = 0;
  state_.tightest = RadiusShares::kWidestTurn * radius_;
  return run(Next::kTrace);
}

Path Tracer::run(Next next) {
  int idle = 0;
  before_wall_ = {0, remaining_.cuts()};
  while (next != Next::kDone && idle < kMostIdle) {
    const double before = engaged_;
    const std::size_t moves = path_.size();
    const bool on_wall = next == Next::kWall;
    next = on_wall ? follow_wall() : trace();
    idle = engaged_ > before + RadiusShares::kLeastCut * radius_ ? 0 : idle + 1;
    if (on_wall && next == Next::kDone && path_.size() == moves) forget_beyond(before_wall_);
  }
  if (path_.empty() && engaged_ < RadiusShares::kLeastCut * radius_) return {};
  return path_;
}

Tracer::Mark Tracer::mark() const {
  return {path_.size(), remaining_.cuts()};
}

void Tracer::forget_beyond(const Mark& mark) {
  path_.resize(mark.moves);
  remaining_.forget_beyond(mark.cuts);
}

double Tracer::wall_engagement(double s) const {
  const Wall& wall = walls_.wall(place_.wall);
  return remaining_.engagement(wall.at(s), wall.heading(s));
}

Tracer::Next Tracer::follow_wall() {
  const Wall& wall = walls_.wall(place_.wall);
  const double first = place_.s;
  double s = first, cut_until = std::max(first, material_s_);
  while (s - first < wall.length() * 0.999) {
    const double end = wall.edge_end(s), next = std::min(s + step_, std::max(s + step_ / 3, end));
    // The heading may change at the end of an edge, so both sides are computed.
    const double before = wall_engagement(next - 1e-7),
                 engagement = next < end ? before : std::max(before, wall_engagement(next + 1e-7));
    if (engagement > limit_ && walls_.to_stop({place_.wall, s}) < RadiusShares::kCornerReach * radius_ &&
        !remaining_.touches(wall.at(next), kThick * radius_))
      break;
    if (engagement > limit_) return depart(s, next);
    if (engagement > EngagementTolerance::kNone) engaged_ += next - s;
    if (remaining_.touches(wall.at(next), walls_.residual({place_.wall, next}))) {
      cut_until = next;
    } else if (next - cut_until > along_.air) {
      break;
    }
    s = next;
  }
  append_wall(first, std::min(s, end_of_cut(cut_until)));
  return Next::kDone;
}

/// mm along the wall where the cut ends: a little beyond the last place that touched material, but not just
/// beyond the end of an edge where nothing stands.
double Tracer::end_of_cut(double cut_until) const {
  const Wall& wall = walls_.wall(place_.wall);
  const double over = cut_until + along_.overrun, end = wall.edge_end(cut_until);
  if (end >= over) return over;
  const auto stands = [&](double s) {
    return remaining_.touches(wall.at(s), walls_.residual({place_.wall, s}));
  };
  return stands(end) || stands((end + over) / 2) || stands(over) ? over : end;
}

/// Leaves the wall between `s_clear`, where the engagement is within the limit, and `s_over`, where it is
/// not: as late, and with as wide a radius, as the limit allows.
Tracer::Next Tracer::depart(double s_clear, double s_over) {
  const double first = place_.s;
  s_over = last_within(s_clear, s_over);
  const double natural = radius_ * (1 + base::cos(limit_)) / 2;
  double best = first, best_radius = 0;
  for (double radius = natural; radius > kLeastTurn * radius_; radius *= kTighterTurn) {
    const double s = latest_departure(s_clear, s_over, radius, best);
    if (s <= best) continue;
    best = s;
    best_radius = radius;
    if (best - first > kEnoughWall * radius_) break;
  }
  // If an edge ends just before, the departure is moved there, which saves a move.
  const double end = walls_.wall(place_.wall).edge_end(best - kNoMove * radius_);
  if (end > first && end < best && can_leave(end, best_radius)) best = end;
  if (best_radius > 0) return leave(best, best_radius);
  append_wall(first, s_clear);
  return Next::kDone;
}

/// The last place between `s_clear` and `s_over` at which the engagement on the wall keeps the limit, by
/// bisection.
double Tracer::last_within(double s_clear, double s_over) const {
  if (wall_engagement(s_over) <= limit_ + EngagementTolerance::kExcess) return s_over;
  for (int i = 0; i < kMostHalvings; ++i) {
    const double middle = (s_clear + s_over) / 2;
    (wall_engagement(middle) <= limit_ + EngagementTolerance::kExcess ? s_clear : s_over) = middle;
  }
  return s_clear;
}

/// mm along the wall: the last place up to `s_over` from which an arc of `radius` mm leaves the wall within
/// the limit; kNoPlaceOnWall if there is none after `least`.
double Tracer::latest_departure(double s_clear, double s_over, double radius, double least) {
  double good = s_over, bad = s_over;
  while (!can_leave(good, radius)) {
    bad = good;
    good = good > s_clear && s_clear > place_.s ? s_clear : good - step_ / 2;
    if (good <= least) return kNoPlaceOnWall;
  }
  for (int i = 0; i < kMostHalvings && good < bad; ++i) {
    const double middle = (good + bad) / 2;
    (can_leave(middle, radius) ? good : bad) = middle;
  }
  return good;
}

/// Whether an arc of `radius` mm to the left off the wall at s keeps the limit for a quarter turn, or until
/// it meets a wall.
bool Tracer::can_leave(double s, double radius) {
  const Wall& wall = walls_.wall(place_.wall);
  const Vec2 from = wall.at(s), heading = wall.heading(s);
  const Vec2 center = from + left_of(heading) * radius;
  const double off = aimer_.turn_off(radius);
  for (const double share : {0.15, 0.5, 1.0}) {
    if (!remaining_.legal().contains(center + rotated(from - center, share * off))) return false;
  }
  const auto at = [&](int sample) { return center + rotated(from - center, sample * kLeaveStep); };
  int samples = 0;
  while (samples * kLeaveStep < kLeaveTurn && (samples * kLeaveStep <= off || aimer_.is_inside(at(samples))))
    ++samples;
  if (samples <= kLeastLeave) return false;
  const auto exceeds = [&](int sample) {
    return remaining_.engagement(at(sample), rotated(heading, sample * kLeaveStep)) > limit_;
  };
  // The sample at which the last arc failed is the likeliest to fail again.
  if (critical_sample_ < samples && exceeds(critical_sample_)) return false;
  for (int sample = 0; sample < samples; ++sample) {
    if (sample == critical_sample_ || !exceeds(sample)) continue;
    critical_sample_ = sample;
    return false;
  }
  const Edge first = Edge::arc(from, center + rotated(from - center, off), center, Turn::kCounterClockwise);
  return is_within(first);
}

/// Leaves the wall at s, from where an arc of `radius` mm keeps the limit: on an aimed arc, else on that arc.
Tracer::Next Tracer::leave(double s, double radius) {
  if (first_departure_ == kNoPlaceOnWall) first_departure_ = s;
  std::optional<DepartureArc> off;
  if (path_.empty() && can_begin_) {
    off = arcs().departure_arc(s, radius, 0);
    const auto across = off ? arcs().crossing_arc(*off) : std::nullopt;
    if (across && begin_beside(*across)) return on_from(*across);
    if (off && begin_beside(*off)) return on_from(*off);
  }
  if (!append_wall(place_.s, s)) return Next::kDone;
  place_.s = s;
  const double turn = aimer_.turn_off(radius);
  for (const double kink : {0.0, turn}) {
    if (!off) off = arcs().departure_arc(s, radius, kink);
    const double within = off ? length_within(off->arc) : 0;
    if (off && within > off->least) {
      state_ = off->from;
      go(off->arc, within);
      return on_from(*off);
    }
    off.reset();
  }
  const Wall& wall = walls_.wall(place_.wall);
  const Vec2 from = wall.at(s), heading = wall.heading(s), center = from + left_of(heading) * radius;
  state_ = arcs().state_at(s, radius, 0);
  state_.off_wall.reset();
  state_.point = center + rotated(from - center, turn);
  state_.heading = rotated(heading, turn);
  state_.engagement = remaining_.engagement(state_.point, state_.heading);
  return append(Edge::arc(from, state_.point, center, Turn::kCounterClockwise)) ? Next::kTrace : Next::kDone;
}

/// Begins the cut at an approach point on the circle of the arc, before the arc touches the wall. True if
/// enough of the arc was cut.
bool Tracer::begin_beside(const DepartureArc& off) {
  const Edge& from_wall = off.arc;
  if (from_wall.turn != Turn::kCounterClockwise) return false;
  const auto approach_point = arcs().approach_point_before(off.s, from_wall);
  if (!approach_point ||
      !remaining_.is_legal(Edge::arc(*approach_point, from_wall.from, from_wall.center, from_wall.turn)))
    return false;
  const Edge arc = Edge::arc(*approach_point, from_wall.to, from_wall.center, from_wall.turn);
  const double lead = arc.length() - from_wall.length();
  double within = remaining_.length_within(arc, limit_ + EngagementTolerance::kExcess);
  // A slightly shorter arc lets the next one be longer.
  if (within < arc.length())
    within = std::min(within, remaining_.length_within(arc, limit_ + EngagementTolerance::kExcess / 2));
  if (within < lead + off.least || !can_begin_(*approach_point)) return false;
  place_.s = off.s;
  state_ = off.from;
  go(arc, within);
  state_.usual -= lead;
  return true;
}

/// What follows an arc off a wall: the wall that it ends on, else more arcs.
Tracer::Next Tracer::on_from(const DepartureArc& off) {
  if (!off.met || path_.back().to != off.arc.to) return Next::kTrace;
  follow_from(*off.met);
  return Next::kWall;
}

void Tracer::follow_from(const WallPlace& place) {
  before_wall_ = mark();
  place_ = place;
  material_s_ = place.s;
}

/// Cuts along the wall from s_from to s_to, up to where the engagement would exceed the limit; several edges
/// are replaced by one move where possible. True if all of it was cut.
bool Tracer::append_wall(double s_from, double s_to) {
  if (s_to <= s_from) return true;
  if (path_.empty() && can_begin_ && !can_begin_(walls_.point({place_.wall, s_from}))) return false;
  const Path part = walls_.wall(place_.wall).part(s_from, s_to);
  std::span<const Edge> left = part;
  for (double s = s_from; !left.empty();) {
    // As many edges as one move can replace.
    std::size_t count = left.size();
    while (count > 1 && !append_as_one(left.first(count), s)) --count;
    if (count == 1 && !append(left.front())) return false;
    for (const Edge& edge : left.first(count)) s += edge.length();
    left = left.subspan(count);
  }
  return true;
}

/// Cuts along one line or arc instead of `part`, if what then stays on the wall from s_from on may stay.
bool Tracer::append_as_one(std::span<const Edge> part, double s_from) {
  const Edge one = as_one(part);
  double end = s_from;
  for (const Edge& edge : part) {
    if (distance(one, edge.to) > kBentWall * radius_) return false;
    end += edge.length();
  }
  if (one.length() > kMostDetour * (end - s_from)) return false;
  if (!remaining_.is_legal(one) || !is_within(one)) return false;
  const Mark before = mark();
  take(one);
  for (double s = s_from; s < end; s += step_) {
    const WallPlace place{place_.wall, s};
    if (!remaining_.touches(walls_.point(place), walls_.residual(place))) continue;
    forget_beyond(before);
    return false;
  }
  return true;
}

// The part of Tracer that cuts off the walls: arcs at the limit, one after the other, up to a wall.

namespace {

/// Share of the tool radius: arcs shorter than this are not made.
constexpr double kShortestOffWalls = 0.02;
/// Share of the tool radius: the smallest radius of turn that is tried where the engagement rises whatever
/// the cutter does.
constexpr double kTightest = 0.1;
/// Number of arcs after which a cut ends: a bound that no cut comes near to.
constexpr int kMostArcs = 20000;

}  // namespace

/// Cuts the edge up to where the engagement would exceed the limit. True if all of it was cut.
bool Tracer::append(const Edge& edge) {
  const double length = distance(edge.from, edge.to) < kShortestMove ? 0 : edge.length();
  if (length <= 0) return true;
  const double within = remaining_.length_within(edge, limit_ + EngagementTolerance::kExcess);
  if (within < kShortestMove) return false;
  take(within < length ? edge.part(0, within / length) : edge);
  return within >= length;
}

void Tracer::take(Edge edge) {
  if (!path_.empty()) edge.from = path_.back().to;  // equal up to rounding
  remaining_.cut(edge);
  path_.push_back(edge);
}

bool Tracer::is_within(const Edge& edge) const {
  return remaining_.length_within(edge, limit_ + EngagementTolerance::kExcess) >= edge.length();
}

/// mm of an edge up to where its engagement is too high. Where the engagement jumps there, less of the edge
/// is cut, because no arc could go on from a peak.
double Tracer::length_within(const Edge& edge) const {
  const double length = edge.length(),
               within = remaining_.length_within(edge, limit_ + EngagementTolerance::kExcess),
               t = within / length;
  if (within >= length ||
      remaining_.engagement(edge.at(t), edge.tangent_at(t)) <= limit_ + EngagementTolerance::kExcess)
    return within;
  return remaining_.length_within(edge, limit_ + EngagementTolerance::kExcess / 2);
}

/// Cuts the first `within` mm of the edge and updates the cutter state.
void Tracer::go(const Edge& edge, double within) {
  const Edge part = within < edge.length() ? edge.part(0, within / edge.length()) : edge;
  state_.point = part.to;
  state_.heading = part.tangent_at(1);
  state_.curvature = edge.is_arc() ? (edge.turn == Turn::kCounterClockwise ? 1 : -1) / edge.radius() : 0;
  state_.engagement =
      remaining_.engagement(state_.point, state_.heading);  // before the material there is removed
  state_.usual = within;
  state_.off_wall.reset();
  take(part);
}

/// Cuts the candidate up to where its engagement is too high. Returns the mm that were cut.
double Tracer::go(const CandidateArc& candidate) {
  const Edge edge = edge_of(state_, candidate);
  const double within = distance(edge.from, edge.to) < kShortestMove ? 0 : length_within(edge);
  if (within < kShortestMove) return 0;
  go(edge, within);
  return within;
}

Tracer::Next Tracer::trace() {
  air_ = 0;
  for (int i = 0; i < kMostArcs; ++i) {
    auto candidate = aimer_.find_candidate(state_);
    for (; !candidate && state_.tightest > kTightest * radius_; candidate = aimer_.find_candidate(state_))
      state_.tightest *= kTighterTurn;
    if (!candidate) return Next::kDone;
    if (const auto across = aimer_.to_wall(state_, *candidate)) candidate = across;
    const double beyond = candidate->length + RadiusShares::kEndsAtWall * radius_,
                 inside = aimer_.length_inside(state_, {candidate->curvature, beyond, candidate->kink});
    if (inside < beyond || candidate->meets_wall) return meet_wall(*candidate, inside);
    double gone = go(*candidate);
    if (gone < kShortestOffWalls * radius_ && gone < candidate->length) {
      const auto closely = aimer_.find_candidate_closely(state_, candidate->curvature);
      if (closely && aimer_.length_inside(state_, *closely) == closely->length) gone += go(*closely);
    }
    if (gone < kShortestOffWalls * radius_ && gone < candidate->length) return Next::kDone;
    if (state_.engagement > EngagementTolerance::kNone) {
      engaged_ += gone;
      air_ = 0;
    } else if ((air_ += gone) > RadiusShares::kAir * radius_) {
      return Next::kDone;
    }
  }
  return Next::kDone;
}

/// Goes to the wall where the candidate leaves the area, and goes on along it if it is met at a small angle.
Tracer::Next Tracer::meet_wall(const CandidateArc& candidate, double inside) {
  const auto landing = arcs().landing_of(state_, candidate, inside);
  if (landing && remaining_.is_legal(landing->arc) && is_within(landing->arc)) {
    take(landing->arc);
    follow_from(landing->place);
    return Next::kWall;
  }
  if (inside > kShortestMove) {
    const double gone = go({candidate.curvature, inside, candidate.kink});
    if (gone < inside) return gone < kShortestOffWalls * radius_ ? Next::kDone : Next::kTrace;
  }
  return landing && step_to_wall(landing->place) ? Next::kWall : Next::kDone;
}

/// Goes straight to a wall that the cut has come near to.
bool Tracer::step_to_wall(const WallPlace& place) {
  const Mark before = mark();
  const Edge line = Edge::line(state_.point, walls_.point(place));
  if (!remaining_.is_legal(line) || !append(line)) return false;
  follow_from(place);
  before_wall_ = before;
  return true;
}

}  // namespace clearcut::plan::adaptive
