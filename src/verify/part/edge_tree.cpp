#include "verify/part/edge_tree.h"

namespace clearcut::verify {

EdgeTree::EdgeTree(const Regions& regions) : EdgeTree(edges_of(regions)) {}

EdgeTree::EdgeTree(std::vector<Edge> edges) : edges_(std::move(edges)) {
  boxes_.reserve(edges_.size());
  for (const Edge& edge : edges_)
    boxes_.push_back(edge.from == edge.to ? Box{edge.from, edge.from} : edge.box());
  find_chains();
  tree_.build(static_cast<std::uint32_t>(edges_.size()), [this](std::uint32_t i) { return boxes_[i]; });
}

/// Runs of edges of which each begins where the one before ends.
void EdgeTree::find_chains() {
  chain_of_.assign(edges_.size(), 0);
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const bool begins = i == 0 || edges_[i - 1].to != edges_[i].from;
    if (begins) chains_.push_back({edges_[i].from, edges_[i].to, 0});
    chain_of_[i] = static_cast<std::uint32_t>(chains_.size() - 1);
    chains_.back().to = edges_[i].to;
  }
  for (std::size_t i = 1; i < chains_.size(); ++i)
    chains_[i].open_before = chains_[i - 1].open_before + (chains_[i - 1].from == chains_[i - 1].to ? 0 : 1);
}

int EdgeTree::winding(Vec2 p) const {
  int sum = 0;
  const auto below = [&](Vec2 q) { return q.y <= p.y ? 1 : 0; };
  const auto open = [&](const Box& b, std::uint32_t first, std::uint32_t end) {
    if (p.y < b.min.y || p.y > b.max.y || b.max.x < p.x) return false;
    if (b.min.x <= p.x) return true;
    // A chain right of p crosses the ray from p as often as its ends say; one that is closed, as often up as down.
    const std::uint32_t begun = chain_of_[first], ended = chain_of_[end - 1];
    if (begun != ended && chains_[begun + 1].open_before != chains_[ended].open_before) return true;
    sum += below(edges_[first].from) - below(edges_[end - 1].to);
    if (begun != ended) sum += below(chains_[ended].from) - below(chains_[begun].to);
    return false;
  };
  tree_.descend_ranges(open, [&](std::uint32_t i) { sum += clearcut::winding(edges_[i], p); });
  return sum;
}

}  // namespace clearcut::verify
