#include "verify/part/edge_tree.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace clearcut::verify {
namespace {

/// Number of closed loops from which on they are sorted by place.
constexpr std::size_t kManyLoops = 16;
/// mm; least height of the strips for sorting loops.
constexpr double kLeastStrip = 1e-6;

}  // namespace

EdgeTree::EdgeTree(const Regions& regions) : EdgeTree(edges_of(regions)) {}

EdgeTree::EdgeTree(std::vector<Edge> edges) : edges_(std::move(edges)) {
  boxes_.reserve(edges_.size());
  for (const Edge& edge : edges_)
    boxes_.push_back(edge.from == edge.to ? Box{edge.from, edge.from} : edge.box());
  find_chains();
  tree_.build(static_cast<std::uint32_t>(edges_.size()), [this](std::uint32_t i) { return boxes_[i]; });
  sort_loops();
}

/// Finds runs of edges, each beginning at the end of the previous one.
void EdgeTree::find_chains() {
  chain_of_.assign(edges_.size(), 0);
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const bool begins = i == 0 || edges_[i - 1].to != edges_[i].from;
    const auto number = static_cast<std::uint32_t>(i);
    if (begins) chains_.push_back({edges_[i].from, edges_[i].to, 0, number, number});
    chain_of_[i] = static_cast<std::uint32_t>(chains_.size() - 1);
    chains_.back().to = edges_[i].to;
    chains_.back().end_edge = number + 1;
  }
  for (std::size_t i = 1; i < chains_.size(); ++i)
    chains_[i].open_before = chains_[i - 1].open_before + (chains_[i - 1].from == chains_[i - 1].to ? 0 : 1);
}

/// Regions with hundreds of islands list them in any order: only those about a point are of use to find its winding
/// number.
void EdgeTree::sort_loops() {
  if (chains_.size() < kManyLoops ||
      std::any_of(chains_.begin(), chains_.end(), [](const Chain& c) { return c.from != c.to; }))
    return;
  std::vector<Box> boxes(chains_.size());
  for (std::size_t i = 0; i < edges_.size(); ++i) boxes[chain_of_[i]].add(boxes_[i]);
  const double strip =
      std::max(tree_.box().height() / std::sqrt(static_cast<double>(chains_.size())), kLeastStrip);
  const auto row = [&](std::uint32_t i) {
    return std::floor((boxes[i].center().y - tree_.box().min.y) / strip);
  };
  for (std::uint32_t i = 0; i < chains_.size(); ++i) loops_.push_back(i);
  std::sort(loops_.begin(), loops_.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::make_tuple(row(a), boxes[a].center().x, a) < std::make_tuple(row(b), boxes[b].center().x, b);
  });
  loop_tree_.build(static_cast<std::uint32_t>(loops_.size()),
                   [&](std::uint32_t i) { return boxes[loops_[i]]; });
}

int EdgeTree::winding(Vec2 p) const {
  if (loops_.empty()) return winding_of(p, 0, static_cast<std::uint32_t>(edges_.size()));
  int sum = 0;
  loop_tree_.descend([&](const Box& box) { return box.contains(p); },
                     [&](std::uint32_t i) {
                       const Chain& loop = chains_[loops_[i]];
                       sum += winding_of(p, loop.first_edge, loop.end_edge);
                     });
  return sum;
}

/// Winding number around p of the edges from `from` to below `to`, which must be whole chains.
int EdgeTree::winding_of(Vec2 p, std::uint32_t from, std::uint32_t to) const {
  int sum = 0;
  const auto below = [&](Vec2 q) { return q.y <= p.y ? 1 : 0; };
  const auto open = [&](const Box& b, std::uint32_t first, std::uint32_t end) {
    if (p.y < b.min.y || p.y > b.max.y || b.max.x < p.x || end <= from || first >= to) return false;
    if (b.min.x <= p.x || first < from || end > to) return true;
    // A chain right of p has crossings with the ray from p given by its ends; a closed one crosses equally often up
    // and down.
    const std::uint32_t begun = chain_of_[first], ended = chain_of_[end - 1];
    if (begun != ended && chains_[begun + 1].open_before != chains_[ended].open_before) return true;
    sum += below(edges_[first].from) - below(edges_[end - 1].to);
    if (begun != ended) sum += below(chains_[ended].from) - below(chains_[begun].to);
    return false;
  };
  tree_.descend_ranges(open, [&](std::uint32_t i) {
    if (i >= from && i < to) sum += clearcut::winding(edges_[i], p);
  });
  return sum;
}

}  // namespace clearcut::verify
