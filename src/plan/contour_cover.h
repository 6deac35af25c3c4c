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

  /// Whether there is such a place inside `where`: the same search, there alone, and ended by the first.
  bool has_hole(const Box& where, const std::function<bool(Vec2)>& matters) const;

  /// Finds what the base alone leaves, for the covers made over it.
  void keep_rim(const std::function<bool(Vec2)>& matters);

 private:
  /// An edge, ready for questions of distance.
  struct Stroke {
    Vec2 from, along;
    double whole = 0;  ///< squared length; < 0: an arc
    Vec2 middle;       ///< of a disc around it
    double reach = 0;  ///< of that disc
  };
  /// A line at the given distance beside an edge, or a circle.
  struct Curve {
    bool circle = false;
    Vec2 a;             ///< a point of the line, or the centre
    Vec2 direction;     ///< unit, lines
    double radius = 0;  ///< circles
    Box box;
  };
  /// All that the rims of holes may consist of.
  struct Rims {
    std::vector<Curve> curves;
    std::vector<Vec2> joints;
    CellLists in;  ///< per cell: curves through it
  };
  /// Part of a cell.
  struct Square {
    Vec2 center;
    double half = 0;  ///< of a side
    std::size_t cell = 0;
    int depth = 0;
    /// Of two squares beside each other one holds the points between.
    bool holds(Vec2 p) const {
      return depth == 0 || (p.x >= center.x - half && p.x < center.x + half && p.y >= center.y - half &&
                            p.y < center.y + half);
    }
  };
  template <typename F>
  void quarter(const Square& square, std::span<const std::uint32_t> curves, const Rims& rims,
               const F& f) const;
  void sort_edges();
  Rims rims() const;
  template <typename Found>
  void search(const Box& where, const std::function<bool(Vec2)>& matters, const Found& found) const;
  void add_curve(const Curve& curve, Rims& rims) const;
  void add_joint(const Edge& before, const Edge& after, Rims& rims) const;
  /// Whether a curve passes within `reach` of a place.
  static bool passes(const Curve& curve, Vec2 center, double reach);
  static void add_meetings(const Curve& p, const Curve& q, std::vector<Vec2>& out);
  bool is_within(std::uint32_t edge, Vec2 p, double reach) const;
  double squared_distance(std::uint32_t edge, Vec2 p) const;
  bool own_edge_holds(Vec2 p, std::size_t cell, double reach) const;

  std::shared_ptr<const Cover> base_;
  std::vector<Edge> edges_;
  std::vector<Stroke> strokes_;
  double radius_;
  CellGrid grid_;
  CellLists edges_in_;  ///< per cell: edges that may clear a point of it
  // Of a base: what is found once for all covers made over it.
  Rims own_rims_;
  std::vector<Vec2> rim_;
};

}  // namespace clearcut
