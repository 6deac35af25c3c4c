// The arcs on which a cut leaves a wall, crosses to another, or comes to lie along one.
#pragma once

#include <optional>

#include "plan/adaptive/trace/arc_aimer.h"
#include "plan/adaptive/trace/walls.h"

namespace clearcut::plan::adaptive {

/// An arc off a wall and the cutter state that it begins with. It is used if at least `least` mm of it can
/// be cut.
struct DepartureArc {
  double s = 0;  ///< mm along the wall
  CutterState from;
  Edge arc;
  double least = 0;
  std::optional<WallPlace> met;  ///< the place where the arc ends on a wall
};
/// An arc that ends on a wall at so small an angle that the cut goes on along the wall.
struct Landing {
  Edge arc;
  WallPlace place;
};

/// Finds arcs about one place on a wall. Changes nothing; keeps references to the stock, the walls and the aimer.
class WallArcs {
 public:
  /// `limit`: largest engagement, radians. `material_s`: mm along the wall of `at` to where the material begins.
  WallArcs(const RemainingStock& remaining, const Walls& walls, const ArcAimer& aimer, double limit,
           const WallPlace& at, double material_s)
      : remaining_(remaining),
        walls_(walls),
        aimer_(aimer),
        radius_(remaining.tool_radius()),
        limit_(limit),
        at_(at),
        material_s_(material_s) {}

  CutterState state_at(double s, double radius, double kink) const;
  std::optional<DepartureArc> departure_arc(double s, double radius, double kink) const;
  std::optional<DepartureArc> crossing_arc(const DepartureArc& off) const;
  std::optional<Vec2> approach_point_before(double s, const Edge& arc) const;
  std::optional<Landing> landing_of(const CutterState& from, const CandidateArc& candidate,
                                    double inside) const;

 private:
  DepartureArc up_to_wall(double s, const CutterState& from, CandidateArc candidate) const;
  bool leads_along(const WallPlace& met, Vec2 heading) const;

  const RemainingStock& remaining_;
  const Walls& walls_;
  const ArcAimer& aimer_;
  double radius_;
  double limit_;
  WallPlace at_;
  double material_s_;
};

}  // namespace clearcut::plan::adaptive
