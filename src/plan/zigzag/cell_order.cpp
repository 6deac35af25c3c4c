#include <algorithm>

#include "order/search/visit_order.h"
#include "plan/zigzag/cells.h"

namespace clearcut::plan::zigzag {

std::vector<ZigzagLine> cut_lines(const ZigzagCell& cell, int variant) {
  auto lines = cell.lines;
  if (variant & 1) std::reverse(lines.begin(), lines.end());
  bool leftwards = (variant & 2) != 0;
  for (auto& line : lines) {
    if (leftwards) std::swap(line.left, line.right);
    leftwards = !leftwards;
  }
  return lines;
}

std::vector<CellVisit> order_cells(const std::vector<ZigzagCell>& cells, const OrderQuestion& question) {
  order::VisitQuestion visits;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    visits.visits.emplace_back();
    for (int variant = 0; variant < kCellVariants; ++variant) {
      const auto lines = cut_lines(cells[cell], variant);
      visits.visits.back().ways.push_back(
          {lines.front().left, lines.back().right, question.own({cell, variant})});
    }
  }
  const auto way = [&](const order::VisitStep& step) -> const order::VisitWay& {
    return visits.visits[step.visit].ways[step.way];
  };
  visits.travel = [&](const order::VisitStep& a, const order::VisitStep& b) {
    return question.travel(way(a).end, way(b).begin);
  };
  visits.far_travel = [&](const order::VisitStep& a, const order::VisitStep& b) {
    return question.far_travel(way(a).end, way(b).begin);
  };
  std::vector<CellVisit> order;
  for (const auto& step : order::order_visits(visits))
    order.push_back({step.visit, static_cast<int>(step.way)});
  return order;
}

}  // namespace clearcut::plan::zigzag
