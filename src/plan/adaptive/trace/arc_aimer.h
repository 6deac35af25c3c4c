// Arcs that keep the engagement at its limit: from where a cut is, the one that leads on.
#pragma once

#include <optional>

#include "plan/adaptive/remaining_stock.h"

namespace clearcut::plan::adaptive {

/// Radians by which arcs may exceed the limit.
inline constexpr double kAboveLimit = 0.025;
/// mm. Shorter moves are left out.
inline constexpr double kShortestMove = 1e-4;

/// Where a cut is, with the material on its right, and how it may go on.
struct CutterState {
  Vec2 point;
  Vec2 heading;
  double curvature = 0;            ///< 1 / mm, > 0 to the left
  double engagement = 0;           ///< radians, before the last move was cut
  double usual = 0;                ///< mm, length of the last arc
  double tightest = 1;             ///< mm, radius of the tightest turn to the left
  std::optional<double> off_wall;  ///< on a wall: radians by which it heads off it
};

/// An arc from a state on, by curvature and length.
struct CandidateArc {
  double curvature = 0;
  double length = 0;
  double kink = 0;  ///< radians to the left, before it
  bool meets_wall = false;
};

/// One arc up to a wall, below the limit where it has to be.
struct Crossing {
  CandidateArc candidate;
  double lost = 0;  ///< mm of a cut at the limit that would take what it leaves
  bool loses_little() const;
};

/// Where a candidate is after `length` mm.
struct Heading {
  Vec2 point;
  Vec2 heading;
};
Heading after(const CutterState& from, const CandidateArc& candidate, double length);
/// The candidate as a move; a line where it is flat.
Edge edge_of(const CutterState& from, const CandidateArc& candidate);
/// The arc to p that begins with the heading turned by `kink`; a line where that is flat.
Edge arc_to(const CutterState& from, double kink, Vec2 p);

/// Aims arcs.
class ArcAimer {
 public:
  /// `limit`: largest engagement, radians. Arcs stay inside `area`. The remaining stock is kept by reference.
  ArcAimer(const RemainingStock& remaining, const Regions& area, double limit);

  /// The longest arc that was found that keeps the engagement at the limit, up to the wall ahead.
  std::optional<CandidateArc> find_candidate(const CutterState& from) const;
  /// Where the engagement cannot be kept up, or jumps: a short one, looked at closely.
  std::optional<CandidateArc> find_candidate_closely(const CutterState& from, double guess) const;
  /// Instead of a candidate, and the ones after it: a single arc up to the wall ahead, if little is lost by that.
  std::optional<CandidateArc> to_wall(const CutterState& from, const CandidateArc& candidate) const;
  /// The flattest arc up to the wall ahead that keeps the limit all along. Looked for near a curvature of `guess` first.
  std::optional<Crossing> across(const CutterState& from, double guess) const;
  /// Such an arc, looked at closely; a little tighter where it has to be.
  std::optional<CandidateArc> surely_within(const CutterState& from, CandidateArc across) const;
  /// Whether an arc of that curvature meets a wall soon.
  bool meets_wall(const CutterState& from, double curvature) const;
  /// mm of the candidate inside the area for cuts; of one that heads off a wall, the way off it counts as inside.
  double length_inside(const CutterState& from, const CandidateArc& candidate) const;
  /// Whether a candidate from a wall on gets off it.
  bool leaves_wall(const CutterState& from, const CandidateArc& candidate) const;
  /// mm of such a candidate up to where it is well inside the area for cuts; 0 where it never is.
  double length_off(const CutterState& from, const CandidateArc& candidate) const;
  /// Radians that an arc of `radius` along a wall turns by up to there.
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
