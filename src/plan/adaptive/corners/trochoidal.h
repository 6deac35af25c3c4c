// Trochoidal steps: cuts what is left in narrow ends, where no single arc keeps the engagement limit.
#pragma once

#include "plan/adaptive/remaining_stock.h"
#include "plan/adaptive/trace/walls.h"

namespace clearcut::plan::adaptive {

/// Computes trochoidal steps along one wall. What is cut is on the left of the direction of travel.
///
/// Where the area is much narrower than the cutter, what counts is not how much stands there but how the hull of the
/// centres visited so far is left: the engagement is the angle between the heading and the tangent to that hull. At a
/// constant angle the centre runs on a logarithmic spiral about the last centre on the opposite wall, and meets that
/// wall a share of the width farther on: the share is exp(-turn / tan(limit)), so a trochoidal step is possible at any limit.
class TrochoidalSteps {
 public:
  TrochoidalSteps(const RemainingStock& remaining, const Wall& wall, double limit)
      : remaining_(remaining), wall_(wall), radius_(remaining.tool_radius()), limit_(limit) {}

  /// From the wall at s, where the cutter touches nothing: along the wall until the engagement would exceed the limit, on
  /// with the engagement at the limit, along the wall again where it is met, until nothing is cut any more or the wall's
  /// place `until` is reached. Empty where nothing can be cut.
  /// Cost: steps turn by at most kTurn; some 10 queries for the engagement each.
  Path trochoidal_step(double s, double until);
  /// The same from beside the wall, over its place s: first towards the wall with the engagement at the limit, at last along
  /// it as far as anything is cut.
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
  double s_ = 0;      ///< mm along the wall: where the cutter is, or was last
  double until_ = 0;  ///< mm along the wall: where the step ends at the latest
  State state_;
  double step_ = 0;
  double air_ = 0;      ///< mm since the cutter last engaged
  double engaged_ = 0;  ///< mm of the step in which the cutter engaged
  std::vector<Vec2> run_;
  Path path_;
};

}  // namespace clearcut::plan::adaptive
