// Cuts that begin at walls which still touch material.
#pragma once

#include <optional>
#include <vector>

#include "plan/adaptive/clearing_path.h"
#include "plan/adaptive/trace/tracer.h"
#include "plan/adaptive/trace/walls.h"

namespace clearcut::plan::adaptive {

/// Walls to cut along, and the cuts that begin there.
class WallCuts {
 public:
  /// Cuts off the walls stay inside `area`, their engagement below `limit`.
  WallCuts(RemainingStock& remaining, ClearingPath& path, Walls walls, const Regions& area, double limit,
           AlongWalls along);
  WallCuts(const WallCuts&) = delete;
  WallCuts& operator=(const WallCuts&) = delete;

  Walls walls;
  Tracer tracer;

  /// Goes to the wall at `start` or just before it, and cuts from there. Whether the place is settled: cut, or given up
  /// because nothing can be cut from it; false where no way leads there.
  bool cut_from(const WallPlace& start);
  /// The start that is nearest to the cutter. `starts` holds at least one.
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
  int stuck_ = 0;  ///< cuts that did not get farther along the wall than the one before
};

}  // namespace clearcut::plan::adaptive
