// Finds the arc on which a cut goes on with the engagement at its limit.
#pragma once

#include <optional>

#include "plan/adaptive/remaining_stock.h"

namespace clearcut::plan::adaptive {

/// mm. Shorter moves are left out.
inline constexpr double kShortestMove = 1e-4;

/// Where the cutter is in a cut that has the material on its right, and how the cut may go on.
struct CutterState {
  Vec2 point;
  Vec2 heading;
  double curvature = 0;   ///< 1 / mm, > 0 to the left
  double engagement = 0;  ///< radians at the end of the last move, before that move was cut
  double usual = 0;       ///< mm, length of the last arc: the next one is probably as long
  double tightest = 1;    ///< mm, radius of the tightest turn to the left that may be tried
  std::optional<double>
      off_wall;  ///< set where the cutter is on a wall: radians between its heading and the wall
};

/// An arc that may be cut next from a CutterState, tried before anything is taken away.
struct CandidateArc {
  double curvature = 0;     ///< 1 / mm, > 0 to the left
  double length = 0;        ///< mm
  double kink = 0;          ///< radians by which the heading turns to the left before the arc
  bool meets_wall = false;  ///< it ends at the border of the area for cuts
};

/// A single arc from one wall up to another, below the engagement limit where it cannot be at it.
struct Crossing {
  CandidateArc candidate;
  double lost = 0;  ///< mm of a cut at the limit that would take what the arc leaves standing
  bool loses_little() const;
};

/// Place and unit heading on a path.
struct Heading {
  Vec2 point;
  Vec2 heading;
};
/// Where a candidate is after `length` mm.
Heading after(const CutterState& from, const CandidateArc& candidate, double length);
/// The candidate as an edge; a line where its curvature is next to none.
Edge edge_of(const CutterState& from, const CandidateArc& candidate);
/// The arc to p that begins with the heading turned by `kink`; a line where that is flat.
Edge arc_to(const CutterState& from, double kink, Vec2 p);

/// Solves for the curvature and length of candidates by sampling the engagement along them.
class ArcAimer {
 public:
  /// `limit`: engagement in radians that arcs are aimed at. Arcs stay inside `area`, where the centre may run while it cuts off
  /// walls. The remaining stock is kept by reference.
  ArcAimer(const RemainingStock& remaining, const Regions& area, double limit);

  /// The longest arc found whose engagement ends at the limit and stays near it all along, at most up to the wall ahead;
  /// none where no curvature does that.
  std::optional<CandidateArc> find_candidate(const CutterState& from) const;
  /// For places where the engagement falls or jumps and find_candidate() fails: a short arc of about the curvature `guess`,
  /// sampled closely.
  std::optional<CandidateArc> find_candidate_closely(const CutterState& from, double guess) const;
  /// A single arc up to the wall ahead in the place of `candidate` and those after it, if little is lost by that.
  std::optional<CandidateArc> to_wall(const CutterState& from, const CandidateArc& candidate) const;
  /// The flattest arc up to the wall ahead that keeps the limit all along. Curvatures near `guess` (1 / mm) are tried first.
  std::optional<Crossing> across(const CutterState& from, double guess) const;
  /// The same arc after close sampling, a little tighter where it has to be; none where it exceeds the limit anyway.
  std::optional<CandidateArc> surely_within(const CutterState& from, CandidateArc across) const;
  /// Whether an arc of that curvature (1 / mm) meets a wall within the greatest length of arcs from wall to wall.
  bool meets_wall(const CutterState& from, double curvature) const;
  /// mm of the candidate inside the area for cuts. Where it begins on a wall, which lies outside of that area, its beginning
  /// counts as inside.
  double length_inside(const CutterState& from, const CandidateArc& candidate) const;
  /// Whether a candidate that begins on a wall gets into the area for cuts.
  bool leaves_wall(const CutterState& from, const CandidateArc& candidate) const;
  /// mm of such a candidate from the wall to where it is well inside the area for cuts; 0 where it never is.
  double length_off(const CutterState& from, const CandidateArc& candidate) const;
  /// Radians by which an arc of `radius` mm that begins along a straight wall turns up to there.
  double turn_off(double radius) const;
  bool is_inside(Vec2 p) const { return area_.contains(p); }

 private:
  enum class Fit { kExceeds, kFits, kMissesWall };
  Fit cross(const CutterState& from, double curvature, Crossing& crossing) const;
  double engagement_at(const Heading& at) const;
  double engagement_after(const CutterState& from, const CandidateArc& candidate, double length) const;
  std::optional<CandidateArc> steady_candidate(const CutterState& from, double length, double guess) const;
  std::optional<CandidateArc> aim(const CutterState& from, double length, double guess, int samples) const;
  std::optional<CandidateArc> bend(const CutterState& from, CandidateArc candidate) const;
  bool is_steady(const CutterState& from, const CandidateArc& candidate) const;

  const RemainingStock& remaining_;
  LegalArea area_;
  double radius_;
  double limit_;
};

}  // namespace clearcut::plan::adaptive
