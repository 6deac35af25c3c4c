#include "order/length/start_tours.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <tuple>

#include "base/disjoint_sets.h"
#include "order/length/kd_tree.h"

namespace clearcut::order {

namespace {

/// Paths under construction: up to two links a node, and the path of each node.
class Fragments {
 public:
  explicit Fragments(int n) : link_(static_cast<std::size_t>(n), {-1, -1}), joined_(n), paths_(n) {}
  int paths() const { return paths_; }
  bool is_end(int v) const { return link_[v][1] < 0; }
  bool can_join(int a, int b) { return is_end(a) && is_end(b) && find(a) != find(b); }
  void join(int a, int b) {
    add_link(a, b);
    add_link(b, a);
    joined_.join(a, b);
    --paths_;
  }
  int find(int v) { return joined_.find(v); }
  std::vector<int> ends() const {
    std::vector<int> result;
    for (std::size_t v = 0; v < link_.size(); ++v) {
      if (is_end(static_cast<int>(v))) result.push_back(static_cast<int>(v));
    }
    return result;
  }
  /// The single remaining path.
  std::vector<int> path() const {
    int v = 0;
    while (!is_end(v)) ++v;
    std::vector<int> nodes;
    for (int previous = -1; v >= 0;) {
      nodes.push_back(v);
      const int next = link_[v][0] != previous ? link_[v][0] : link_[v][1];
      previous = v;
      v = next;
    }
    return nodes;
  }

 private:
  void add_link(int a, int b) { (link_[a][0] < 0 ? link_[a][0] : link_[a][1]) = b; }
  std::vector<std::array<int, 2>> link_;
  DisjointSets joined_;
  int paths_;
};

struct Edge {
  LengthModel::Cost cost;
  int a, b;
  friend bool operator<(const Edge& x, const Edge& y) {
    return std::tie(x.cost, x.a, x.b) < std::tie(y.cost, y.a, y.b);
  }
};

void join_in_order(std::vector<Edge>& edges, Fragments& fragments) {
  std::sort(edges.begin(), edges.end());
  for (const Edge& e : edges) {
    if (fragments.can_join(e.a, e.b)) fragments.join(e.a, e.b);
  }
}

constexpr int kGreedyCandidates = 6;

std::vector<Edge> candidate_edges(const LengthModel& model, double noise, Random& random) {
  std::vector<Edge> edges;
  for (int v = 0; v < model.size(); ++v) {
    if (v == model.extra_node()) continue;
    const auto candidates = model.candidates(v);
    const auto costs = model.candidate_costs(v);
    int taken = 0;
    for (std::size_t i = 0; i < candidates.size() && taken < kGreedyCandidates; ++i) {
      const int w = candidates[i];
      if (w == model.extra_node()) continue;
      ++taken;
      const auto back = model.candidates(w);
      if (w < v && std::find(back.begin(), back.end(), v) != back.end()) continue;
      const double factor = noise > 0 ? 1 + noise * random.unit() : 1;
      edges.push_back({static_cast<LengthModel::Cost>(static_cast<double>(costs[i]) * factor), v, w});
    }
  }
  return edges;
}

/// Joins each path's ends to the nearest ends of other paths; at least halves the number of paths.
void join_nearest_ends(const LengthModel& model, Fragments& fragments) {
  std::vector<int> ends = fragments.ends();
  std::erase(ends, model.extra_node());
  std::vector<Vec2> points;
  for (const int v : ends) points.push_back(model.point(v));
  const KdTree tree(points);
  const double infinity = std::numeric_limits<double>::infinity();
  const Box everywhere{{-infinity, -infinity}, {infinity, infinity}};
  std::vector<Edge> edges;
  std::vector<KdTree::Found> found;
  for (const int v : ends) {
    const int own = fragments.find(v);
    tree.nearest(
        model.point(v), 5, everywhere, [&](int i) { return fragments.find(ends[i]) != own; }, found);
    for (const auto& f : found) edges.push_back({model.cost(v, ends[f.second]), v, ends[f.second]});
  }
  join_in_order(edges, fragments);
}

}  // namespace

std::vector<int> greedy_tour(const LengthModel& model, double noise, Random& random) {
  Fragments fragments(model.size());
  const int extra = model.extra_node();
  int paths_wanted = 1;
  if (extra >= 0) {
    // Fixed ends hang on the extra node; without fixed ends it stays separate until the end.
    for (const int v : model.candidates(extra)) {
      if (model.cost(extra, v) < 0 && fragments.can_join(extra, v)) fragments.join(extra, v);
    }
    if (fragments.paths() == model.size()) paths_wanted = 2;
  }
  std::vector<Edge> edges = candidate_edges(model, noise, random);
  join_in_order(edges, fragments);
  edges = {};
  while (fragments.paths() > paths_wanted) join_nearest_ends(model, fragments);
  std::vector<int> tour = fragments.path();
  if (paths_wanted == 2) tour.push_back(extra);
  return tour;
}

std::vector<int> random_tour(const LengthModel& model, Random& random) {
  std::vector<int> nodes(static_cast<std::size_t>(model.size()));
  std::iota(nodes.begin(), nodes.end(), 0);
  for (std::size_t i = nodes.size(); i > 1; --i) std::swap(nodes[i - 1], nodes[random.below(i)]);
  return nodes;
}

}  // namespace clearcut::order
