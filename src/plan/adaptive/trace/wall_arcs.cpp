#include "plan/adaptive/trace/wall_arcs.h"

#include <algorithm>
#include <cmath>

#include "plan/adaptive/clearing/arcs.h"
#include "plan/adaptive/clearing/parameters.h"

namespace clearcut::plan::adaptive {
namespace {

/// Shares of the tool radius: how long before the wall an arc that leads off it may begin, and the step
/// between the lengths tried.
constexpr double kLeastLead = 0.1;
constexpr double kMostLead = 2.5;
constexpr double kLeadStep = 0.05;
/// Crossings, in shares of the tool radius: how far they may leave the wall before the material that they are
/// for, and before the last departure; the distance between the places that are tried; what a cut costs
/// beside its length, for its link and its moves.
constexpr double kBeforeMaterial = 0.3;
constexpr double kFarthestAcross = 0.6;
constexpr double kAcrossPitch = 0.16;
constexpr double kCostOfCut = 1.1;
/// Factor from the curvature of an arc at the limit to the first guess for that of a crossing.
constexpr double kTighterAcross = 1.1;
/// Share of the tool radius. If the wall still touches material for this length, a cut that meets it goes on
/// along it.
constexpr double kShortWall = 0.2;
/// Cosine of the angle between heading and wall. A cut that meets a wall at a smaller angle goes on along it.
constexpr double kSlide = 0.5;
/// The last move to a wall ends this many times its distance farther on along the wall: 2 is an angle of 27
/// degrees.
constexpr double kMeetSlope = 2;

}  // namespace

/// The cutter state on the wall at s, with the heading turned by `kink` radians off the wall.
CutterState WallArcs::state_at(double s, double radius, double kink) const {
  const Wall& wall = walls_.wall(at_.wall);
  return {wall.at(s), rotated(wall.heading(s), kink),
          1 / radius, limit_ - kink,
          radius,     std::min(radius, RadiusShares::kWidestTurn * radius_),
          kink};
}

/// The arc aimed off the wall at s with the heading `kink` radians off the wall, up to the wall that it
/// meets.
std::optional<DepartureArc> WallArcs::departure_arc(double s, double radius, double kink) const {
  const CutterState from = state_at(s, radius, kink);
  const auto candidate = aimer_.find_candidate(from);
  if (!candidate || !aimer_.leaves_wall(from, *candidate)) return std::nullopt;
  return up_to_wall(s, from, *candidate);
}

/// The best single arc to another wall that leaves this wall where `off` does or before; nothing if a cut
/// would lose too much by it.
std::optional<DepartureArc> WallArcs::crossing_arc(const DepartureArc& off) const {
  if (off.arc.turn != Turn::kCounterClockwise) return std::nullopt;
  // Arcs that keep the limit for longer are tighter.
  double guess = kTighterAcross / off.arc.radius(), best_value = 0, best_s = 0;
  if (!aimer_.meets_wall(off.from, 1 / off.arc.radius())) return std::nullopt;
  std::optional<Crossing> best;
  const double first = std::max(material_s_ - kBeforeMaterial * radius_, off.s - kFarthestAcross * radius_);
  for (double s = off.s - kAcrossPitch * radius_; s > first; s -= kAcrossPitch * radius_) {
    const CutterState from = state_at(s, off.from.usual, 0);
    const auto crossing = aimer_.across(from, guess);
    if (!crossing || !aimer_.leaves_wall(from, crossing->candidate)) continue;
    guess = crossing->candidate.curvature;
    const double length = crossing->candidate.length,
                 value = (length - crossing->lost) / (length + kCostOfCut * radius_);
    if (value < best_value) break;
    if (!crossing->loses_little()) continue;
    best = crossing;
    best_value = value;
    best_s = s;
  }
  if (!best) return std::nullopt;
  const CutterState from = state_at(best_s, off.from.usual, 0);
  const auto candidate = aimer_.surely_within(from, best->candidate);
  return candidate ? std::optional(up_to_wall(best_s, from, *candidate)) : std::nullopt;
}

/// The candidate as a departure arc from s. If it meets another wall, or ends near one, and the cut can go on
/// along that, the arc is changed a little to end on it.
DepartureArc WallArcs::up_to_wall(double s, const CutterState& from, CandidateArc candidate) const {
  const double least = 2 * aimer_.length_off(from, candidate),
               beyond = candidate.length + RadiusShares::kEndsAtWall * radius_,
               inside = aimer_.length_inside(from, {candidate.curvature, beyond, candidate.kink});
  if (inside < beyond) candidate = {candidate.curvature, inside, candidate.kink, true};
  DepartureArc off{s, from, edge_of(from, candidate), least, std::nullopt};
  if (!candidate.meets_wall) return off;
  const auto landing = landing_of(from, candidate, candidate.length);
  if (!landing || !remaining_.is_legal(landing->arc)) return off;
  off.arc = landing->arc;
  off.met = landing->place;
  return off;
}

/// The last clear point on the arc's circle before it touches the wall at s; nothing if too much would stay
/// on the wall.
std::optional<Vec2> WallArcs::approach_point_before(double s, const Edge& arc) const {
  const double radius = arc.radius();
  const WallPlace material{at_.wall, std::min(material_s_, s)};
  const double follows = s - material.s, farthest = std::min(radius, kMostLead * radius_),
               stays = distance(arc.center, walls_.point(material)) - radius;
  if (follows > radius / 2 || stays > walls_.residual(material)) return std::nullopt;
  for (double lead = std::max(kLeastLead * radius_, follows / 2); lead < farthest;
       lead += kLeadStep * radius_) {
    const Vec2 approach_point = arc.center + rotated(arc.from - arc.center, -lead / radius);
    if (!remaining_.touches(approach_point, RemainingStock::kFree)) return approach_point;
  }
  return std::nullopt;
}

/// The candidate changed a little to end on the wall that it meets after `inside` mm; nothing if the cut
/// could not go on along that wall.
std::optional<Landing> WallArcs::landing_of(const CutterState& from, const CandidateArc& candidate,
                                            double inside) const {
  const auto [end, heading] = after(from, candidate, inside);
  WallPlace met = walls_.nearest(end);
  if (!leads_along(met, heading)) return std::nullopt;
  met.s += kMeetSlope * distance(end, walls_.point(met));
  // A cut that stands at that place already has no arc, and so no heading, to come there by.
  if (distance(from.point, walls_.point(met)) < kShortestMove) return std::nullopt;
  return Landing{arc_to(from, candidate.kink, walls_.point(met)), met};
}

/// Whether a cut that meets a wall with that heading goes on along it: the angle is small and the wall still
/// touches material.
bool WallArcs::leads_along(const WallPlace& met, Vec2 heading) const {
  if (dot(heading, walls_.wall(met.wall).heading(met.s)) < kSlide ||
      !walls_.touches_after({met.wall, met.s + kShortWall * radius_}, radius_))
    return false;
  return met.wall != at_.wall || met.s >= at_.s + RadiusShares::kLeastCut * radius_ ||
         met.s <= at_.s - radius_;
}

}  // namespace clearcut::plan::adaptive
