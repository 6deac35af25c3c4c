// Finds the order of cutting cells, and the start corner of each.
#pragma once

#include <functional>
#include <vector>

#include "plan/zigzag/cells.h"

namespace clearcut::plan::zigzag {

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
