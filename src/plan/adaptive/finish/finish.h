// What stays when an area is cleared: films on walls, corners, narrow ends, rests.
#pragma once

#include <optional>
#include <vector>

#include "plan/adaptive/corners/corners.h"
#include "plan/adaptive/trace/wall_cuts.h"
#include "plan/common/cover.h"

namespace clearcut::plan::adaptive {

/// The last stage of an adaptive pass: nothing that the cutter can reach stays.
class AdaptiveFinish {
 public:
  /// `legal`: where the centre may be; `area`: where cuts off the walls run, a little smaller. All is kept by reference.
  AdaptiveFinish(Ground& ground, ClearingPath& path, const Region& legal, const Regions& area,
                 const Regions& target, double limit);

  /// Along the walls within the limit, corners, by bites what walls still bear, what the check of the whole cover finds.
  /// `open`: something beside the target is free. Up to `most_rests` rests are cut one by one; false where that was not
  /// enough.
  bool run(bool open, int most_rests);
  /// One cut that begins beside the material and ends at a wall or in the open; see Tracer::cut_on.
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
  bool peel(const WallStretch& stretch);
  bool bite_from_aside(const WallPlace& place);
  bool bite_from_aside(const WallStretch& stretch);
  std::optional<Way> way_to_bite(const WallStretch& stretch);
  void cut_stretch(const WallStretch& place);
  bool cut_rests(bool open, int most);
  std::vector<Vec2> rests(const Cover& cover, bool open) const;
  void add_holes_at_border(const Cover& cover, std::vector<Vec2>& holes) const;
  bool is_reachable(Vec2 p) const;
  bool is_within_reach(Vec2 p, double reach) const;
  Vec2 nearest_legal(Vec2 p) const;
  bool cut_rest(Vec2 p);
  template <typename Cut>
  bool from_gates_about(Vec2 p, const Cut& cut);
  bool cut_straight(Vec2 gate, Vec2 p, double limit, const Way& way);
  bool cut_round(Vec2 gate, Vec2 p, const Way& way);
  bool enter_rest(Vec2 p);

  Ground& ground_;
  ClearingPath& path_;
  const Region& legal_;
  const Regions& target_;
  double radius_;
  double limit_;
  WallCuts cuts_;
  std::vector<Corner> all_corners_;
  std::vector<Corner> corners_;  ///< not yet cut
};

}  // namespace clearcut::plan::adaptive
