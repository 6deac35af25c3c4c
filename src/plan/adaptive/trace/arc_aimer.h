// Finds the arc on which a cut goes on with the engagement at its limit.
#pragma once

#include <optional>

#include "plan/adaptive/clearing/remaining_stock.h"

namespace clearcut::plan::adaptive {

/// mm. Shorter moves are not made.
inline constexpr double kShortestMove = 1e-4;

/// Where the cutter is in a cut, with the material on its right, and what the next arc begins with.
struct CutterState {
  Vec2 point;
  Vec2 heading;
  double curvature = 0;   ///< of the last arc, 1 / mm; positive to the left
  double engagement = 0;  ///< at the end of the last arc, before that arc was cut; radians
  double usual = 0;       ///< mm, length of the last arc: a first guess for the next one
  double tightest = 1;    ///< mm, smallest radius of turns to the left that may be tried
  /// Radians between heading and wall, where the cutter is on a wall.
  std::optional<double> off_wall;
};

/// An arc that may be cut next, from a CutterState. Candidates are compared before any material is removed.
struct CandidateArc {
  double curvature = 0;     ///< 1 / mm; positive to the left
  double length = 0;        ///< mm
  double kink = 0;          ///< radians by which the heading turns to the left at the beginning of the arc
  bool meets_wall = false;  ///< whether it ends at a border of the area for cuts
};

/// A single arc from one wall to another. Its engagement is at or below the limit all along.
struct Crossing {
  CandidateArc candidate;
  double lost = 0;  ///< mm of a cut at the limit that would remove what this arc leaves standing
  /// Whether `lost` is small beside the length of the arc, so that the arc is worth cutting.
  bool loses_little() const;
};

/// A point of a path and the unit vector along which the path goes on.
struct Heading {
  Vec2 point;
  Vec2 heading;
};
/// Point and heading on a candidate, `length` mm after its beginning.
Heading after(const CutterState& from, const CandidateArc& candidate, double length);
/// The candidate as an edge: an arc, or a line if its curvature is next to zero.
Edge edge_of(const CutterState& from, const CandidateArc& candidate);
/// The arc to p that begins along the heading turned by `kink` radians to the left; a line if it is nearly
/// straight.
Edge arc_to(const CutterState& from, double kink, Vec2 p);

/// Finds curvature and length of candidates by computing the engagement at samples along them.
class ArcAimer {
 public:
  /// `limit`: the engagement that candidates shall have at their end, radians. `area`: where the centre may
  /// be while it cuts off the walls. `remaining` is kept by reference.
  ArcAimer(const RemainingStock& remaining, const Regions& area, double limit);

  /// The longest candidate found whose engagement ends at the limit and stays near it all along; it ends at
  /// the wall ahead at the latest. Nothing if no curvature does that.
  std::optional<CandidateArc> find_candidate(const CutterState& from) const;
  /// A short candidate of about the curvature `guess`, 1 / mm, with close samples: for places where the
  /// engagement falls or jumps so that find_candidate() finds none.
  std::optional<CandidateArc> find_candidate_closely(const CutterState& from, double guess) const;
  /// A single arc up to the wall ahead instead of `candidate` and those that would follow, if that leaves
  /// little standing.
  std::optional<CandidateArc> to_wall(const CutterState& from, const CandidateArc& candidate) const;
  /// The flattest arc up to the wall ahead that keeps the limit all along. Curvatures near `guess`, 1 / mm,
  /// are tried first.
  std::optional<Crossing> across(const CutterState& from, double guess) const;
  /// The crossing `across` checked at close samples and made a little tighter where needed; nothing if it
  /// exceeds the limit even so.
  std::optional<CandidateArc> surely_within(const CutterState& from, CandidateArc across) const;
  /// Whether an arc of that curvature, 1 / mm, meets a wall within the greatest length of a crossing.
  bool meets_wall(const CutterState& from, double curvature) const;
  /// mm of the candidate inside the area for cuts. Walls lie outside of that area: the beginning of a
  /// candidate that leaves a wall counts as inside.
  double length_inside(const CutterState& from, const CandidateArc& candidate) const;
  /// Whether a candidate that begins on a wall comes into the area for cuts.
  bool leaves_wall(const CutterState& from, const CandidateArc& candidate) const;
  /// mm of a candidate that begins on a wall up to where it is well inside the area for cuts; 0 if it never
  /// is.
  double length_off(const CutterState& from, const CandidateArc& candidate) const;
  /// Radians by which an arc of `radius` mm that begins along a straight wall has turned when it is well
  /// inside the area.
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
