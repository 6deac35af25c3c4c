#include "geometry/voronoi/exact_nodes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/tolerances.h"
#include "geometry/voronoi/index.h"

namespace clearcut::inline geometry::voronoi {
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
