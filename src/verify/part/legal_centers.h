// The legal area of a cutter's centre, as the verifier computes it: its boundary.
#pragma once

#include "base/tolerances.h"
#include "verify/part/edge_tree.h"
#include "verify/part/finished_part.h"
#include "verify/part/trimmed_curve.h"

namespace clearcut::verify {

/// The legal centres of a cutter whose tip is at z: free places at least `reach` mm from every wall, where
/// reach is the radius plus the stock to leave.
class LegalCenters {
 public:
  /// Finds only the part of the boundary within `area`.
  LegalCenters(const FinishedPart& part, double z, double reach, const Box& area, const Tolerances& tol);

  /// Boundary of the area, unordered: parts of lines and arcs at `reach` from one wall and no nearer to any
  /// other. A line where the cutter just fits is a curve of its own, a place where it just fits a point. It
  /// may then come into the walls around by half of tol.fit, by up to 0.95 of it if there is nothing else.
  ///
  /// Every wall gives its parallel curve, every corner of the part its arc; parts nearer than `reach` to
  /// another wall are cut away. O(walls * walls near).
  const EdgeTree& boundary() const { return boundary_; }

  /// Whether the places of boundary() are no narrower than tol.fit lets pass for the cutter's width. Where they are,
  /// a program need not go there: it may, as far as rounding of walls lets it.
  bool within_fit() const { return within_fit_; }

  /// Whether the centre may be at p, which must be free.
  bool contains(Vec2 p) const;

 private:
  void add_wall_curves(const std::vector<int>& walls);
  void add_corner_curves(const std::vector<int>& walls);
  void add_end_curves(const std::vector<int>& walls);
  /// `wall`: the one that the curve runs along, on its right; its neighbours are tested first.
  void add_legal_parts(const Edge& curve, int wall);
  void add_fit_point(Vec2 p);
  void add_tight_places();
  void add_fitting_parts(const Edge& curve, int wall);
  /// What of `curve` is at least reach - `allowed` mm from every wall.
  TrimmedCurve legal_parts(const Edge& curve, int wall, double allowed) const;
  void cut_by_wall(TrimmedCurve& left, const Wall& wall, double upright) const;
  double clearance_over_reach(Vec2 p) const;

  const FinishedPart& part_;
  double z_, reach_;
  double slot_ = 0, hole_ = 0, point_ = 0;  ///< mm; how far the cutter may come into walls where it just fits
  bool within_fit_ = true;
  std::vector<Edge> found_;
  std::vector<std::pair<Edge, int>> tight_;  ///< short curves where the cutter just fits, with their walls
  EdgeTree boundary_;
};

}  // namespace clearcut::verify
