#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "base/containers.h"
#include "base/elementary.h"
#include "order/bounds/bounds.h"
#include "order/length/neighbours.h"

namespace clearcut::order {

namespace {

constexpr double kNoEdge = std::numeric_limits<double>::infinity();

using Penalties = std::vector<double>;

/// The node outside the spanning tree. For open paths the extra node, which has no coordinates.
int special_node(const LengthModel& model) {
  return model.extra_node() >= 0 ? model.extra_node() : 0;
}

/// The two cheapest edges at the special node.
struct TwoEdges {
  double cost[2] = {kNoEdge, kNoEdge};
  int other[2] = {-1, -1};
  void offer(double c, int v) {
    if (c < cost[0]) {
      cost[1] = cost[0], other[1] = other[0];
      cost[0] = c, other[0] = v;
    } else if (c < cost[1]) {
      cost[1] = c, other[1] = v;
    }
  }
};

TwoEdges cheapest_two(const LengthModel& model, const Penalties& penalty) {
  TwoEdges two;
  const int special = special_node(model);
  for (int v = 0; v < model.size(); ++v) {
    if (v != special)
      two.offer(static_cast<double>(model.cost(special, v)) + penalty[v] + penalty[special], v);
  }
  return two;
}

/// Edges of the ascent: both directions in one adjacency array, the special node left out.
struct SparseGraph {
  struct Arc {
    int to;
    double cost;
  };
  std::vector<int> begin;
  std::vector<Arc> arcs;
};

SparseGraph sparse_graph(const LengthModel& model, std::span<const int> tour) {
  const int n = model.size(), special = special_node(model);
  std::vector<std::pair<int, int>> edges;
  const auto add = [&](int a, int b) {
    if (a != special && b != special) edges.push_back(std::minmax(a, b));
  };
  for (int v = 0; v < n; ++v) {
    for (const int w : model.candidates(v)) add(v, w);
  }
  // With one node taken out a tour still connects the rest.
  for (std::size_t i = 0; i < tour.size(); ++i) add(tour[i], tour[i + 1 == tour.size() ? 0 : i + 1]);
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  SparseGraph graph;
  graph.begin.assign(static_cast<std::size_t>(n) + 1, 0);
  for (const auto& [a, b] : edges) ++graph.begin[a + 1], ++graph.begin[b + 1];
  std::partial_sum(graph.begin.begin(), graph.begin.end(), graph.begin.begin());
  graph.arcs.resize(2 * edges.size());
  std::vector<int> next(graph.begin.begin(), graph.begin.end() - 1);
  for (const auto& [a, b] : edges) {
    const double cost = static_cast<double>(model.cost(a, b));
    graph.arcs[next[a]++] = {b, cost};
    graph.arcs[next[b]++] = {a, cost};
  }
  return graph;
}

/// Minimum spanning tree by Prim with a heap; adds to the degrees and returns the penalised cost.
double sparse_tree(const SparseGraph& graph, const Penalties& penalty, int special,
                   std::vector<int>& degree) {
  const int n = static_cast<int>(penalty.size());
  std::vector<double> key(static_cast<std::size_t>(n), kNoEdge);
  std::vector<int> parent(static_cast<std::size_t>(n), -1);
  std::vector<char> done(static_cast<std::size_t>(n), 0);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap;
  const int root = special == 0 ? 1 : 0;
  key[root] = 0;
  heap.push({0, root});
  double sum = 0;
  while (!heap.empty()) {
    const auto [k, v] = heap.top();
    heap.pop();
    if (done[v]) continue;
    done[v] = 1;
    sum += k;
    if (parent[v] >= 0) ++degree[v], ++degree[parent[v]];
    for (int i = graph.begin[v]; i < graph.begin[v + 1]; ++i) {
      const auto& [w, cost] = graph.arcs[i];
      const double c = cost + penalty[v] + penalty[w];
      if (done[w] || c >= key[w]) continue;
      key[w] = c;
      parent[w] = v;
      heap.push({c, w});
    }
  }
  return sum;
}

/// Volgenant and Jonker's schedule: steps fall quadratically to zero, directions are smoothed.
Penalties ascend(const LengthModel& model, const SparseGraph& graph, int iterations, const StopWatch& watch) {
  const int n = model.size(), special = special_node(model);
  Penalties penalty(static_cast<std::size_t>(n), 0.0), best = penalty;
  std::vector<int> degree(static_cast<std::size_t>(n)), old_degree(static_cast<std::size_t>(n), 2);
  double best_value = -kNoEdge, first_step = 0;
  for (int k = 0; k < iterations && !watch.over(); ++k) {
    std::fill(degree.begin(), degree.end(), 0);
    double value = sparse_tree(graph, penalty, special, degree);
    const TwoEdges two = cheapest_two(model, penalty);
    for (int i = 0; i < 2; ++i) {
      value += two.cost[i];
      ++degree[two.other[i]];
      ++degree[special];
    }
    value -= 2 * std::accumulate(penalty.begin(), penalty.end(), 0.0);
    if (value > best_value) {
      best_value = value;
      best = penalty;
    }
    if (k == 0) first_step = 0.5 * (std::abs(value) + static_cast<double>(model.premium())) / n;
    const double m = iterations, left = 1 - k / m;
    const double step = first_step * left * left;
    for (int v = 0; v < n; ++v) {
      penalty[v] += step * (0.6 * (degree[v] - 2) + 0.4 * (old_degree[v] - 2));
    }
    old_degree = degree;
  }
  return best;
}

/// Minimum spanning tree of the complete graph under penalties: Boruvka's rounds, with a k-d tree search for the
/// cheapest edge out of each component.
class CompleteTree {
 public:
  CompleteTree(const LengthModel& model, const Penalties& penalty)
      : model_(model),
        penalty_(penalty),
        special_(special_node(model)),
        points_(points()),
        tree_(points_),
        components_(model.size()) {
    least_penalty_.resize(tree_.nodes().size());
    owner_.resize(tree_.nodes().size());
    for (std::size_t i = tree_.nodes().size(); i-- > 0;) {
      const KdTree::Node& node = tree_.nodes()[i];
      least_penalty_[i] = kNoEdge;
      for (int j = node.first; node.left < 0 && j < node.last; ++j) {
        least_penalty_[i] = std::min(least_penalty_[i], penalty_[node_at(j)]);
      }
      if (node.left >= 0) least_penalty_[i] = std::min(least_penalty_[node.left], least_penalty_[node.right]);
    }
  }

  double cost() {
    double sum = 0;
    int components = model_.size() - 1;
    while (components > 1) {
      find_owners();
      std::vector<Way> best(static_cast<std::size_t>(model_.size()));
      for (int v = 0; v < model_.size(); ++v) {
        if (v != special_) search(v, best[find(v)]);
      }
      for (const Way& way : best) {
        if (way.to < 0 || find(way.from) == find(way.to)) continue;
        components_.join(way.from, way.to);
        sum += way.cost;
        --components;
      }
    }
    return sum;
  }

 private:
  struct Way {
    double cost = kNoEdge;
    int from = -1, to = -1;
    /// Ties by index, so that rounds cannot close a circle.
    bool better_than(const Way& other) const {
      if (cost != other.cost) return cost < other.cost;
      return std::minmax(from, to) < std::minmax(other.from, other.to);
    }
  };
  std::vector<Vec2> points() const {
    std::vector<Vec2> result;
    for (int v = 0; v < model_.size(); ++v) {
      if (v != special_) result.push_back(model_.point(v));
    }
    return result;
  }
  int node_at(int j) const {
    const int item = tree_.item(j);
    return item >= special_ ? item + 1 : item;
  }
  int find(int v) { return components_.find(v); }
  /// Component of each k-d node whose points all share one, else -1.
  void find_owners() {
    for (std::size_t i = tree_.nodes().size(); i-- > 0;) {
      const KdTree::Node& node = tree_.nodes()[i];
      if (node.left >= 0) {
        owner_[i] = owner_[node.left] == owner_[node.right] ? owner_[node.left] : -1;
        continue;
      }
      owner_[i] = find(node_at(node.first));
      for (int j = node.first + 1; j < node.last; ++j) {
        if (find(node_at(j)) != owner_[i]) owner_[i] = -1;
      }
    }
  }
  void search(int v, Way& best) {
    const auto candidates = model_.candidates(v);
    const auto costs = model_.candidate_costs(v);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const int w = candidates[i];
      if (w == special_ || find(w) == find(v)) continue;
      const Way way{static_cast<double>(costs[i]) + penalty_[v] + penalty_[w], v, w};
      if (way.better_than(best)) best = way;
    }
    visit(0, v, best);
  }
  double bound_of(int at, int v) const {
    return model_.cost_bound(tree_.nodes()[at].box.distance_to(model_.point(v))) + penalty_[v] +
           least_penalty_[at];
  }
  void visit(int at, int v, Way& best) {
    if (owner_[at] == find(v)) return;
    const KdTree::Node& node = tree_.nodes()[at];
    if (node.left >= 0) {
      int near = node.left, far = node.right;
      double near_bound = bound_of(near, v), far_bound = bound_of(far, v);
      if (far_bound < near_bound) {
        std::swap(near, far);
        std::swap(near_bound, far_bound);
      }
      if (near_bound <= best.cost) visit(near, v, best);
      if (far_bound <= best.cost) visit(far, v, best);
      return;
    }
    for (int j = node.first; j < node.last; ++j) {
      const int w = node_at(j);
      if (find(w) == find(v)) continue;
      const double rest = penalty_[v] + penalty_[w];
      const double limit = best.cost - rest;
      if (model_.cost_bound(distance(model_.point(v), model_.point(w))) > limit) continue;
      const Way way{static_cast<double>(model_.cost(v, w)) + rest, v, w};
      if (way.better_than(best)) best = way;
    }
  }

  const LengthModel& model_;
  const Penalties& penalty_;
  int special_;
  std::vector<Vec2> points_;
  KdTree tree_;
  DisjointSets components_;
  std::vector<double> least_penalty_;  // least penalty by k-d node
  std::vector<int> owner_;
};

}  // namespace

double held_karp_bound(const LengthModel& model, std::span<const int> tour, int iterations,
                       const StopWatch& watch) {
  if (model.size() < 4) return model.length(model.tour_cost(tour));
  const Penalties penalty = ascend(model, sparse_graph(model, tour), iterations, watch);
  const TwoEdges two = cheapest_two(model, penalty);
  double value = CompleteTree(model, penalty).cost() + two.cost[0] + two.cost[1];
  double magnitude = std::abs(value);
  for (const double p : penalty) {
    value -= 2 * p;
    magnitude += 2 * std::abs(p);
  }
  // Sums of doubles are off by less than this; the bound must not be.
  value -= 1e-14 * magnitude * base::log2(static_cast<double>(model.size()) + 2);
  return model.length(model.rounded_up(value));
}

}  // namespace clearcut::order
