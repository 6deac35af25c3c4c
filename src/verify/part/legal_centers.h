// Where a cutter's centre may be: the boundary of that area.
#pragma once

#include "base/tolerances.h"
#include "verify/part/edge_tree.h"
#include "verify/part/finished_part.h"
#include "verify/part/trimmed_curve.h"

namespace clearcut::verify {

/// The legal centres of a cutter whose tip is at z: free places at `reach` mm or more from every wall (reach
/// = radius + stock to leave).
class LegalCenters {
 public:
  /// Only the part of the boundary within `area` is found.
  LegalCenters(const FinishedPart& part, double z, double reach, const Box& area, const Tolerances& tol);

  /// Boundary of the area, unordered: parts of lines and arcs at `reach` from one wall and no nearer to
  /// another. A stretch where the cutter just fits is a curve of its own; a place where it just
  /// fits is a point (half of tol.fit into the walls around; up to 0.95 where there is nothing else).
  ///
  /// Every wall gives its parallel curve, every corner of the part its arc; from each, the stretches nearer
  /// than `reach` to another wall are cut away. O(walls * walls near).
  const EdgeTree& boundary() const { return boundary_; }

  /// Whether the centre may be at p, a free place.
  bool contains(Vec2 p) const;

 private:
  void add_wall_curves(const std::vector<int>& walls);
  void add_corner_curves(const std::vector<int>& walls);
  void add_end_curves(const std::vector<int>& walls);
  /// `wall`: that which the curve runs along; its neighbours are the likeliest to be nearer.
  void add_legal_parts(const Edge& curve, int wall);
  void add_fit_point(Vec2 p);
  void add_tight_places();
  /// What of `curve` no wall comes nearer to than its reach less `allowed`.
  TrimmedCurve legal_parts(const Edge& curve, int wall, double allowed) const;
  void cut_by_wall(TrimmedCurve& left, const Wall& wall, double upright) const;
  double clearance_over_reach(Vec2 p) const;

  const FinishedPart& part_;
  double z_, reach_;
  double slot_ = 0, hole_ = 0, point_ = 0;  ///< mm; how far the cutter may come into walls where it just fits
  std::vector<Edge> found_;
  std::vector<std::pair<Edge, int>> tight_;  ///< short stretches where the cutter just fits, and their walls
  EdgeTree boundary_;
};

}  // namespace clearcut::verify
