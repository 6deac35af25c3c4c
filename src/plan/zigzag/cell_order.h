// In which order cells are cut, and from which of their corners. Used by the planner alone.
#pragma once

#include <functional>
#include <vector>

#include "plan/zigzag/cells.h"

namespace clearcut::plan::zigzag {

/// A cell with the way it is cut. variant: bit 0 downwards, bit 1 its first line from right to left.
struct CellVisit {
  std::size_t cell = 0;
  int variant = 0;
};
inline constexpr int kCellVariants = 4;

/// The lines of a cell in the order and sense in which they are cut.
std::vector<ZigzagLine> cut_lines(const ZigzagCell& cell, int variant);

struct OrderQuestion {
  /// Cost of going from the end of one cell to the beginning of the next. Any unit.
  std::function<double(Vec2 from, Vec2 to)> travel;
  /// The same, no less and quicker to ask: for places far apart.
  std::function<double(Vec2 from, Vec2 to)> far_travel;
  /// Cost that depends on the way a cell is cut alone.
  std::function<double(const CellVisit&)> own;
};

/// All cells once, cheap in sum; method and cost: order/visit/visit_order.h.
std::vector<CellVisit> order_cells(const std::vector<ZigzagCell>& cells, const OrderQuestion& question);

}  // namespace clearcut::plan::zigzag
