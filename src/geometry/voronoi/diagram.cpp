#include "geometry/voronoi/diagram.h"

#include <algorithm>
#include <array>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <limits>

namespace clearcut::voronoi {
namespace {

using BoostDiagram = boost::polygon::voronoi_diagram<double>;
using boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT;

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

/// Nodes nearer to the boundary than this many grid units have no trustworthy side; they count as on it.
constexpr double kOnBoundaryUnits = 2;
/// mm. Spread of the exact distances at a node below which it is solved.
constexpr double kSolved = 1e-9;
/// mm. Arcs whose centres and radii agree to this are of one circle.
constexpr double kSameCircle = 1e-6;

class Maker {
 public:
  explicit Maker(Sites sites) { out_.sites = std::move(sites); }

  Diagram run() {
    build();
    find_sides();
    correct_nodes();
    find_criticals();
    for (std::size_t i = 0; i < out_.nodes.size(); ++i) {
      if (out_.inside[i] != 0) out_.largest = std::max(out_.largest, out_.nodes[i].clearance);
    }
    return std::move(out_);
  }

 private:
  enum Side : char { kUnknown, kInside, kOutside, kOn };

  const Segment& segment(int i) const { return out_.sites.segments[index(i)]; }
  const Grid& grid() const { return out_.sites.grid; }

  void build() {
    boost::polygon::voronoi_builder<std::int32_t> builder;
    for (const Segment& s : out_.sites.segments) builder.insert_segment(s.from.x, s.from.y, s.to.x, s.to.y);
    BoostDiagram diagram;
    builder.construct(&diagram);
    copy_nodes(diagram);
    copy_edges(diagram);
    copy_cells(diagram);
  }

  void copy_nodes(const BoostDiagram& diagram) {
    out_.nodes.reserve(diagram.num_vertices());
    for (const auto& v : diagram.vertices()) out_.nodes.push_back({grid().to_mm(v.x(), v.y()), 0});
  }

  void copy_edges(const BoostDiagram& diagram) {
    const auto* first_edge = diagram.edges().data();
    const auto* first_vertex = diagram.vertices().data();
    const auto* first_cell = diagram.cells().data();
    out_.origin.reserve(diagram.num_edges());
    out_.next.reserve(diagram.num_edges());
    out_.cell.reserve(diagram.num_edges());
    for (const auto& e : diagram.edges()) {
      out_.origin.push_back(e.vertex0() != nullptr ? static_cast<int>(e.vertex0() - first_vertex) : -1);
      out_.next.push_back(static_cast<int>(e.next() - first_edge));
      out_.cell.push_back(static_cast<int>(e.cell() - first_cell));
    }
  }

  void copy_cells(const BoostDiagram& diagram) {
    const auto* first_edge = diagram.edges().data();
    for (const auto& c : diagram.cells()) {
      const int source = static_cast<int>(c.source_index());
      const Segment& s = segment(source);
      const bool at_start = c.source_category() == SOURCE_CATEGORY_SEGMENT_START_POINT;
      out_.cell_start.push_back(c.is_degenerate() ? -1 : static_cast<int>(c.incident_edge() - first_edge));
      out_.cell_segment.push_back(c.contains_segment() ? source : -1);
      out_.cell_element.push_back(c.contains_segment() ? s.element
                                  : at_start           ? s.from_element
                                                       : s.to_element);
      out_.cell_back.push_back(c.contains_segment() ? s.back_element : -1);
      points_.push_back(c.contains_segment() ? s.from : at_start ? s.from : s.to);
    }
  }

  // --- inside or outside ---

  double grid_distance(int cell, Vec2 p) const {
    const int s = out_.cell_segment[index(cell)];
    if (s < 0) return norm(p - grid().to_mm(points_[index(cell)]));
    const Vec2 a = grid().to_mm(segment(s).from), b = grid().to_mm(segment(s).to);
    return std::abs(cross(b - a, p - a)) / norm(b - a);
  }

  void find_sides() {
    sides_.assign(out_.nodes.size(), kUnknown);
    // Measured against a segment where there is one; point cells serve for the clearance only.
    for (std::size_t h = 0; h < out_.origin.size(); ++h) {
      const int v = out_.origin[h], cell = out_.cell[h];
      if (v < 0) continue;
      Node& node = out_.nodes[index(v)];
      if (sides_[index(v)] == kUnknown) {
        node.clearance = grid_distance(cell, node.point);
        if (node.clearance <= kOnBoundaryUnits * grid().unit) sides_[index(v)] = kOn;
      }
      if (sides_[index(v)] != kUnknown || out_.cell_segment[index(cell)] < 0 ||
          out_.cell_back[index(cell)] >= 0)
        continue;
      const Segment& s = segment(out_.cell_segment[index(cell)]);
      const Vec2 a = grid().to_mm(s.from), b = grid().to_mm(s.to);
      sides_[index(v)] = cross(b - a, node.point - a) > 0 ? kInside : kOutside;
    }
    spread_sides();
    out_.inside.resize(sides_.size());
    for (std::size_t i = 0; i < sides_.size(); ++i) out_.inside[i] = sides_[i] == kInside ? 1 : 0;
  }

  /// Nodes among points and doubled walls only take the side of a neighbour across edges that keep clear of
  /// the boundary.
  void spread_sides() {
    std::vector<int> queue;
    for (std::size_t h = 0; h < out_.origin.size(); ++h) {
      const int v = out_.origin[h];
      if (v >= 0 && (sides_[index(v)] == kInside || sides_[index(v)] == kOutside))
        queue.push_back(static_cast<int>(h));
    }
    if (std::find(sides_.begin(), sides_.end(), kUnknown) == sides_.end()) return;
    while (!queue.empty()) {
      const int h = queue.back();
      queue.pop_back();
      const int v = out_.origin[index(h)], w = out_.origin[index(Diagram::twin(h))];
      if (w < 0 || sides_[index(w)] != kUnknown || runs_through_point(h)) continue;
      sides_[index(w)] = sides_[index(v)];
      const int start = Diagram::twin(h);
      int around = start;
      do {
        queue.push_back(around);
        around = out_.next[index(Diagram::twin(around))];
      } while (around != start);
    }
  }

  /// The end point shared by the two cells of a half-edge when one is a segment and the other its end.
  bool is_secondary(int h, GridPoint& end) const {
    int a = out_.cell[index(h)], b = out_.cell[index(Diagram::twin(h))];
    if (out_.cell_segment[index(a)] < 0) std::swap(a, b);
    const int s = out_.cell_segment[index(a)];
    if (s < 0 || out_.cell_segment[index(b)] >= 0) return false;
    end = points_[index(b)];
    return end == segment(s).from || end == segment(s).to;
  }

  /// A segment's edge with its own end point may run through that point, from one side of the wall to the
  /// other.
  bool runs_through_point(int h) const {
    GridPoint end;
    if (!is_secondary(h, end)) return false;
    const int v = out_.origin[index(h)], w = out_.origin[index(Diagram::twin(h))];
    if (v < 0 || w < 0) return true;
    const Vec2 p = grid().to_mm(end);
    return dot(out_.nodes[index(v)].point - p, out_.nodes[index(w)].point - p) < 0;
  }

  // --- exact places ---

  struct Around {
    std::array<int, 6> elements;
    int count = 0;
    void add(int element) {
      for (int i = 0; i < count; ++i) {
        if (elements[index(i)] == element) return;
      }
      if (count < 6) elements[index(count++)] = element;
    }
  };

  Around elements_around(int first, Vec2 p) const {
    Around around;
    int h = first;
    do {
      around.add(out_.element_near(out_.cell[index(h)], p));
      h = out_.next[index(Diagram::twin(h))];
    } while (h != first);
    return around;
  }

  void correct_nodes() {
    std::vector<char> done(out_.nodes.size(), 0);
    for (std::size_t h = 0; h < out_.origin.size(); ++h) {
      const int v = out_.origin[h];
      if (v < 0 || done[index(v)] != 0 || out_.inside[index(v)] == 0) continue;
      done[index(v)] = 1;
      Node& node = out_.nodes[index(v)];
      node = exact_node(elements_around(static_cast<int>(h), node.point), node.point);
    }
  }

  Node exact_node(const Around& around, Vec2 start) const {
    const Element& first = out_.element(around.elements[0]);
    if (is_one_circle(around)) return {first.edge.center, first.radius};
    if (around.count == 1) return {start, distance(first, start)};
    Node best{start, 0};
    double best_spread = std::numeric_limits<double>::infinity();
    Vec2 p = start;
    for (int step = 0; step < 6; ++step) {
      const auto [low, high] = distance_range(around, p);
      if (high - low < best_spread) {
        best_spread = high - low;
        best = {p, low};
      }
      if (best_spread <= kSolved) break;
      p = p + newton_step(around, p);
    }
    return best;
  }

  /// Whether only concave arcs of one circle meet: all that the diagram shows there is how the arc was cut.
  bool is_one_circle(const Around& around) const {
    const Element& first = out_.element(around.elements[0]);
    for (int i = 0; i < around.count; ++i) {
      const Element& e = out_.element(around.elements[index(i)]);
      if (e.wall != Wall::kConcave || std::abs(e.radius - first.radius) > kSameCircle ||
          norm(e.edge.center - first.edge.center) > kSameCircle) {
        return false;
      }
    }
    return true;
  }

  std::pair<double, double> distance_range(const Around& around, Vec2 p) const {
    double low = std::numeric_limits<double>::infinity(), high = 0;
    for (int i = 0; i < around.count; ++i) {
      const double d = distance(out_.element(around.elements[index(i)]), p);
      low = std::min(low, d);
      high = std::max(high, d);
    }
    return {low, high};
  }

  /// Damped least squares on "all distances equal": the shortest step where walls leave a direction free.
  Vec2 newton_step(const Around& around, Vec2 p) const {
    const Element& first = out_.element(around.elements[0]);
    const double d0 = distance(first, p);
    const Vec2 g0 = away_from(first, p);
    double xx = 0, xy = 0, yy = 0;
    Vec2 right;
    for (int i = 1; i < around.count; ++i) {
      const Element& other = out_.element(around.elements[index(i)]);
      const Vec2 g = away_from(other, p) - g0;
      const double f = distance(other, p) - d0;
      xx += g.x * g.x;
      xy += g.x * g.y;
      yy += g.y * g.y;
      right = right - g * f;
    }
    const double damping = 1e-9 * (xx + yy) + 1e-15;
    xx += damping;
    yy += damping;
    const double det = xx * yy - xy * xy;
    return Vec2{yy * right.x - xy * right.y, xx * right.y - xy * right.x} / det;
  }

  void find_criticals() {
    out_.critical.assign(index(out_.edge_count()), -1);
    for (int k = 0; k < out_.edge_count(); ++k) {
      const int v = out_.origin[index(2 * k)], w = out_.origin[index(2 * k + 1)];
      const bool any_inside =
          (v >= 0 && out_.inside[index(v)] != 0) || (w >= 0 && out_.inside[index(w)] != 0);
      if (any_inside) find_critical(k, v, w);
    }
  }

  void find_critical(int k, int v, int w) {
    GridPoint end;
    if (is_secondary(2 * k, end)) {
      if (runs_through_point(2 * k)) add_critical(k, {grid().to_mm(end), 0});
      return;
    }
    if (v < 0 || w < 0) return;
    const Vec2 p = out_.nodes[index(v)].point, q = out_.nodes[index(w)].point, middle = lerp(p, q, 0.5);
    const int a = out_.element_near(out_.cell[index(2 * k)], middle);
    const int b = out_.element_near(out_.cell[index(2 * k + 1)], middle);
    if (a == b) return;
    if (const auto found = critical_between(out_.element(a), out_.element(b), p, q)) {
      add_critical(k, {found->point, found->clearance});
    }
  }

  void add_critical(int k, Node node) {
    out_.critical[index(k)] = static_cast<int>(out_.nodes.size());
    out_.nodes.push_back(node);
    out_.inside.push_back(node.clearance > 0 ? 1 : 0);
  }

  Diagram out_;
  std::vector<GridPoint> points_;  ///< of each point cell
  std::vector<char> sides_;
};

}  // namespace

int Diagram::element_near(int cell_index, Vec2 p) const {
  const auto i = static_cast<std::size_t>(cell_index);
  if (cell_back[i] < 0) return cell_element[i];
  const Segment& s = sites.segments[static_cast<std::size_t>(cell_segment[i])];
  const Vec2 a = sites.grid.to_mm(s.from), b = sites.grid.to_mm(s.to);
  return cross(b - a, p - a) >= 0 ? cell_element[i] : cell_back[i];
}

Diagram make_diagram(Sites sites) {
  return Maker(std::move(sites)).run();
}

}  // namespace clearcut::voronoi
