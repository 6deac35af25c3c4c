// Parameters that several steps of adaptive clearing share. What tunes one step alone stands beside that step.
#pragma once

namespace clearcut::plan::adaptive {

/// Radians of engagement, beside the limit that was asked for. Paths are found by sampling the engagement, so they
/// need room on both sides of the limit.
struct EngagementTolerance {
  /// Taken off the limit before planning: what rounding in the program, arcs fitted to traced curves and sampling may
  /// add. Larger: thinner cuts and a longer path; smaller: the certificate finds places above the limit.
  static constexpr double kMargin = 0.003;
  /// By which single moves may exceed the limit (1.4 degrees; the certificate allows 2). Larger: longer arcs and so
  /// fewer moves; smaller: arcs end earlier at every small peak.
  static constexpr double kExcess = 0.025;
  /// The same on spirals and on crossings, which stay above the limit for longer than a peak does.
  static constexpr double kLongExcess = 0.015;
  /// The engagement may rise by this much between two samples before more samples are taken between them.
  /// Arcs with a kink are aimed this much above the limit, because their engagement swings about it. Larger:
  /// fewer samples, higher peaks.
  static constexpr double kPeak = 0.008;
  /// Less engagement than this counts as none: it is what rounding leaves along a wall that is already cut.
  static constexpr double kNone = 0.02;
};

/// mm. How thick a residual (material left where a pass has been) may be. Each is a small multiple of what clear
/// links may graze or of what the wall passes leave, and all are below the 0.01 mm at which a certificate speaks of
/// uncut material.
struct ResidualLimits {
  /// What clear links may graze. Larger: more links at depth instead of retracts; smaller: fewer marks on walls.
  static constexpr double kLink = 1e-3;
  /// What may stand where the cutter goes straight down: less than for links, because its face comes down on it.
  static constexpr double kPlunge = kLink / 2;
  /// Where trochoidal steps end: less than links to the next step may graze (kCornerLink), so that it can be reached.
  static constexpr double kTrochoidal = 2 * kLink;
  /// On walls. Larger: fewer cuts along walls; smaller: every scallop between fitted arcs would be cut once more.
  static constexpr double kWall = 1.5e-3;
  /// What links to corners may graze: both walls of a corner may have up to kWall.
  static constexpr double kCornerLink = 2 * kWall;
  /// A wall with thinner residuals is finished.
  static constexpr double kFinishedWall = 2 * kCornerLink;
  /// In corners: the arcs between the walls end when this is left. Each halving costs one or two arcs a corner.
  static constexpr double kCorner = 3.7e-3;
  /// A rest no farther than this from what is cut stays. Between two cuts it may be twice as wide, and a bound of its width by
  /// small squares some micrometres wider yet: that, too, has to stay below what counts as uncut.
  static constexpr double kRest = 3.7e-3;
};

/// Shares of the cutter's radius: lengths that scale with the cutter.
struct RadiusShares {
  static constexpr double kWidestTurn =
      0.5;  ///< upper bound for the tightest radius after a cut has left a wall
  /// Between samples along walls. What stands between two is at most pitch^2 / 8 of the radius thick. Smaller: walls
  /// are sampled more often, planning time grows as its inverse.
  static constexpr double kWallPitch = 0.1;
  /// Length without engagement after which a cut ends: three samples. Larger: cuts run on over gaps where a
  /// link would do.
  static constexpr double kAir = 0.3;
  /// A cut that engages on less than this is not made.
  static constexpr double kLeastCut = kWallPitch / 2;
  /// An arc that ends this near to a wall is extended up to it.
  static constexpr double kEndsAtWall = kLeastCut;
  /// Beside a corner: how far the arcs between its walls reach, and how far the outline for clearing follows
  /// the wall.
  static constexpr double kCornerReach = 1.2;
};

/// A turn that cannot be cut is tried again with a radius smaller by this factor.
inline constexpr double kTighterTurn = 0.6;

}  // namespace clearcut::plan::adaptive
