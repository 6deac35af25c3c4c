// An exact check that a set of paths clears an area, and that the passes of a layer clear everything within the
// cutter's reach. The planner uses this check; the verifier has a check of its own.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "geometry/edge.h"
#include "geometry/spatial/cell_grid.h"
#include "model/layer.h"

namespace clearcut::plan {

/// The area swept by a cutter of `radius` mm along `edges`: tests whether points are cleared, and finds uncleared
/// places. A cover can have a base, a cover of edges that stay unchanged while the edges of this one change.
class Cover {
 public:
  /// Places at which holes are searched: a trade of running time for more places at each hole.
  enum class SearchPlaces {
    kAroundRims,  ///< at vertices of rims, and at intersections of two circles close to their parts of a rim
    kAtRims       ///< only at vertices of rims: much cheaper for crowded edges
  };
  Cover(std::span<const Edge> edges, double radius, SearchPlaces places = SearchPlaces::kAroundRims);
  /// A cover for questions inside `where` alone, with cells only there.
  Cover(std::span<const Edge> edges, double radius, const Box& where);
  /// The cover of `edges` and of all edges of `base`, with the radius of `base`. `edges` count only inside the box of
  /// `base`.
  Cover(std::span<const Edge> edges, std::shared_ptr<const Cover> base);

  /// Whether some edge is within radius - slack of p, so that p is cleared; `slack` in mm.
  bool holds(Vec2 p, double slack = 0) const;

  /// Distance from p to the nearest edge, mm; infinite if far greater than the radius.
  double distance_to(Vec2 p) const;
  /// The same distance if it is greater than `least`, mm; ends with the first edge that is not farther away.
  std::optional<double> distance_above(double least, Vec2 p) const;

  /// Uncleared places for which `matters` is true: at least one at the rim of every hole.
  ///
  /// Method  A hole of the swept area is bounded by pieces of lines and circles at `radius` from the edges.
  ///         At the joint of two pieces the rim has a vertex, at the distance `radius` from its edges and no nearer
  ///         to any other. So the intersections of all these lines and circles are tested. The search goes by squares
  ///         of a grid: squares wholly cleared by one edge are skipped, the others are quartered until few curves are
  ///         left in each. Vertices between edges of the base are found once, by keep_rim.
  /// Error   Only rounding, 1e-9 mm. The points beside both ends of every edge are tested, too, so that
  ///         holes without a vertex are not missed.
  std::vector<Vec2> holes(const std::function<bool(Vec2)>& matters) const;

  /// Whether there is an uncleared place inside `where`. Searches only there and ends with the first place found.
  bool has_hole(const Box& where, const std::function<bool(Vec2)>& matters) const;

  /// Finds and stores the uncleared places of this cover, so that covers with this one as base need not search again.
  void keep_rim(const std::function<bool(Vec2)>& matters);

 private:
  /// The directions from a point counter-clockwise from `start` to `end`.
  struct Wedge {
    Vec2 start, end;
    /// Whether the wedge is wider than half, a quarter of a turn.
    bool over_half = false, over_quarter = false;

    bool holds(Vec2 v) const;
    Box arc_box(Vec2 center, double radius) const;
    Box wide_box(Vec2 center, double radius) const;
  };
  /// An edge with the precomputed values for distances to it.
  struct Stroke {
    Vec2 from, to, along;
    double whole = 0;  ///< squared length of a line, mm^2; negative for an arc
    // Members of arcs:
    Vec2 center;
    Wedge wedge;
    double radius = 0;

    explicit Stroke(const Edge& edge);
    double squared_distance(Vec2 p) const;
    bool is_within(Vec2 p, double reach) const;
  };
  /// A piece of the border of the area cleared by an edge: a line at `radius` beside it, or a circle.
  struct Curve {
    bool circle = false;
    Vec2 a;             ///< a point of the line, or the centre
    Vec2 direction;     ///< direction of lines, unit length
    double radius = 0;  ///< radius of circles, mm
    Box box;
  };
  /// All curves and points of which rims of holes may consist.
  struct Rims {
    std::vector<Curve> curves;
    std::vector<std::uint32_t> first;  ///< the first curve of each edge; at the end the number of curves
    std::vector<Vec2> joints;          ///< kJoints points for each edge
  };
  class Search;
  /// mm. A point this much nearer to an edge than the radius is inside the swept area, not on its rim.
  static constexpr double kRim = 1e-7;
  /// mm. A point this near to the border of two squares is tested in both.
  static constexpr double kBorder = 1e-6;
  /// Points tested beside the ends of each edge: left and right of both.
  static constexpr std::uint32_t kJoints = 4;

  static CellGrid grid_over(const Box& box, double radius, std::size_t edges);
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
  bool is_clipped_ = false;  ///< whether edges pass beyond the cells
  CellLists edges_in_;       ///< per cell: the edges that may clear one of its points
  std::vector<char> whole_;  ///< per cell: whether one edge clears the whole cell
  // Only of covers used as a base: their curves, and their uncleared places (keep_rim).
  Rims own_rims_;
  std::vector<Vec2> rim_;
};

/// Whether every place of the target within the legal area of the cutter's centre is within the tool radius (mm) of
/// the passes. Residuals thinner than those between exactly meeting rings do not count. Cost: one search for holes in
/// the swept area.
bool leaves_nothing(const LayerPasses& passes, double tool_radius);

/// mm. Residual permitted at the border of a target.
inline constexpr double kBorderResidual = 0.005;

/// Whether the passes leave a part of the target's border up to `reach` mm from the legal area of the cutter's centre, by samples a tenth
/// of the tool radius (mm) apart. Walls are a tool radius from that area, open sides are nearer or in it.
bool leaves_border(const LayerPasses& passes, double tool_radius, double reach);

}  // namespace clearcut::plan
