// Cuts the material that is left in a corner between two walls without exceeding the engagement limit.
#pragma once

#include <optional>
#include <vector>

#include "plan/adaptive/clearing/remaining_stock.h"
#include "plan/adaptive/trace/walls.h"

namespace clearcut::plan::adaptive {

/// A place where a wall turns to the left by more than the engagement limit; the cutter is on the wall's
/// left, inside the corner.
struct Corner {
  WallPlace place;
  double turn = 0;  ///< radians between the directions of the two walls
};

/// The cutter goes to and fro between the walls of a corner on arcs. By which factor each arc ends nearer to
/// the corner than the one before; `turn` (of the corner) and `limit` in radians.
double arc_gain(double turn, double limit);

/// All corners of the walls for an engagement limit of `limit` radians, and the places of given corners.
std::vector<Corner> corners_of(const Walls& walls, double limit);
std::vector<WallPlace> places_of(const std::vector<Corner>& corners);

/// The path round a corner: from its first wall to its second, or to a place from which the second wall is
/// cut straight on.
struct CornerRound {
  Path path;
  double end = 0;  ///< mm along the wall: where cutting along the second wall goes on
  /// mm before the corner, on the first wall, from where on the cutter touches the residual in the corner.
  double residual_before = 0;
  /// mm; thickness of the wedge that stays along the second wall if the path ends on the first wall.
  double wedge = 0;
};

/// The path round one corner; it begins on the first wall, `from` mm before the corner, up to where that wall
/// is cut.
///
/// A cutter driven straight into a corner meets the thin crescent that is left there on as much of its circle
/// as the walls turn. Nothing is left between centres visited before except outside of their convex hull: at
/// a centre, the engaged directions are those between the normals of its two tangents to that hull. So the
/// cutter goes along the first wall until the engagement is at its limit, from there on an arc to the second
/// wall, where the engagement is at the limit again, back on such an arc, and so on, each time nearer by a
/// fixed factor. Engagements are computed from the remaining stock itself, residuals on the walls included.
///
/// Shape   From the first wall to the second; nothing if the engagement cannot keep the limit (radians).
/// Error   What stays in the corner is at most `residual` mm thick.
std::optional<CornerRound> round_corner(const Walls& walls, const Corner& corner, double from,
                                        RemainingStock& remaining, double limit, double residual);
/// mm before the corner up to which its first wall is cut; nothing if that is more than
/// RadiusShares::kCornerReach radii.
std::optional<double> prepared_before(const Walls& walls, const Corner& corner,
                                      const RemainingStock& remaining);

}  // namespace clearcut::plan::adaptive
