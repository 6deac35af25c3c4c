// The last tenths of a millimetre in a corner, cut without the whole fillet touching the cutter at once.
#pragma once

#include <optional>
#include <vector>

#include "plan/adaptive/remaining_stock.h"
#include "plan/adaptive/trace/walls.h"

namespace clearcut::plan::adaptive {

/// Where a wall turns to the left by more than the limit, walked in its direction.
struct Corner {
  WallPlace place;
  double turn = 0;  ///< radians
};

/// How much nearer to a corner of so much turn, radians, each arc between its walls ends.
double arc_gain(double turn, double limit);

std::vector<Corner> corners_of(const Walls& walls, double limit);
std::vector<WallPlace> places_of(const std::vector<Corner>& corners);

/// The way round a corner, from its first wall to its second, or to where a straight cut along that may begin.
struct CornerRound {
  Path path;
  double end = 0;              ///< on the wall, where it goes on
  double residual_before = 0;  ///< mm of the first wall that bear what may stay in the corner
  double wedge = 0;  ///< mm. So thick a wedge stays along the second wall, from the path's end on the first
};

/// The cuts round one corner, from `from` mm before it on the first wall, which is cut up to there.
///
/// A cutter driven straight into a corner meets the thin crescent that is left there on as much of its circle as
/// the walls turn. Between two centres visited before, nothing is left but what the corner of their hull shows:
/// a centre meets the directions between the normals of its two tangents to that hull. So along the first wall
/// until the engagement is at its limit; from there on an arc, off the wall as little as the limit lets, to the second wall,
/// where the engagement is at the limit again; back on such an arc; and again, each time a fixed share nearer. What the
/// ground shows is taken for the engagement: residuals on the walls count.
///
/// Shape   from the first wall to the second; none where the engagement does not keep the limit.
/// Error   what is left in the corner is at most `residual` mm thick.
std::optional<CornerRound> round_corner(const Walls& walls, const Corner& corner, double from,
                                        RemainingStock& remaining, double limit, double residual);
/// mm. How near the corner the first wall is cut; none when that is not near.
std::optional<double> prepared_before(const Walls& walls, const Corner& corner,
                                      const RemainingStock& remaining);

}  // namespace clearcut::plan::adaptive
