// Answers quickly and exactly whether a straight move stays in the legal area of the cutter's centre.
#pragma once

#include <cstdint>
#include <memory_resource>
#include <vector>

#include "geometry/region.h"
#include "geometry/spatial/cell_grid.h"

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
  /// Whether the boundary is within `reach` mm of p. Cost: number of cells within `reach`.
  bool is_near_boundary(Vec2 p, double reach) const;
  /// Whether the whole box `where` is inside and no boundary is near. May return false although this is true.
  bool surely_holds(const Box& where) const;
  const Box& box() const { return box_; }

  /// mm. Points up to this far outside count as on the boundary: half of the smallest gouge that counts.
  static constexpr double kSlack = 5e-4;

 private:
  double cells_across() const;
  Box densest_part() const;
  void sort_edges();
  void mark_empty_cells();
  void find_next_empty();
  bool is_empty(std::size_t cell) const { return in_cells_.at(cell).empty(); }
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
  Box grid_;  ///< area covered by the cells; cells at its border also hold edges beyond the border
  std::vector<Edge> edges_;
  std::vector<Box> boxes_;
  double cell_ = 1;
  double cells_per_mm_ = 1;
  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
  CellLists in_cells_;        ///< edges by cell
  CellLists begin_in_;        ///< edges that a level line can cross, by the first of their cells in each row
  std::vector<char> inside_;  ///< per cell without edges: whether the cell is inside
  std::vector<std::uint32_t> next_empty_;  ///< per cell: the next one without edges, or the row's end
};

}  // namespace clearcut::inline geometry
