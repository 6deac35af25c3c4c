#include "verify/part/edge_tree.h"

namespace clearcut::verify {
namespace {

std::vector<Edge> edges_of(const Regions& regions) {
  std::vector<Edge> edges;
  for (const Region& region : regions) {
    const std::vector<Edge> own = region.edges();
    edges.insert(edges.end(), own.begin(), own.end());
  }
  return edges;
}

}  // namespace

EdgeTree::EdgeTree(const Regions& regions) : EdgeTree(edges_of(regions)) {}

EdgeTree::EdgeTree(std::vector<Edge> edges) : edges_(std::move(edges)) {
  boxes_.reserve(edges_.size());
  for (const Edge& edge : edges_)
    boxes_.push_back(edge.from == edge.to ? Box{edge.from, edge.from} : edge.box());
  gaps_.assign(edges_.size(), 0);
  for (std::size_t i = 1; i < edges_.size(); ++i)
    gaps_[i] = gaps_[i - 1] + (edges_[i - 1].to == edges_[i].from ? 0 : 1);
  tree_.build(static_cast<std::uint32_t>(edges_.size()), [this](std::uint32_t i) { return boxes_[i]; });
}

int EdgeTree::winding(Vec2 p) const {
  int sum = 0;
  const auto open = [&](const Box& b, std::uint32_t first, std::uint32_t end) {
    if (p.y < b.min.y || p.y > b.max.y || b.max.x < p.x) return false;
    if (b.min.x <= p.x || gaps_[first] != gaps_[end - 1]) return true;
    // A chain right of p crosses the ray from p as often as its ends say.
    sum += (edges_[first].from.y <= p.y ? 1 : 0) - (edges_[end - 1].to.y <= p.y ? 1 : 0);
    return false;
  };
  tree_.descend_ranges(open, [&](std::uint32_t i) { sum += clearcut::winding(edges_[i], p); });
  return sum;
}

}  // namespace clearcut::verify
