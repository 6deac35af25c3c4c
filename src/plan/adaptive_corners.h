// The last tenths of a millimetre in a corner, cut without the whole fillet touching the cutter at once.
#pragma once

#include <vector>

#include "plan/adaptive_ground.h"
#include "plan/adaptive_walls.h"

namespace clearcut {

/// Where a wall turns to the left by more than the limit, walked in its direction.
struct Corner {
  WallPlace place;
  double turn = 0;  ///< radians
};

std::vector<Corner> corners_of(const Walls& walls, double limit);
std::vector<WallPlace> places_of(const std::vector<Corner>& corners);

/// The cuts into one corner.
///
/// A cutter driven straight into a corner meets the thin crescent that is left there on as much of its circle as
/// the walls turn. Between two centres visited before, nothing is left but what the corner of their hull shows:
/// a centre meets the directions between the normals of its two tangents to that hull. So along the first wall
/// until the line to the last centre on the second wall is `limit` off the heading; from there on an arc that
/// keeps it so, to the second wall; back, straight or where the walls turn much on such an arc, too; and again, each
/// time a fixed share nearer.
///
/// Shape   from the first wall to the second; empty where there is nothing to cut or it was not prepared. Both
///         walls have been cut up to near the corner.
/// Error   what is left in the corner is at most `film` mm thick.
Path corner_cuts(const Walls& walls, const Corner& corner, Ground& ground, double limit, double film);

}  // namespace clearcut
