#include "order/length/kd_tree.h"

#include <numeric>

namespace clearcut::order {

namespace {
constexpr int kLeafSize = 8;
}

KdTree::KdTree(std::span<const Vec2> points) : items_(points.size()) {
  std::iota(items_.begin(), items_.end(), 0);
  if (!items_.empty()) build(0, static_cast<int>(items_.size()), points);
  sorted_.reserve(items_.size());
  for (const int item : items_) sorted_.push_back(points[item]);
}

int KdTree::build(int first, int last, std::span<const Vec2> points) {
  const int at = static_cast<int>(nodes_.size());
  Node node;
  node.first = first;
  node.last = last;
  for (int i = first; i < last; ++i) node.box.add(points[items_[i]]);
  nodes_.push_back(node);
  if (last - first <= kLeafSize) return at;

  const bool by_x = node.box.width() >= node.box.height();
  const int middle = first + (last - first) / 2;
  std::nth_element(items_.begin() + first, items_.begin() + middle, items_.begin() + last, [&](int a, int b) {
    const double u = by_x ? points[a].x : points[a].y;
    const double v = by_x ? points[b].x : points[b].y;
    return u != v ? u < v : a < b;
  });
  const int left = build(first, middle, points);
  const int right = build(middle, last, points);
  nodes_[at].left = left;
  nodes_[at].right = right;
  return at;
}

}  // namespace clearcut::order
