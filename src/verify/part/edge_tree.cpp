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
  tree_.build(static_cast<std::uint32_t>(edges_.size()), [this](std::uint32_t i) { return boxes_[i]; });
}

int EdgeTree::winding(Vec2 p) const {
  int sum = 0;
  descend([p](const Box& b) { return b.min.y <= p.y && p.y <= b.max.y && b.max.x >= p.x; },
          [&](int i) { sum += clearcut::winding(edges_[i], p); });
  return sum;
}

}  // namespace clearcut::verify
