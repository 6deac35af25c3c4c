// Parallel lines clearing a region, grouped into cells of successive lines, and the order of cutting cells with the
// start corner of each.
#pragma once

#include <functional>
#include <vector>

#include "geometry/region.h"

namespace clearcut::plan::zigzag {

/// A line of the cutter's centre, left.x <= right.x; a single point if both are equal.
struct ZigzagLine {
  Vec2 left;
  Vec2 right;
};

/// Lines one above the other, upwards; neighbours overlap in x, with nothing between them.
struct ZigzagCell {
  std::vector<ZigzagLine> lines;
};

/// Lines along x clearing `rest`, in cells.
///
/// Method  `rest` is divided into horizontal strips of equal height, at most `widest_step` mm. The line in
///         the middle of a strip is as long as the part of `rest` in the strip, less the part cleared by the disc at
///         its end. So every point of the line is straight above or below a point of `rest`, at most a radius away:
///         if `rest` is everywhere a radius inside the legal area, all lines are legal.
/// Error   Lines are computed for a radius smaller by 1 um, so residuals stay below 1 um.
/// Cost    O(edges * crossed strips).
std::vector<ZigzagCell> zigzag_cells(const Region& rest, double radius, double widest_step);

/// A cell and the manner of cutting it. Variant, bit 0: downwards; bit 1: its first line from right to left.
struct CellVisit {
  std::size_t cell = 0;
  int variant = 0;
};
inline constexpr int kCellVariants = 4;

/// The lines of a cell in the order and direction of cutting.
std::vector<ZigzagLine> cut_lines(const ZigzagCell& cell, int variant);

/// The costs for choosing an order of cells; any unit.
struct OrderQuestion {
  /// Cost of going from the end of one cell to the beginning of the next.
  std::function<double(Vec2 from, Vec2 to)> travel;
  /// A quickly computed upper bound of this cost, for points far apart.
  std::function<double(Vec2 from, Vec2 to)> far_travel;
  /// Cost depending only on the manner of cutting the cell.
  std::function<double(const CellVisit&)> own;
};

/// All cells once, at low total cost; for method and cost see order/search/visit_order.h.
std::vector<CellVisit> order_cells(const std::vector<ZigzagCell>& cells, const OrderQuestion& question);

}  // namespace clearcut::plan::zigzag
