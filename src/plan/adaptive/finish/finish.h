// The last steps of adaptive clearing: residuals on walls, corners, narrow ends, and rests that no cut has reached.
#pragma once

#include <optional>
#include <vector>

#include "plan/adaptive/clearing/clearing_path.h"
#include "plan/adaptive/finish/corners.h"
#include "plan/adaptive/trace/wall_cuts.h"
#include "plan/common/cover.h"

namespace clearcut::plan::adaptive {

/// What is to be finished. References are kept.
struct FinishTask {
  const Region& legal;  ///< where the centre may be
  const Regions& area;  ///< the somewhat smaller area for cuts off the walls
  const Regions& target;
  double limit = 0;         ///< radians; of the engagement
  double floor_radius = 0;  ///< mm; of the cutter's end on the floor, without the rounding of its corners
  const MachineClock& clock;
};

/// Cuts what clearing has left in one connected legal area, until nothing stays that the cutter can reach.
class AdaptiveFinish {
 public:
  AdaptiveFinish(RemainingStock& remaining, ClearingPath& path, const FinishTask& task);

  /// Runs all steps in this order: along walls within the limit; round corners; trochoidal steps where
  /// material still stands along walls; arcs in place of kinks; the rests that the exact check of the cover finds. `open`: the target
  /// has open sides. Cuts up to `most_rests` rests one by one; false if more were left. `pictures` get one for each step.
  bool run(bool open, int most_rests, StepPictures& pictures);
  /// One cut that begins at a clear place beside the material and ends at a wall or in the open; see
  /// Tracer::cut_on.
  Path cut_on(Vec2 from, Vec2 heading) { return cuts_.tracer.cut_on(from, heading, 0); }

 private:
  void follow_walls();
  void go_on_round_corners();
  void cut_without_stop(const Corner& corner, double from);
  double ahead(const Corner& corner) const;
  std::vector<Corner>::iterator nearest_corner();
  std::optional<WallPlace> finish_corner(const Corner& corner, double from);
  void cut_walls();
  void cut_wall_ends();
  bool stands_at(Vec2 corner) const;
  std::vector<WallStretch> unfinished() const;
  std::vector<WallStretch>::const_iterator nearest_stretch(const std::vector<WallStretch>& stretches) const;
  bool cut_in_trochoidal_steps(const WallStretch& stretch);
  bool trochoidal_step_from_aside(const WallPlace& place);
  bool trochoidal_step_from_aside(const WallStretch& stretch);
  std::optional<LinkPath> link_to_trochoidal_step(const WallStretch& stretch);
  void cut_stretch(const WallStretch& place);
  bool cut_rests(bool open, int most);
  std::vector<Vec2> rests(bool open) const;
  void add_holes_at_border(const Cover& cover, std::vector<Vec2>& holes) const;
  bool is_reachable(Vec2 p) const;
  bool is_within_reach(Vec2 p, double reach) const;
  Vec2 nearest_legal(Vec2 p) const;
  bool cut_rest(Vec2 p);
  template <typename Cut>
  bool from_approach_points_about(Vec2 p, const Cut& cut);
  bool cut_straight(Vec2 approach_point, Vec2 p, double limit, const LinkPath& link);
  bool cut_round(Vec2 approach_point, Vec2 p, const LinkPath& link);
  bool enter_rest(Vec2 p);

  RemainingStock& remaining_;
  ClearingPath& path_;
  const Region& legal_;
  const Regions& target_;
  double radius_;
  double floor_radius_;
  double limit_;
  const MachineClock& clock_;
  WallCuts cuts_;
  std::vector<Corner> all_corners_;
  std::vector<Corner> corners_;  ///< those not yet cut
};

}  // namespace clearcut::plan::adaptive
