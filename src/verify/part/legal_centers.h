// The legal area of a cutter's centre, computed by the verifier: its boundary.
#pragma once

#include "base/tolerances.h"
#include "verify/part/edge_tree.h"
#include "verify/part/finished_part.h"
#include "verify/part/trimmed_curve.h"

namespace clearcut::verify {

/// The legal centres of a cutter with its tip at z: free places at least `reach` mm from every wall; reach is the
/// radius plus the stock to leave. `corner`: radius of the rounding beside the cutter's flat end; beside a fillet of a
/// greater radius at a wall's foot the cutter keeps farther off.
class LegalCenters {
 public:
  /// Finds only the part of the boundary within `area`.
  LegalCenters(const FinishedPart& part, double z, double reach, double corner, const Box& area,
               const Tolerances& tol);

  /// Boundary of the area, unordered: parts of lines and arcs at `reach` from one wall and no nearer to any
  /// other. A line on which the cutter just fits is a separate curve, a place at which it just fits a point. There
  /// the cutter may cut into the walls around by half of tol.fit, by up to 0.95 of tol.fit if no other place exists.
  ///
  /// Every wall gives its parallel curve, every corner of the part its arc; parts nearer than `reach` to
  /// another wall are cut away. O(walls * walls near).
  const EdgeTree& boundary() const { return boundary_; }

  /// Whether all places of boundary() are wide enough for the cutter within tol.fit. If not, a program need not visit
  /// them; it may, as far as rounding of walls permits.
  bool within_fit() const { return within_fit_; }

  /// Whether p, which must be free, is a legal centre.
  bool contains(Vec2 p) const;

 private:
  void add_wall_curves(const std::vector<int>& walls);
  void add_corner_curves(const std::vector<int>& walls);
  void add_end_curves(const std::vector<int>& walls);
  /// `wall`: the wall along the curve, on its right; its neighbours are tested first.
  void add_legal_parts(const Edge& curve, int wall);
  void add_fit_point(Vec2 p);
  void add_tight_places();
  void add_fitting_parts(const Edge& curve, int wall);
  /// The parts of `curve` at least reach - `allowed` mm from every wall.
  TrimmedCurve legal_parts(const Edge& curve, int wall, double allowed) const;
  void cut_by_wall(TrimmedCurve& left, const Wall& wall, double upright) const;
  double clearance_over_reach(Vec2 p) const;
  /// mm more than `reach`, at most, that the cutter keeps off the outline of this wall, off any, and off a fillet.
  double farther_from(const Wall& wall) const { return wall.draft_offset(z_) + off_fillet(wall); }
  double most_farther() const { return part_.greatest_draft_offset() + part_.greatest_fillet(); }
  double off_fillet(const Wall& wall) const;

  const FinishedPart& part_;
  double z_, reach_, corner_;
  /// mm; permitted intrusion of the cutter into walls at places where it just fits.
  double slot_ = 0, hole_ = 0, point_ = 0;
  bool within_fit_ = true;
  std::vector<Edge> found_;
  std::vector<std::pair<Edge, int>> tight_;  ///< short curves on which the cutter just fits, with their walls
  EdgeTree boundary_;
};

}  // namespace clearcut::verify
