// The part of Tracer that cuts off the walls: arcs at the limit, one after the other, up to a wall.
#include <cmath>

#include "plan/adaptive/clearing/parameters.h"
#include "plan/adaptive/trace/tracer.h"

namespace clearcut::plan::adaptive {
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
