// The clearance of a region: distance to its boundary, its medial axis, and all inward offsets, from one
// segment Voronoi diagram.
#pragma once

#include <memory>
#include <vector>

#include "base/tolerances.h"
#include "geometry/region.h"

namespace clearcut::inline geometry {

/// A point of the medial axis with its clearance (distance to the boundary), mm.
struct AxisPoint {
  Vec2 point;
  double clearance = 0;
};

/// One Voronoi edge inside the region: from `a` to `b`; between its ends the clearance is monotone
/// (edges with an interior minimum are split there).
struct AxisEdge {
  int a = 0;  ///< index into MedialAxis::points
  int b = 0;
};

/// The part of the Voronoi diagram inside the region, as a graph.
/// Edges between a boundary edge and its own end point (they only bound cells) are left out.
struct MedialAxis {
  std::vector<AxisPoint> points;
  std::vector<AxisEdge> edges;
};

/// Built in O(n log n), n flattened edges, or at once if it is kept for an equal region; immutable; safe to read from
/// several threads.
class Clearance {
 public:
  /// Throws InternalError only if `region` is not valid.
  Clearance(const Region& region, const Tolerances& tol);
  ~Clearance();
  Clearance(Clearance&&) noexcept;
  Clearance& operator=(Clearance&&) noexcept;

  /// All points of the region at distance >= d from its boundary.
  ///
  /// Shape   zero or more regions; islands that meet merge, necks under 2d wide split; vanished edges and runs of
  ///         edges are left out. Arcs give exact concentric arcs, reflex corners exact arcs about the corner.
  /// Units   d in mm, d >= 0.
  /// Error   points of the result lie at d +- 1 um from the boundary, and no point farther than 1 um inside is
  ///         missing.
  /// Fit     where the region is 2d wide to within tol.fit, see fit_lines().
  /// Cost    O(edges) per call.
  Regions inset(double d) const;
  /// The same for several ascending distances in one walk.
  std::vector<Regions> insets(const std::vector<double>& ascending) const;

  /// Open or closed curves on which a cutter of radius d just fits: parts of the medial axis with clearance d within
  /// tol.fit, outside all regions of inset(d). A place where the cutter just fits but cannot move (a hole of its own
  /// diameter) is a path of one edge with from == to. `reserve` (mm): part of d by which the clearance there may fall
  /// short; where there is one, a smaller share of tol.fit may be missing.
  std::vector<Path> fit_lines(double d, double reserve = 0) const;

  const MedialAxis& axis() const;
  /// The axis edge numbered `edge` as a polyline from its a to its b, no farther than `chord` mm from the
  /// true curve; the clearance between its points is linear to within `chord`, too.
  std::vector<AxisPoint> axis_curve(int edge, double chord) const;
  /// Local maxima of the clearance (pocket centres), one per plateau, largest first.
  const std::vector<AxisPoint>& centers() const;
  /// Largest clearance: the radius of the largest cutter that fits somewhere. mm.
  double max() const;

 private:
  friend class KeptClearances;
  struct Impl;
  class Store;
  std::shared_ptr<const Impl> impl_;
};

/// While one of these exists, clearances are kept and shared by all that are made of an equal region with equal
/// tolerances: the strategies of a plan begin with the same outlines. Those used longest ago are given up when all have too
/// many edges.
class KeptClearances {
 public:
  KeptClearances();
  ~KeptClearances();
  KeptClearances(const KeptClearances&) = delete;
  KeptClearances& operator=(const KeptClearances&) = delete;
};

/// Convenience: inset of one region, or of each of several. Prefer Clearance for several levels.
Regions inset(const Region& region, double d, const Tolerances& tol);
Regions inset(const Regions& regions, double d, const Tolerances& tol);
/// All points within distance d of the regions (round corners). mm, d >= 0.
Regions dilate(const Regions& regions, double d, const Tolerances& tol);

}  // namespace clearcut::inline geometry
