// An exact check that a set of paths clears an area. Used by the planner alone: the verifier has its own.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "geometry/edge.h"
#include "plan/contour_index.h"

namespace clearcut {

/// Answers which points the cutter of `radius` has swept along `edges`, and along those of another cover that stays
/// the same while edges change.
class Cover {
 public:
  Cover(std::span<const Edge> edges, double radius);
  /// With all that `base` holds, too; it must have the same radius. Edges outside its box are not looked at beyond
  /// it.
  Cover(std::span<const Edge> edges, std::shared_ptr<const Cover> base);

  /// Whether some edge lies within radius - slack of p.
  bool holds(Vec2 p, double slack = 0) const;

  /// Distance from p to the nearest edge, mm; infinite where that is far beyond the radius.
  double distance_to(Vec2 p) const;

  /// Places left uncut where `matters`, at least one at the rim of every hole.
  ///
  /// Method  A hole of the swept area is bounded by pieces of lines and circles at `radius` from the edges;
  ///         where two of them meet, the rim has a vertex, and a vertex is no nearer than `radius` to any edge. So
  ///         it is enough to look at the meeting points of all such lines and circles: O(n * neighbours) of them;
  ///         those of the base alone are found once.
  /// Error   none but rounding (1e-9 mm). Holes without a rim vertex do not occur: the points beside each end of an
  ///         edge are looked at, too.
  std::vector<Vec2> holes(const std::function<bool(Vec2)>& matters) const;

  /// Finds what the base alone leaves, for the covers made over it.
  void keep_rim(const std::function<bool(Vec2)>& matters);

 private:
  /// A line at the given distance beside an edge, or a circle.
  struct Curve {
    bool circle = false;
    Vec2 a;             ///< a point of the line, or the centre
    Vec2 direction;     ///< unit, lines
    double radius = 0;  ///< circles
    Box box;
  };
  void sort_edges();
  void add_curves();
  void add_curve(const Curve& curve);
  void add_joint(const Edge& before, const Edge& after);
  void add_joint_points();
  static void add_meetings(const Curve& p, const Curve& q, std::vector<Vec2>& out);
  bool own_edge_holds(Vec2 p, std::size_t cell, double reach) const;

  std::shared_ptr<const Cover> base_;
  std::vector<Edge> edges_;
  double radius_;
  std::vector<Curve> curves_;
  std::vector<Vec2> joints_;
  std::vector<Vec2> rim_;
  CellGrid grid_;
  CellLists edges_in_;   ///< per cell: edges that may clear a point of it
  CellLists curves_in_;  ///< per cell: curves through it
};

}  // namespace clearcut
