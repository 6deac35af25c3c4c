#include "plan/grid/reduce.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "base/elementary.h"
#include "base/tolerances.h"

namespace clearcut::plan::grid {
namespace {

double squared(double v) {
  return v * v;
}

double apart(Square a, Square b) {
  return base::hypot(a.column - b.column, a.row - b.row);
}

bool adjacent(Square a, Square b) {
  return std::abs(a.column - b.column) + std::abs(a.row - b.row) == 1;
}

bool collinear(Square a, Square b, Square c) {
  return (b.column - a.column) * (c.row - a.row) == (b.row - a.row) * (c.column - a.column);
}

/// Among the squares strictly between two indices, the square nearest to the tool's periphery at `corner` but not
/// inside it.
std::optional<std::size_t> at_periphery(const std::vector<Square>& squares, std::size_t corner,
                                        std::size_t low, std::size_t high, double radius) {
  std::optional<std::size_t> best;
  for (std::size_t i = low + 1; i < high; ++i) {
    const double d = apart(squares[corner], squares[i]);
    if (d < radius - kRoundingMm) continue;
    if (!best || d < apart(squares[corner], squares[*best])) best = i;
  }
  return best;
}

bool valid_gap(int d3, MiddleRow rule) {
  return rule == MiddleRow::kKeep ? d3 >= 0 : d3 > 1;
}

bool in(const std::vector<int>& sorted, int value) {
  return std::binary_search(sorted.begin(), sorted.end(), value);
}

/// The squares kept so far, with a query for neighbours nearer than a radius.
class Kept {
 public:
  explicit Kept(double radius) : radius_(radius), reach_(static_cast<int>(std::ceil(radius))) {}
  bool has_near(Square s) const {
    for (int row = s.row - reach_; row <= s.row + reach_; ++row) {
      for (auto it = squares_.lower_bound({row, s.column - reach_});
           it != squares_.end() && it->first == row && it->second <= s.column + reach_; ++it) {
        const double d2 = squared(row - s.row) + squared(it->second - s.column);
        if (d2 < squared(radius_) - kRoundingMm) return true;
      }
    }
    return false;
  }
  void add(Square s) { squares_.insert({s.row, s.column}); }

 private:
  double radius_;
  int reach_;
  std::set<std::pair<int, int>> squares_;
};

}  // namespace

ElementEdges find_edges(const std::vector<Square>& squares) {
  ElementEdges edges;
  edges.left.push_back(0);
  for (std::size_t i = 1; i + 1 < squares.size(); ++i) {
    const Square before = squares[i - 1], here = squares[i], after = squares[i + 1];
    if (collinear(before, here, after)) continue;
    if (adjacent(before, here)) edges.right.push_back(i);
    if (adjacent(here, after)) edges.left.push_back(i);
  }
  const std::size_t last = squares.size() - 1;
  edges.right.push_back(last);
  for (std::size_t i = 1; i < edges.right.front(); ++i) edges.lower.push_back(i);
  for (std::size_t i = edges.left.back() + 1; i < last; ++i) edges.upper.push_back(i);
  return edges;
}

Places reduce_curve(const std::vector<Square>& squares, double radius) {
  std::set<std::size_t> kept;
  std::size_t low = 0, high = squares.size() - 1;
  while (low < high) {
    const auto next_low = at_periphery(squares, low, low, high, radius);
    const auto next_high = at_periphery(squares, high, low, high, radius);
    if (!next_low || !next_high) break;
    kept.insert(*next_low);
    kept.insert(*next_high);
    low = *next_low;
    high = *next_high;
  }
  return {kept.begin(), kept.end()};
}

int edge_step(double radius) {
  return std::max(1, static_cast<int>(std::ceil(radius - kRoundingMm)));
}

std::vector<int> kept_rows(int low, int high, int step, MiddleRow rule) {
  std::set<int> rows;
  for (int lower = low + step, upper = high - step; valid_gap(upper - lower, rule);
       lower += step, upper -= step) {
    rows.insert(lower);
    rows.insert(upper);
  }
  return {rows.begin(), rows.end()};
}

Places reduce_rectangle(const std::vector<Square>& squares, double radius, MiddleRow rule) {
  const ElementEdges edges = find_edges(squares);
  const int step = edge_step(radius);
  const auto rows = kept_rows(squares[edges.left.front()].row, squares[edges.left.back()].row, step, rule);
  const auto columns =
      kept_rows(squares[edges.left.front()].column, squares[edges.right.front()].column, step, rule);
  Places kept;
  for (std::size_t i = 0; i < squares.size(); ++i) {
    if (in(rows, squares[i].row) && in(columns, squares[i].column)) kept.push_back(i);
  }
  return kept;
}

Places boundary_of(const std::vector<Square>& squares) {
  const std::set<Square> all(squares.begin(), squares.end());
  Places boundary;
  for (std::size_t i = 0; i < squares.size(); ++i) {
    const auto [column, row] = squares[i];
    const bool inner = all.count({column - 1, row}) && all.count({column + 1, row}) &&
                       all.count({column, row - 1}) && all.count({column, row + 1});
    if (!inner) boundary.push_back(i);
  }
  return boundary;
}

Places reduce_neighbours(const std::vector<Square>& squares) {
  const Places boundary = boundary_of(squares);
  Places kept;
  auto next = boundary.begin();
  for (std::size_t i = 0; i < squares.size(); ++i) {
    const bool on_boundary = next != boundary.end() && *next == i;
    if (on_boundary) ++next;
    if (on_boundary || (squares[i].column + squares[i].row) % 2 == 0) kept.push_back(i);
  }
  return kept;
}

Places reduce_area(const std::vector<Square>& squares, double radius) {
  const Places boundary = boundary_of(squares);
  Places candidates = boundary;
  for (const std::size_t i : reduce_neighbours(squares)) {
    if (!std::binary_search(boundary.begin(), boundary.end(), i)) candidates.push_back(i);
  }
  Kept kept(radius);
  Places places;
  for (const std::size_t i : candidates) {
    if (kept.has_near(squares[i])) continue;
    kept.add(squares[i]);
    places.push_back(i);
  }
  std::sort(places.begin(), places.end());
  return places;
}

}  // namespace clearcut::plan::grid
