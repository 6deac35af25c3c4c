// An exact check that a set of paths clears an area. The planner uses it; the verifier has a check of its
// own.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "geometry/edge.h"
#include "geometry/spatial/cell_grid.h"

namespace clearcut::plan {

/// The area that a cutter of `radius` mm sweeps along `edges`: which points it clears, and which places it
/// leaves. It can be laid over a base, a cover of edges that stay while the edges of this one change.
class Cover {
 public:
  /// Where holes are searched for: a trade of running time for more places at each hole.
  enum class SearchPlaces {
    kAroundRims,  ///< at vertices of rims, and where two circles meet close to their parts of a rim
    kAtRims       ///< at vertices of rims alone: much cheaper where edges crowd
  };
  Cover(std::span<const Edge> edges, double radius, SearchPlaces places = SearchPlaces::kAroundRims);
  /// The cover of `edges` and of all edges of `base`, whose radius it takes over. `edges` count only inside
  /// the box of `base`.
  Cover(std::span<const Edge> edges, std::shared_ptr<const Cover> base);

  /// Whether some edge lies within radius - slack of p, so that p is cleared; `slack` in mm.
  bool holds(Vec2 p, double slack = 0) const;

  /// Distance from p to the nearest edge, mm; infinite where it is far greater than the radius.
  double distance_to(Vec2 p) const;

  /// Places that the cutter leaves and for which `matters` is true: at least one at the rim of every hole.
  ///
  /// Method  A hole of the swept area is bounded by pieces of lines and circles at `radius` from the edges.
  ///         Where two pieces join, the rim has a vertex, which lies at `radius` from its edges and no nearer
  ///         to any other. So the intersections of all these lines and circles are tested. The search goes by
  ///         squares of a grid: squares that one edge clears whole are skipped, the others are quartered
  ///         until few curves are left in each. Vertices between edges of the base are found once, by
  ///         keep_rim.
  /// Error   Rounding alone, 1e-9 mm. The points beside both ends of every edge are tested, too, so that
  ///         holes without a vertex are not missed.
  std::vector<Vec2> holes(const std::function<bool(Vec2)>& matters) const;

  /// Whether such a place lies inside `where`. Searches there alone and ends with the first that it finds.
  bool has_hole(const Box& where, const std::function<bool(Vec2)>& matters) const;

  /// Finds once what this cover leaves, so that covers made over it as their base need not search again.
  void keep_rim(const std::function<bool(Vec2)>& matters);

 private:
  /// The directions from a point that lie counter-clockwise from `start` to `end`.
  struct Wedge {
    Vec2 start, end;
    bool over_half = false, over_quarter = false;  ///< whether it is wider than half, a quarter of a turn

    bool holds(Vec2 v) const;
    Box arc_box(Vec2 center, double radius) const;
    Box wide_box(Vec2 center, double radius) const;
  };
  /// An edge with what distances to it are computed from.
  struct Stroke {
    Vec2 from, to, along;
    double whole = 0;  ///< squared length of a line, mm^2; negative for an arc
    // Of arcs:
    Vec2 center;
    Wedge wedge;
    double radius = 0;

    explicit Stroke(const Edge& edge);
    double squared_distance(Vec2 p) const;
    bool is_within(Vec2 p, double reach) const;
  };
  /// A piece of the border of what an edge clears: a line at `radius` beside it, or a circle.
  struct Curve {
    bool circle = false;
    Vec2 a;             ///< a point of the line, or the centre
    Vec2 direction;     ///< of lines, unit length
    double radius = 0;  ///< of circles, mm
    Box box;
  };
  /// All curves and points that rims of holes may consist of.
  struct Rims {
    std::vector<Curve> curves;
    std::vector<std::uint32_t> first;  ///< the first curve of each edge; at the end the number of curves
    std::vector<Vec2> joints;          ///< kJoints points for each edge
  };
  class Search;
  /// mm. A point this much nearer to an edge than the radius lies inside the swept area, not on its rim.
  static constexpr double kRim = 1e-7;
  /// mm. A point this near to the border of two squares is tested in both.
  static constexpr double kBorder = 1e-6;
  /// Points tested beside the ends of each edge: left and right of both.
  static constexpr std::uint32_t kJoints = 4;

  void sort_edges();
  Rims rims() const;
  void add_sides(std::uint32_t edge, Vec2 across, Rims& rims) const;
  void add_circle(Vec2 center, double radius, const Wedge& part, const Box& around, Rims& rims) const;
  static std::optional<Wedge> outer_side(Vec2 in, Vec2 out);
  bool own_edge_holds(Vec2 p, std::size_t cell, double reach) const;

  std::shared_ptr<const Cover> base_;
  std::vector<Edge> edges_;
  std::vector<Stroke> strokes_;
  double radius_;
  SearchPlaces places_;
  CellGrid grid_;
  CellLists edges_in_;       ///< per cell: the edges that may clear a point of it
  std::vector<char> whole_;  ///< per cell: whether one edge clears all of it
  // Only of covers used as a base: their curves, and the places that they leave (keep_rim).
  Rims own_rims_;
  std::vector<Vec2> rim_;
};

}  // namespace clearcut::plan
