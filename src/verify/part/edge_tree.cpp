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
  if (edges_.empty()) return;
  std::vector<Box> boxes;
  boxes.reserve(edges_.size());
  for (const Edge& edge : edges_)
    boxes.push_back(edge.from == edge.to ? Box{edge.from, edge.from} : edge.box());
  while (boxes.size() > kFan) {
    std::vector<Box> parents((boxes.size() + kFan - 1) / kFan);
    for (std::size_t i = 0; i < boxes.size(); ++i) parents[i / kFan].add(boxes[i]);
    levels_.push_back(std::move(boxes));
    boxes = std::move(parents);
  }
  for (const Box& box : boxes) root_.add(box);
  levels_.push_back(std::move(boxes));
}

int EdgeTree::winding(Vec2 p) const {
  int sum = 0;
  descend([p](const Box& b) { return b.min.y <= p.y && p.y <= b.max.y && b.max.x >= p.x; },
          [&](int i) { sum += clearcut::winding(edges_[i], p); });
  return sum;
}

}  // namespace clearcut::verify
