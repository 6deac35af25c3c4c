// Cuts the material that is left in a corner of the walls without exceeding the engagement limit.
#pragma once

#include <optional>
#include <vector>

#include "plan/adaptive/remaining_stock.h"
#include "plan/adaptive/trace/walls.h"

namespace clearcut::plan::adaptive {

/// A place where a wall turns to the left by more than the engagement limit, walked in its direction (the cutter is inside).
struct Corner {
  WallPlace place;
  double turn = 0;  ///< radians between the walls' directions
};

/// How much nearer to a corner each arc between its walls ends than the one before; `turn` (of the corner) and `limit` in
/// radians.
double arc_gain(double turn, double limit);

std::vector<Corner> corners_of(const Walls& walls, double limit);
std::vector<WallPlace> places_of(const std::vector<Corner>& corners);

/// The path round a corner, from its first wall to its second, or to a place from where the second is cut straight.
struct CornerRound {
  Path path;
  double end = 0;              ///< mm along the wall: there the cut goes on
  double residual_before = 0;  ///< mm of the first wall along which what may stay in the corner stands
  double wedge =
      0;  ///< mm: thickness of the wedge that stays along the second wall where the path ends on the first
};

/// The cuts round one corner, from `from` mm before it on the first wall, which is cut up to there.
///
/// A cutter driven straight into a corner meets the thin crescent that is left there on as much of its circle as
/// the walls turn. Between two centres visited before, nothing is left but what the corner of their hull shows:
/// a centre meets the directions between the normals of its two tangents to that hull. So along the first wall
/// until the engagement is at its limit; from there on an arc, off the wall as little as the limit lets, to the second wall,
/// where the engagement is at the limit again; back on such an arc; and again, each time a fixed share nearer. The
/// engagement is that with the remaining stock itself: residuals on the walls count.
///
/// Shape   from the first wall to the second; none where the engagement does not keep the limit.
/// Error   what is left in the corner is at most `residual` mm thick.
std::optional<CornerRound> round_corner(const Walls& walls, const Corner& corner, double from,
                                        RemainingStock& remaining, double limit, double residual);
/// mm before the corner up to which its first wall is cut; none when that is more than RadiusShares::kCornerReach.
std::optional<double> prepared_before(const Walls& walls, const Corner& corner,
                                      const RemainingStock& remaining);

}  // namespace clearcut::plan::adaptive
