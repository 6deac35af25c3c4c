// Makes the cuts that begin at walls which still touch material, and the links to them.
#pragma once

#include <optional>
#include <vector>

#include "plan/adaptive/clearing/clearing_path.h"
#include "plan/adaptive/trace/tracer.h"
#include "plan/adaptive/trace/walls.h"

namespace clearcut::plan::adaptive {

/// The walls of one area, and the cuts that begin at them.
class WallCuts {
 public:
  /// Cuts off the walls stay inside `area` and keep the engagement limit `limit`, radians. References are
  /// kept.
  WallCuts(RemainingStock& remaining, ClearingPath& path, Walls walls, const Regions& area, double limit,
           AlongWalls along);
  WallCuts(const WallCuts&) = delete;
  WallCuts& operator=(const WallCuts&) = delete;

  Walls walls;
  Tracer tracer;

  /// Links to the wall at `start`, or to a clear place just before it, and cuts from there. True if the start
  /// is done with: it was cut, or nothing can be cut from it. False if no link leads there.
  bool cut_from(const WallPlace& start);
  /// The one of `starts` that is nearest to the cutter; there must be one.
  WallPlace nearest(const std::vector<WallPlace>& starts) const;

 private:
  struct Approach;
  enum class Outcome { kCut, kNothingToCut, kNoLink };
  Outcome cut_from_clear_wall(const WallPlace& start);
  void add(const WallPlace& start, const Path& cut, const LinkPath& link);
  std::optional<WallPlace> clear_place_before(const WallPlace& start) const;
  double farthest_before(const WallPlace& start) const;
  std::optional<Approach> approach_to(const WallPlace& start) const;
  std::optional<Approach> straight_on_to(const WallPlace& place) const;
  std::optional<Approach> approach_from_aside(const WallPlace& place) const;
  std::optional<Approach> approach_through_residuals(const WallPlace& start) const;
  bool is_within(const Edge& edge) const;

  RemainingStock& remaining_;
  ClearingPath& path_;
  double radius_;
  double limit_;
  int stuck_ = 0;  ///< number of successive cuts that got no farther along the wall than the one before
};

}  // namespace clearcut::plan::adaptive
