#include "geometry/voronoi/axis.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>

#include "base/containers.h"
#include "base/tolerances.h"
#include "geometry/voronoi/diagram.h"

namespace clearcut::inline geometry::voronoi {
namespace {

/// Radians. Walls meeting at a smaller turn count as one wall.
constexpr double kSmoothTurn = 1e-3;

class AxisMaker {
 public:
  explicit AxisMaker(const Diagram& diagram) : d_(diagram), sets_(static_cast<int>(diagram.nodes.size())) {}

  Axis run() {
    for_each_stretch([this](int, int a, int b) {
      if (inside(a) && inside(b) && norm(node(a).point - node(b).point) <= kSamePlaceMm) sets_.join(b, a);
    });
    mark_peaks();
    point_of_.assign(d_.nodes.size(), -1);
    for_each_stretch([this](int k, int a, int b) { add_stretch(k, a, b); });
    for (std::size_t i = 0; i < d_.nodes.size(); ++i) {
      // Round pockets: all edges separate the wall from itself; only the centre is left.
      const int v = static_cast<int>(i);
      if (inside(v) && sets_.find(v) == v && peak_[i] != 0) point(v);
    }
    axis_.incident.resize(axis_.graph.points.size());
    for (std::size_t i = 0; i < axis_.graph.edges.size(); ++i) {
      axis_.incident[index(axis_.graph.edges[i].a)].push_back(static_cast<int>(i));
      axis_.incident[index(axis_.graph.edges[i].b)].push_back(static_cast<int>(i));
    }
    return std::move(axis_);
  }

 private:
  const Node& node(int i) const { return d_.nodes[index(i)]; }
  bool inside(int i) const { return d_.inside[index(i)] != 0; }

  /// Calls visit(edge, a, b) for the monotone parts with at least one end inside.
  template <class Visit>
  void for_each_stretch(Visit visit) const {
    for (int k = 0; k < d_.edge_count(); ++k) {
      const int v = d_.origin[index(2 * k)], w = d_.origin[index(2 * k + 1)], middle = d_.critical[index(k)];
      if (middle < 0) {
        if (v >= 0 && w >= 0 && (inside(v) || inside(w))) visit(k, v, w);
        continue;
      }
      if (v >= 0 && (inside(v) || inside(middle))) visit(k, v, middle);
      if (w >= 0 && (inside(w) || inside(middle))) visit(k, middle, w);
    }
  }

  void mark_peaks() {
    peak_.assign(d_.nodes.size(), 1);
    for_each_stretch([this](int, int a, int b) {
      const int p = sets_.find(a), q = sets_.find(b);
      if (p == q) return;
      peak_[index(node(p).clearance < node(q).clearance ? p : q)] = 0;
    });
  }

  void add_stretch(int k, int a, int b) {
    if (sets_.find(a) == sets_.find(b)) return;
    const Vec2 middle = lerp(node(a).point, node(b).point, 0.5);
    const Walls walls{d_.element_near(d_.cell[index(2 * k)], middle),
                      d_.element_near(d_.cell[index(2 * k + 1)], middle)};
    if (divides_one_wall(walls, middle)) return;
    const int p = point(a), q = point(b);
    axis_.graph.edges.push_back({p, q});
    axis_.walls.push_back(walls);
  }

  int point(int v) {
    const int root = sets_.find(v);
    if (point_of_[index(root)] < 0) {
      point_of_[index(root)] = static_cast<int>(axis_.graph.points.size());
      axis_.graph.points.push_back({node(root).point, inside(root) ? node(root).clearance : 0.0});
    }
    return point_of_[index(root)];
  }

  bool divides_one_wall(Walls walls, Vec2 middle) const {
    if (walls.a == walls.b) return true;
    const Element &a = d_.element(walls.a), &b = d_.element(walls.b);
    if (a.is_point() && b.is_point()) return false;
    if (a.is_point()) return is_end(b, a.edge.from);
    if (b.is_point()) return is_end(a, b.edge.from);
    return smoothly_joined(a, b, middle) || smoothly_joined(b, a, middle);
  }

  static bool is_end(const Element& edge, Vec2 p) { return edge.edge.from == p || edge.edge.to == p; }

  /// Whether b continues a without a corner and `middle` is on the normal at their joint.
  static bool smoothly_joined(const Element& a, const Element& b, Vec2 middle) {
    if (a.edge.to != b.edge.from) return false;
    if (std::abs(cross(a.edge.tangent_at(1), b.edge.tangent_at(0))) > kSmoothTurn) return false;
    const double clearance = distance(a, middle);
    return norm(middle - a.edge.to) - clearance <= 1e-6 * (1 + clearance);
  }

  const Diagram& d_;
  DisjointSets sets_;
  std::vector<char> peak_;
  std::vector<int> point_of_;
  Axis axis_;
};

/// Peaks of the graph by flooding from the top.
class PeakFinder {
 public:
  PeakFinder(const Axis& axis, const Diagram& diagram, double prominence)
      : axis_(axis), d_(diagram), prominence_(prominence), sets_(axis.graph.points.size()) {}

  std::vector<AxisPoint> run() {
    const std::size_t n = axis_.graph.points.size();
    std::vector<int> order(n);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [this](int a, int b) { return clearance(a) > clearance(b); });
    flooded_.assign(n, 0);
    for (const int p : order) flood(p);
    for (std::size_t i = 0; i < n; ++i) {
      if (sets_.find(static_cast<int>(i)) == static_cast<int>(i)) peaks_.push_back(static_cast<int>(i));
    }
    std::vector<AxisPoint> centers;
    for (const int peak : peaks_) {
      if (clearance(peak) > prominence_) centers.push_back(middle_of_plateau(peak));
    }
    std::stable_sort(centers.begin(), centers.end(),
                     [](const AxisPoint& a, const AxisPoint& b) { return a.clearance > b.clearance; });
    return centers;
  }

 private:
  double clearance(int p) const { return axis_.graph.points[index(p)].clearance; }
  int other_end(int edge, int p) const {
    const AxisEdge& e = axis_.graph.edges[index(edge)];
    return e.a == p ? e.b : e.a;
  }
  double length(int edge) const {
    const AxisEdge& e = axis_.graph.edges[index(edge)];
    return norm(axis_.graph.points[index(e.a)].point - axis_.graph.points[index(e.b)].point);
  }

  /// Every set is represented by its peak.
  void flood(int p) {
    flooded_[index(p)] = 1;
    for (const int edge : axis_.incident[index(p)]) {
      const int q = other_end(edge, p);
      if (flooded_[index(q)] == 0) continue;
      int high = sets_.find(q), low = sets_.find(p);
      if (high == low) continue;
      if (clearance(high) < clearance(low)) std::swap(high, low);
      if (clearance(low) - clearance(p) > prominence_) peaks_.push_back(low);
      sets_.join(low, high);
    }
  }

  struct Walk {
    std::vector<double> distance;
    std::vector<int> came_by;
    int farthest = 0;
  };

  /// Shortest paths from `start` over the plateau.
  Walk walk_from(int start, double floor) const {
    Walk walk;
    walk.farthest = start;
    std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> queue;
    walk.distance.assign(axis_.graph.points.size(), -1);
    walk.came_by.assign(axis_.graph.points.size(), -1);
    walk.distance[index(start)] = 0;
    queue.push({0, start});
    while (!queue.empty()) {
      const auto [d, p] = queue.top();
      queue.pop();
      if (d > walk.distance[index(p)]) continue;
      walk.farthest = p;
      for (const int edge : axis_.incident[index(p)]) {
        const int q = other_end(edge, p);
        const double via = d + length(edge);
        if (clearance(q) < floor || (walk.distance[index(q)] >= 0 && walk.distance[index(q)] <= via))
          continue;
        walk.distance[index(q)] = via;
        walk.came_by[index(q)] = edge;
        queue.push({via, q});
      }
    }
    return walk;
  }

  AxisPoint middle_of_plateau(int peak) const {
    const double floor = clearance(peak) - prominence_;
    const int one_end = walk_from(peak, floor).farthest;
    const Walk walk = walk_from(one_end, floor);
    const double half = walk.distance[index(walk.farthest)] / 2;
    int p = walk.farthest;
    while (p != one_end) {
      const int edge = walk.came_by[index(p)], before = other_end(edge, p);
      if (walk.distance[index(before)] <= half)
        return between(before, p, edge, half - walk.distance[index(before)]);
      p = before;
    }
    return axis_.graph.points[index(p)];
  }

  /// The place `along` mm from p towards q; on curved edges the nearer end.
  AxisPoint between(int p, int q, int edge, double along) const {
    const AxisPoint &a = axis_.graph.points[index(p)], &b = axis_.graph.points[index(q)];
    const double t = std::min(1.0, along / length(edge));
    const Walls walls = axis_.walls[index(edge)];
    const bool curved = d_.element(walls.a).is_round() || d_.element(walls.b).is_round();
    if (curved) return t < 0.5 ? a : b;
    return {lerp(a.point, b.point, t), a.clearance + (b.clearance - a.clearance) * t};
  }

  const Axis& axis_;
  const Diagram& d_;
  double prominence_;
  DisjointSets sets_;
  std::vector<char> flooded_;
  std::vector<int> peaks_;
};

}  // namespace

Axis make_axis(const Diagram& diagram) {
  return AxisMaker(diagram).run();
}

std::vector<AxisPoint> find_centers(const Axis& axis, const Diagram& diagram, double prominence) {
  return PeakFinder(axis, diagram, prominence).run();
}

}  // namespace clearcut::inline geometry::voronoi
