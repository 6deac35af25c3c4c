#include "geometry/voronoi/diagram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/tolerances.h"
#include "geometry/voronoi/builder.h"

namespace clearcut::inline geometry::voronoi {
namespace {

using BoostDiagram = boost::polygon::voronoi_diagram<double>;
using boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT;

/// Nodes nearer to the boundary than this many grid units have no trustworthy side; they count as on it.
constexpr double kOnBoundaryUnits = 2;

class Maker {
 public:
  Maker(Sites sites, const Region& region) : region_(region) {
    out_.doubtful.insert(sites.met.begin(), sites.met.end());
    out_.sites = std::move(sites);
  }

  Diagram run() {
    build();
    find_sides();
    correct_nodes(out_);
    find_criticals();
    for (std::size_t i = 0; i < out_.nodes.size(); ++i) {
      if (out_.inside[i] != 0) out_.largest = std::max(out_.largest, out_.nodes[i].clearance);
    }
    return std::move(out_);
  }

 private:
  const Segment& segment(int i) const { return out_.sites.segments[index(i)]; }
  const Grid& grid() const { return out_.sites.grid; }

  void build() {
    const LatticePoint away = distance_from_axes();
    BoostDiagram diagram;
    construct(away, diagram);
    copy_nodes(diagram, away);
    copy_edges(diagram);
    copy_cells(diagram);
  }

  /// The builder and its list of events are gone before anything is copied.
  void construct(LatticePoint away, BoostDiagram& diagram) const {
    VoronoiBuilder builder;
    for (const Segment& s : out_.sites.segments) {
      builder.insert_segment(s.from.x + away.x, s.from.y + away.y, s.to.x + away.x, s.to.y + away.y);
    }
    builder.construct(&diagram);
  }

  /// Moves the sites as far from both axes as they extend: the builder's decisions by relative errors are then alike
  /// everywhere.
  LatticePoint distance_from_axes() const {
    LatticePoint low = out_.sites.segments.front().from, high = low;
    for (const Segment& s : out_.sites.segments) {
      low = {std::min({low.x, s.from.x, s.to.x}), std::min({low.y, s.from.y, s.to.y})};
      high = {std::max({high.x, s.from.x, s.to.x}), std::max({high.y, s.from.y, s.to.y})};
    }
    const std::int32_t extent = std::max(high.x - low.x, high.y - low.y);
    return {extent - low.x, extent - low.y};
  }

  void copy_nodes(const BoostDiagram& diagram, LatticePoint away) {
    out_.nodes.reserve(diagram.num_vertices());
    for (const auto& v : diagram.vertices()) {
      out_.nodes.push_back({grid().to_mm(v.x() - away.x, v.y() - away.y), 0});
    }
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
    measure_nodes();
    out_.inside.assign(out_.nodes.size(), 0);
    std::vector<char> seen(out_.nodes.size(), 0);
    for (std::size_t h = 0; h < out_.origin.size(); ++h) {
      const int v = out_.origin[h];
      if (v < 0 || seen[index(v)] != 0 || is_on_boundary(v)) continue;
      const std::vector<int> face = face_from(static_cast<int>(h), seen);
      if (!is_inside(face)) continue;
      for (const int half_edge : face) out_.inside[index(out_.origin[index(half_edge)])] = 1;
    }
  }

  void measure_nodes() {
    for (std::size_t h = 0; h < out_.origin.size(); ++h) {
      if (out_.origin[h] < 0) continue;
      Node& node = out_.nodes[index(out_.origin[h])];
      node.clearance = grid_distance(out_.cell[h], node.point);
    }
  }

  bool is_on_boundary(int v) const {
    return out_.nodes[index(v)].clearance <= kOnBoundaryUnits * grid().unit;
  }

  /// One half-edge out of each node of the connected area around the start of h: Voronoi edges never cross a segment,
  /// except through its end points.
  std::vector<int> face_from(int h, std::vector<char>& seen) const {
    std::vector<int> face{h};
    seen[index(out_.origin[index(h)])] = 1;
    for (std::size_t i = 0; i < face.size(); ++i) {
      int around = face[i];
      do {
        const int w = out_.origin[index(Diagram::twin(around))];
        if (w >= 0 && seen[index(w)] == 0 && !is_on_boundary(w) && !runs_through_point(around)) {
          seen[index(w)] = 1;
          face.push_back(Diagram::twin(around));
        }
        around = out_.next[index(Diagram::twin(around))];
      } while (around != face[i]);
    }
    return face;
  }

  /// Decided by the direction of the segments around the face; if they disagree (crossings caused by rounding, walls
  /// of no thickness), by a test of the region itself at the place of largest clearance.
  bool is_inside(const std::vector<int>& face) const {
    bool any_left = false, any_right = false;
    int widest = out_.origin[index(face.front())];
    for (const int h : face) {
      const int v = out_.origin[index(h)];
      if (out_.nodes[index(v)].clearance > out_.nodes[index(widest)].clearance) widest = v;
      int around = h;
      do {
        const int s = out_.cell_segment[index(out_.cell[index(around)])];
        around = out_.next[index(Diagram::twin(around))];
        if (s < 0 || segment(s).back_element >= 0) continue;
        (is_left(segment(s), out_.nodes[index(v)].point) ? any_left : any_right) = true;
      } while (around != h);
    }
    if (any_left != any_right) return any_left;
    return region_.contains(out_.nodes[index(widest)].point);
  }

  bool is_left(const Segment& s, Vec2 p) const {
    const Vec2 a = grid().to_mm(s.from), b = grid().to_mm(s.to);
    return cross(b - a, p - a) > 0;
  }

  /// The end point shared by the two cells of a half-edge when one is a segment and the other its end.
  bool is_secondary(int h, LatticePoint& end) const {
    int a = out_.cell[index(h)], b = out_.cell[index(Diagram::twin(h))];
    if (out_.cell_segment[index(a)] < 0) std::swap(a, b);
    const int s = out_.cell_segment[index(a)];
    if (s < 0 || out_.cell_segment[index(b)] >= 0) return false;
    end = points_[index(b)];
    return end == segment(s).from || end == segment(s).to;
  }

  /// A segment's edge with its own end point may pass through that point to the other side of the wall.
  bool runs_through_point(int h) const {
    LatticePoint end;
    if (!is_secondary(h, end)) return false;
    const int v = out_.origin[index(h)], w = out_.origin[index(Diagram::twin(h))];
    if (v < 0 || w < 0) return true;
    const Vec2 p = grid().to_mm(end);
    return dot(out_.nodes[index(v)].point - p, out_.nodes[index(w)].point - p) < 0;
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
    LatticePoint end;
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

  const Region& region_;
  Diagram out_;
  std::vector<LatticePoint> points_;  ///< point of each point cell
};

}  // namespace

int Diagram::element_near(int cell_index, Vec2 p) const {
  const auto i = static_cast<std::size_t>(cell_index);
  if (cell_back[i] < 0) return cell_element[i];
  const Segment& s = sites.segments[static_cast<std::size_t>(cell_segment[i])];
  const Vec2 a = sites.grid.to_mm(s.from), b = sites.grid.to_mm(s.to);
  return cross(b - a, p - a) >= 0 ? cell_element[i] : cell_back[i];
}

Diagram make_diagram(Sites sites, const Region& region) {
  return Maker(std::move(sites), region).run();
}

namespace {

/// Greatest error of a node, in grid units.
constexpr double kMostUnitsMoved = 20;
/// mm. A node is solved if the spread of its exact distances is below this.
constexpr double kSolved = 1e-9;
/// mm. A wall nearer than a node's own by more than this is an error.
constexpr double kNearer = 1e-4;

/// The elements around a node.
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

class Corrector {
 public:
  explicit Corrector(Diagram& diagram) : diagram_(diagram) {}

  void run() {
    find_open_centers();
    std::vector<char> done(diagram_.nodes.size(), 0);
    for (std::size_t h = 0; h < diagram_.origin.size(); ++h) {
      const int v = diagram_.origin[h];
      if (v < 0 || done[index(v)] != 0 || diagram_.inside[index(v)] == 0) continue;
      done[index(v)] = 1;
      correct_node(static_cast<int>(h), diagram_.nodes[index(v)]);
    }
  }

 private:
  // --- exact places ---

  Around elements_around(int first, Vec2 p) const {
    Around around;
    int h = first;
    do {
      around.add(diagram_.element_near(diagram_.cell[index(h)], p));
      h = diagram_.next[index(Diagram::twin(h))];
    } while (h != first);
    return around;
  }

  void correct_node(int h, Node& node) {
    const Around around = elements_around(h, node.point);
    const Node corrected = corrected_node(around, node.point);
    const auto [low, high] = distance_range(around, corrected.point);
    const bool solved = high - low <= kNearer && (around.count > 1 || corrected.point != node.point);
    const bool far = norm(corrected.point - node.point) > farthest_move(around, corrected.clearance);
    const int nearer = nearer_element_nearby(h, corrected);
    if (!solved || far || nearer >= 0) doubt(around, nearer);
    node = !far && nearer < 0 ? corrected : unmoved(around, node.point);
  }

  /// Greatest error of a node: the rounding of its sites to the grid and, with arcs, the error of their tangents.
  /// (Nearly parallel walls determine a node less well: there the node stays unchanged.)
  double farthest_move(const Around& around, double clearance) const {
    double reach = kMostUnitsMoved * diagram_.sites.grid.unit;
    for (int i = 0; i < around.count; ++i) {
      const Element& e = diagram_.element(around.elements[index(i)]);
      if (e.edge.is_arc())
        reach = std::max(reach, 4 * std::sqrt(diagram_.sites.error * std::max(clearance, e.radius)));
    }
    return reach;
  }

  void doubt(const Around& around, int nearer) {
    for (int i = 0; i < around.count; ++i) diagram_.doubtful.insert(around.elements[index(i)]);
    if (nearer >= 0) diagram_.doubtful.insert(nearer);
  }

  /// For each concave arc, whether its centre is nowhere nearer to one of the walls next to it in the
  /// diagram.
  void find_open_centers() {
    center_open_.assign(diagram_.sites.elements.size(), 1);
    for (std::size_t h = 0; h < diagram_.origin.size(); ++h) {
      const int a = diagram_.cell_element[index(diagram_.cell[h])];
      const Element& arc = diagram_.element(a);
      if (arc.wall != Wall::kConcave || center_open_[index(a)] == 0) continue;
      const int twin = Diagram::twin(static_cast<int>(h));
      const int v = diagram_.origin[h], w = diagram_.origin[index(twin)];
      const int inside = v >= 0 && diagram_.inside[index(v)] != 0 ? v : w;
      if (inside < 0 || diagram_.inside[index(inside)] == 0) continue;
      const int b = diagram_.element_near(diagram_.cell[index(twin)], diagram_.nodes[index(inside)].point);
      if (b == a) continue;
      center_open_[index(a)] =
          distance(diagram_.element(b), arc.edge.center) >= arc.radius - kSamePlaceMm ? 1 : 0;
    }
  }

  /// An element at the neighbouring nodes that is nearer to a corrected node than its own; -1 if there is none.
  int nearer_element_nearby(int first, const Node& node) const {
    int h = first;
    do {
      const int beyond = diagram_.cell[index(Diagram::twin(diagram_.next[index(h)]))];
      const int element = diagram_.element_near(beyond, node.point);
      if (distance(diagram_.element(element), node.point) < node.clearance - kNearer) return element;
      h = diagram_.next[index(Diagram::twin(h))];
    } while (h != first);
    return -1;
  }

  Node unmoved(const Around& around, Vec2 p) const { return {p, distance_range(around, p).first}; }

  Node corrected_node(const Around& around, Vec2 start) const {
    if (const Element* arc = common_center(around, start)) return {arc->edge.center, arc->radius};
    if (around.count == 1) return unmoved(around, start);
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

  /// An arc's centre equally far from all elements around the node (the arc's own pieces and walls that continue the
  /// arc smoothly). The place of the node in the diagram is then an accident of rounding.
  const Element* common_center(const Around& around, Vec2 p) const {
    for (int i = 0; i < around.count; ++i) {
      const int id = around.elements[index(i)];
      const Element& arc = diagram_.element(id);
      if (arc.wall != Wall::kConcave || center_open_[index(id)] == 0) continue;
      if (norm(p - arc.edge.center) > arc.radius / 2) continue;
      const auto [low, high] = distance_range(around, arc.edge.center);
      if (high - low <= kNearer) return &arc;
    }
    return nullptr;
  }

  std::pair<double, double> distance_range(const Around& around, Vec2 p) const {
    double low = std::numeric_limits<double>::infinity(), high = 0;
    for (int i = 0; i < around.count; ++i) {
      const double d = distance(diagram_.element(around.elements[index(i)]), p);
      low = std::min(low, d);
      high = std::max(high, d);
    }
    return {low, high};
  }

  /// Damped least squares on "all distances equal": the shortest step if the walls leave a direction free.
  Vec2 newton_step(const Around& around, Vec2 p) const {
    const Element& first = diagram_.element(around.elements[0]);
    const double d0 = distance(first, p);
    const Vec2 g0 = away_from(first, p);
    double xx = 0, xy = 0, yy = 0;
    Vec2 right;
    for (int i = 1; i < around.count; ++i) {
      const Element& other = diagram_.element(around.elements[index(i)]);
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

  Diagram& diagram_;
  std::vector<char> center_open_;  ///< per element: whether its centre is open
};

}  // namespace

void correct_nodes(Diagram& diagram) {
  Corrector(diagram).run();
}

}  // namespace clearcut::inline geometry::voronoi
