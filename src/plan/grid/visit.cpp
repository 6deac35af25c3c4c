#include "plan/grid/visit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include "base/elementary.h"
#include "base/error.h"
#include "base/tolerances.h"
#include "plan/grid/interpolate.h"
#include "plan/grid/shape.h"

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

namespace {

/// The squares of one element, flags of those kept by the reduction, and the tool position for each.
struct Discrete {
  std::vector<Square> squares;
  std::vector<bool> reduced;
  std::vector<Vec2> at;
};

Discrete discrete(std::vector<Square> squares, const SquareGrid& grid) {
  Discrete result;
  result.reduced.assign(squares.size(), false);
  for (const Square s : squares) result.at.push_back(grid.center(s));
  result.squares = std::move(squares);
  return result;
}

void mark(Discrete& result, const Places& kept) {
  for (const std::size_t i : kept) result.reduced[i] = true;
}

/// Lines and arcs: the tool is at the point of the curve nearest to each square.
Discrete discrete_curve(const DesignElement& element, double tool_radius, const SquareGrid& grid) {
  Discrete result = discrete(interpolate(element, grid), grid);
  mark(result, reduce_curve(result.squares, tool_radius / grid.cell));
  const auto core = core_of(element, tool_radius);
  CLEARCUT_ASSERT(core.has_value());
  for (Vec2& at : result.at) at = nearest_point(*core, at);
  return result;
}

/// Holes and slots wider than the tool: squares in which the tool fits, reduced in two phases.
Discrete discrete_area(const DesignElement& element, double tool_radius, const SquareGrid& grid) {
  const Vec2 to = element.kind == ElementKind::kHole ? element.from : element.to;
  const double room = element.width / 2 - tool_radius;
  Discrete result = discrete(interpolate(element, grid), grid);
  Places legal;
  std::vector<Square> legal_squares;
  for (std::size_t i = 0; i < result.squares.size(); ++i) {
    const Vec2 p = result.at[i];
    const double away =
        element.from == to ? distance(element.from, p) : distance(Edge::line(element.from, to), p);
    if (away > room + kRoundingMm) continue;
    legal.push_back(i);
    legal_squares.push_back(result.squares[i]);
  }
  for (const std::size_t i : reduce_area(legal_squares, tool_radius / grid.cell))
    result.reduced[legal[i]] = true;
  return result;
}

/// Holes and slots as wide as the tool, or too narrow for any square: their axis, both ends included.
Discrete discrete_axis(const DesignElement& element, double tool_radius, const SquareGrid& grid) {
  const bool is_point = element.kind == ElementKind::kHole || element.from == element.to;
  const auto axis =
      is_point ? std::vector<Vec2>{element.from} : interpolate_line(element.from, element.to, grid.cell);
  Discrete result = discrete(activate(axis, grid), grid);
  mark(result, reduce_curve(result.squares, tool_radius / grid.cell));
  result.reduced.front() = result.reduced.back() = true;
  for (Vec2& at : result.at)
    at = is_point ? element.from : nearest_point(Edge::line(element.from, element.to), at);
  result.at.front() = element.from;
  if (!is_point) result.at.back() = element.to;
  return result;
}

Discrete discrete_of(const DesignElement& element, const ElementJob& job, const SquareGrid& grid) {
  const double radius = tool_of(job, element)->radius();
  if (element.kind == ElementKind::kLine || element.kind == ElementKind::kArc)
    return discrete_curve(element, radius, grid);
  if (element.kind == ElementKind::kRectangle) {
    Discrete result = discrete(interpolate(element, grid), grid);
    mark(result, reduce_rectangle(result.squares, radius / grid.cell, job.middle_row));
    return result;
  }
  Discrete result = discrete_area(element, radius, grid);
  const bool any = std::find(result.reduced.begin(), result.reduced.end(), true) != result.reduced.end();
  const bool wider = element.width > 2 * radius + kRoundingMm;
  return any && wider ? result : discrete_axis(element, radius, grid);
}

/// The edge from one point of an element to the next.
Edge step_between(Vec2 from, Vec2 to, const std::optional<Edge>& core) {
  if (!core || !core->is_arc()) return Edge::line(from, to);
  const bool left_about = cross(from - core->center, to - core->center) > 0;
  return Edge::arc(from, to, core->center, left_about ? Turn::kCounterClockwise : Turn::kClockwise);
}

Path path_through(const std::vector<Vec2>& points, const std::optional<Edge>& core) {
  Path path;
  Vec2 at = points.front();
  for (const Vec2 p : points) {
    if (distance(at, p) < kRoundingMm) continue;
    path.push_back(step_between(at, p, core));
    at = p;
  }
  if (path.empty()) path.push_back(Edge::line(at, at));
  return path;
}

std::vector<int> solved(const std::vector<Vec2>& points, const VisitSolver& solve) {
  if (points.size() < 2) return std::vector<int>(points.size(), 0);
  auto order = solve(points);
  CLEARCUT_ASSERT(order.size() == points.size());
  return order;
}

ElementVisit visit_element(std::size_t element, const ElementJob& job, const PointTable& table,
                           const VisitSolver& solve) {
  std::vector<std::size_t> reduced;
  std::vector<Vec2> at;
  for (std::size_t i = 0; i < table.points.size(); ++i) {
    const GridPoint& point = table.points[i];
    if (!point.reduced || point.element != static_cast<int>(element) + 1) continue;
    reduced.push_back(i);
    at.push_back(point.at);
  }
  ElementVisit visit{element, {}, {}};
  std::vector<Vec2> in_order;
  for (const int i : solved(at, solve)) {
    visit.points.push_back(reduced[static_cast<std::size_t>(i)]);
    in_order.push_back(at[static_cast<std::size_t>(i)]);
  }
  const auto& shape = job.elements[element];
  visit.path = path_through(in_order, core_of(shape, tool_of(job, shape)->radius()));
  return visit;
}

void turn_round(ElementVisit& visit) {
  std::reverse(visit.points.begin(), visit.points.end());
  if (visit.path.front().from != visit.path.front().to) visit.path = reversed(visit.path);
}

Vec2 entry(const ElementVisit& visit, std::size_t turned) {
  return turned == 0 ? visit.path.front().from : visit.path.back().to;
}

/// Reverses visits to make the total of the paths between them shortest: a shortest path over both directions
/// of each.
void choose_directions(std::vector<ElementVisit>& visits) {
  std::vector<std::array<std::size_t, 2>> before(visits.size());
  std::array<double, 2> cost{0, 0};
  for (std::size_t i = 1; i < visits.size(); ++i) {
    std::array<double, 2> next{};
    for (const std::size_t turned : {0u, 1u}) {
      const auto length_from = [&](std::size_t previous) {
        return cost[previous] + distance(entry(visits[i - 1], 1 - previous), entry(visits[i], turned));
      };
      before[i][turned] = length_from(1) < length_from(0) ? 1 : 0;
      next[turned] = length_from(before[i][turned]);
    }
    cost = next;
  }
  std::size_t turned = cost[1] < cost[0] ? 1 : 0;
  for (std::size_t i = visits.size(); i-- > 0;) {
    const std::size_t earlier = before[i][turned];
    if (turned == 1) turn_round(visits[i]);
    turned = earlier;
  }
}

/// The elements of one tool in the order of their visits.
std::vector<ElementVisit> visit_tool(int tool, const ElementJob& job, const PointTable& table,
                                     const VisitSolver& solve) {
  std::vector<ElementVisit> visits;
  std::vector<Vec2> centers;
  for (std::size_t i = 0; i < job.elements.size(); ++i) {
    if (job.elements[i].tool != tool) continue;
    visits.push_back(visit_element(i, job, table, solve));
    centers.push_back(box(visits.back().path).center());
  }
  std::vector<ElementVisit> in_order;
  for (const int i : solved(centers, solve))
    in_order.push_back(std::move(visits[static_cast<std::size_t>(i)]));
  if (!in_order.empty()) choose_directions(in_order);
  return in_order;
}

}  // namespace

PointTable tabulate(const ElementJob& job) {
  PointTable table{grid_of(job), {}};
  for (std::size_t e = 0; e < job.elements.size(); ++e) {
    const auto& element = job.elements[e];
    const Discrete points = discrete_of(element, job, table.grid);
    for (std::size_t i = 0; i < points.squares.size(); ++i)
      table.points.push_back(
          {static_cast<int>(e) + 1, element.tool, points.squares[i], points.at[i], points.reduced[i], -1});
  }
  return table;
}

std::vector<ElementVisit> plan_visits(const ElementJob& job, PointTable& table, const VisitSolver& solve) {
  std::vector<ElementVisit> visits;
  for (const auto& tool : job.tools) {
    for (auto& visit : visit_tool(tool.number, job, table, solve)) visits.push_back(std::move(visit));
  }
  int place = 0;
  for (const auto& visit : visits) {
    for (const std::size_t i : visit.points) table.points[i].visit = ++place;
  }
  return visits;
}

}  // namespace clearcut::plan::grid
