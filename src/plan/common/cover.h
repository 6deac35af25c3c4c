// An exact check that a set of paths clears an area. Used by the planner alone: the verifier has its own.
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

/// Answers which points the cutter of `radius` has swept along `edges`, and along those of another cover that stays
/// the same while edges change.
class Cover {
 public:
  /// At which places holes are searched for.
  enum class SearchPlaces {
    kAroundRims,  ///< where circles meet others near their part of a rim, too: more places of some holes
    kAtRims       ///< only at vertices of rims: much the cheaper where edges crowd
  };
  Cover(std::span<const Edge> edges, double radius, SearchPlaces places = SearchPlaces::kAroundRims);
  /// Together with all that `base` holds; it must have the same radius. Edges count only inside the box of `base`.
  Cover(std::span<const Edge> edges, std::shared_ptr<const Cover> base);

  /// Whether some edge lies within radius - slack of p.
  bool holds(Vec2 p, double slack = 0) const;

  /// Distance from p to the nearest edge, mm; infinite where that is far beyond the radius.
  double distance_to(Vec2 p) const;

  /// Places left uncut where `matters`, at least one at the rim of every hole.
  ///
  /// Method  A hole of the swept area is bounded by pieces of lines and circles at `radius` from the edges;
  ///         where two of them meet, the rim has a vertex, and a vertex is no nearer than `radius` to any edge. So
  ///         it is enough to look at the meeting points of all such lines and circles; those of the base alone are
  ///         found once. Squares that one edge clears whole have none; others are quartered until few lines and
  ///         circles are left in them, each part with the edges near it alone: so only what runs along the swept
  ///         area's border is met with its neighbours there.
  /// Error   none but rounding (1e-9 mm). Holes without a rim vertex do not occur: the points beside each end of an
  ///         edge are looked at, too.
  std::vector<Vec2> holes(const std::function<bool(Vec2)>& matters) const;

  /// Whether there is such a place inside `where`: the same search, there alone, and ended by the first.
  bool has_hole(const Box& where, const std::function<bool(Vec2)>& matters) const;

  /// Finds what the base alone leaves, for the covers made over it.
  void keep_rim(const std::function<bool(Vec2)>& matters);

 private:
  /// Rays from a point, counter-clockwise from `start` to `end`.
  struct Wedge {
    Vec2 start, end;
    bool over_half = false, over_quarter = false;  ///< of a turn

    bool holds(Vec2 v) const;
    Box arc_box(Vec2 center, double radius) const;
    Box wide_box(Vec2 center, double radius) const;
  };
  /// An edge, ready for questions of distance.
  struct Stroke {
    Vec2 from, to, along;
    double whole = 0;  ///< squared length; < 0: an arc
    // Arcs:
    Vec2 center;
    Wedge wedge;
    double radius = 0;

    explicit Stroke(const Edge& edge);
    double squared_distance(Vec2 p) const;
    bool is_within(Vec2 p, double reach) const;
  };
  /// A line at the radius beside an edge, or a circle: the border of what the edge clears.
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
    std::vector<std::uint32_t> first;  ///< per edge, and one more: its first curve
    std::vector<Vec2> joints;          ///< kJoints per edge
  };
  class Search;
  /// mm. A point this much nearer than the radius to an edge is inside its swept area, not on the rim.
  static constexpr double kRim = 1e-7;
  /// mm. A point on the border of two squares is looked for in both.
  static constexpr double kBorder = 1e-6;
  /// Places beside the ends of an edge that are looked at.
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
  CellLists edges_in_;       ///< per cell: edges that may clear a point of it
  std::vector<char> whole_;  ///< per cell: whether one edge clears all of it
  // Of a base: what is found once for all covers made over it.
  Rims own_rims_;
  std::vector<Vec2> rim_;
};

}  // namespace clearcut::plan
