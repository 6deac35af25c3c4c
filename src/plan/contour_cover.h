// An exact check that a set of paths clears an area. Used by the planner alone: the verifier has its own.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "geometry/edge.h"

namespace clearcut {

/// Answers which points the cutter of `radius` has swept along `edges`.
class Cover {
 public:
  Cover(std::span<const Edge> edges, double radius);

  /// Whether some edge lies within radius - slack of p.
  bool holds(Vec2 p, double slack = 0) const;

  /// Distance from p to the nearest edge, mm; infinite where that is far beyond the radius.
  double distance_to(Vec2 p) const;

  /// Places left uncut where `matters`, at least one at the rim of every hole.
  ///
  /// Method  A hole of the swept area is bounded by pieces of lines and circles at `radius` from the edges;
  /// where two
  ///         of them meet, the rim has a vertex, and a vertex is no nearer than `radius` to any edge. So it
  ///         is enough to look at the meeting points of all such lines and circles: O(n * neighbours) of
  ///         them.
  /// Error   none but rounding (1e-9 mm). Holes without a rim vertex do not occur: the points beside each end
  /// of an
  ///         edge are looked at, too.
  std::vector<Vec2> holes(const std::function<bool(Vec2)>& matters) const;

 private:
  /// A line at the given distance beside an edge (infinite in theory), or a circle.
  struct Curve {
    bool circle = false;
    Vec2 a;             ///< a point of the line, or the centre
    Vec2 direction;     ///< unit, lines
    double radius = 0;  ///< circles
    Box box;
  };
  void add_curves();
  void add_curve(const Curve& curve);
  void add_joint(const Edge& before, const Edge& after);
  void add_joint_points();
  void add_meetings(const Curve& p, const Curve& q, std::vector<Vec2>& out) const;
  std::size_t cell_of(Vec2 p) const;
  template <typename F>
  void for_cells(const Box& box, F&& f) const;

  std::vector<Edge> edges_;
  double radius_;
  std::vector<Curve> curves_;
  std::vector<Vec2> joints_;
  Box box_;
  double cell_ = 1;
  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
  std::vector<std::vector<std::uint32_t>> edges_in_;   ///< per cell: edges that may clear a point of it
  std::vector<std::vector<std::uint32_t>> curves_in_;  ///< per cell: curves through it
};

}  // namespace clearcut
