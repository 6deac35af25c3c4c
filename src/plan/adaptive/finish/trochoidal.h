// Trochoidal steps: small cuts along a wall that clear narrow ends, where no single arc keeps the engagement
// limit.
#pragma once

#include "plan/adaptive/clearing/remaining_stock.h"
#include "plan/adaptive/trace/walls.h"

namespace clearcut::plan::adaptive {

/// Computes trochoidal steps along one wall. The material lies on the right of the direction of travel.
///
/// Where the area is much narrower than the cutter, the engagement depends on the convex hull of the centres
/// visited so far alone: it is the angle between the heading and the tangent to that hull. At a constant
/// angle the centre runs on a logarithmic spiral about the last centre on the opposite wall. It meets that
/// wall after exp(-turn / tan(limit)) of the width, so that a step is possible at any limit.
class TrochoidalSteps {
 public:
  TrochoidalSteps(const RemainingStock& remaining, const Wall& wall, double limit)
      : remaining_(remaining), wall_(wall), radius_(remaining.tool_radius()), limit_(limit) {}

  /// One step that begins on the wall at s, mm along it, where the cutter touches nothing. It goes along the
  /// wall until the engagement would exceed the limit, then off it with the engagement at the limit, and
  /// along the wall again where it meets it. It ends when nothing is cut any more or at the place `until` of
  /// the wall, mm. Empty if nothing can be cut. Cost: some 10 queries for the engagement for each move; a
  /// move turns by at most kTurn.
  Path trochoidal_step(double s, double until);
  /// One step that begins at a clear place beside the wall, opposite to its place s: first towards the wall
  /// with the engagement at the limit, then along the wall as far as anything is cut.
  Path trochoidal_step_from_aside(Vec2 approach_point, double s);

 private:
  struct State {
    Vec2 point;
    Vec2 heading;
  };
  enum class Next { kDone, kFree, kWall };

  void begin(double s, double until);
  Path run(Next next);
  Next along_wall();
  Next freely();
  bool turn_off();
  std::optional<double> step_turn(double step, double least, double most) const;
  State stepped(double step, double turn) const;
  Next meet_wall(Vec2 outside);
  bool counts_air(double step, double engagement);
  void take(Vec2 p);
  void end_run();
  double wall_engagement(double s) const;
  bool is_legal(Vec2 p) const { return remaining_.legal().contains(p); }

  const RemainingStock& remaining_;
  const Wall& wall_;
  double radius_;
  double limit_;
  double s_ = 0;      ///< mm along the wall: the cutter's place, or its last one before it left the wall
  double until_ = 0;  ///< mm along the wall: where the step ends at the latest
  State state_;
  double step_ = 0;
  double air_ = 0;      ///< mm since the cutter last cut anything
  double engaged_ = 0;  ///< mm of the step on which the cutter cut
  std::vector<Vec2> run_;
  Path path_;
};

}  // namespace clearcut::plan::adaptive
