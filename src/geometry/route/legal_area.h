// Answers quickly and exactly whether a straight move stays where the cutter's centre may be.
#pragma once

#include <memory_resource>
#include <vector>

#include "geometry/region.h"

namespace clearcut::inline geometry {

/// The legal area of one layer with its boundary edges sorted into a grid. Cheap to query, built in O(edges).
class LegalArea {
 public:
  explicit LegalArea(Regions regions);

  /// Whether every point of the straight path a-b is inside or within `slack` mm of the boundary.
  bool holds_line(Vec2 a, Vec2 b) const;
  bool holds(Vec2 p) const;
  /// Whether p is inside (on the boundary: either). Quick: for most places no edge has to be checked.
  bool contains(Vec2 p) const;
  /// Whether the boundary comes within `reach` mm of p. Cost: the cells that lie so near.
  bool is_near_boundary(Vec2 p, double reach) const;
  /// Whether all of `where` is inside and no boundary runs near it. May say no though it is so.
  bool surely_holds(const Box& where) const;
  const Box& box() const { return box_; }

  /// mm. How far outside the boundary is still on it: half of the smallest gouge that counts.
  static constexpr double kSlack = 5e-4;

 private:
  Box densest_part() const;
  void mark_empty_cells();
  Box cell_box(std::size_t cell) const;
  int crossings(std::size_t edge, Vec2 p, double x) const;
  template <typename F>
  void for_edges_along(Vec2 a, Vec2 b, const F& f) const;
  bool strays_beside(Vec2 a, Vec2 b, Vec2 end) const;
  bool passes_outside(Vec2 a, Vec2 b) const;
  static void add_cuts(Vec2 a, Vec2 b, const Edge& edge, std::pmr::vector<double>& cuts);
  static void add_arc_cuts(Vec2 a, Vec2 b, const Edge& arc, std::pmr::vector<double>& cuts);
  std::size_t column(double x) const;
  std::size_t row(double y) const;

  Regions regions_;
  Box box_;
  Box grid_;  ///< what the cells cover; those at its border hold what lies beyond, too
  std::vector<Edge> edges_;
  std::vector<Box> boxes_;
  std::vector<std::size_t> first_columns_;  ///< per edge: of the cells it stands in
  double cell_ = 1;
  double cells_per_mm_ = 1;
  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
  std::vector<std::vector<std::size_t>> cells_;
  std::vector<char> inside_;  ///< of each cell without edges: whether it lies inside
};

}  // namespace clearcut::inline geometry
