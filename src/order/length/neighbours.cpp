#include "order/length/neighbours.h"

#include <algorithm>
#include <limits>
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

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Box everywhere() {
  return {{-kInfinity, -kInfinity}, {kInfinity, kInfinity}};
}

/// Half-open quadrants about the origin, so that each direction belongs to exactly one quadrant.
int quadrant_of(Vec2 d) {
  if (d.x > 0 && d.y >= 0) return 0;
  if (d.x <= 0 && d.y > 0) return 1;
  if (d.x < 0 && d.y <= 0) return 2;
  return 3;
}

Box quadrant_box(Vec2 q, int quadrant) {
  switch (quadrant) {
    case 0:
      return {{q.x, q.y}, {kInfinity, kInfinity}};
    case 1:
      return {{-kInfinity, q.y}, {q.x, kInfinity}};
    case 2:
      return {{-kInfinity, -kInfinity}, {q.x, q.y}};
    default:
      return {{q.x, -kInfinity}, {kInfinity, q.y}};
  }
}

void add_quadrants(const KdTree& tree, std::span<const Vec2> points, int v, int per_quadrant,
                   std::vector<KdTree::Found>& row) {
  std::vector<KdTree::Found> found;
  for (int quadrant = 0; quadrant < 4; ++quadrant) {
    const auto accept = [&](int w) { return w != v && quadrant_of(points[w] - points[v]) == quadrant; };
    tree.nearest(points[v], per_quadrant, quadrant_box(points[v], quadrant), accept, found);
    row.insert(row.end(), found.begin(), found.end());
  }
}

}  // namespace

Neighbours nearest_neighbours(std::span<const Vec2> points, int count) {
  const int n = static_cast<int>(points.size());
  count = std::clamp(count, 0, std::max(n - 1, 0));
  const KdTree tree(points);
  std::vector<int> rows;
  rows.reserve(static_cast<std::size_t>(n) * static_cast<std::size_t>(count));
  std::vector<KdTree::Found> found;
  for (int v = 0; v < n; ++v) {
    tree.nearest(
        points[v], count, everywhere(), [v](int w) { return w != v; }, found);
    for (const auto& f : found) rows.push_back(f.second);
  }
  return {std::move(rows), count};
}

Neighbours quadrant_neighbours(std::span<const Vec2> points, int per_quadrant, int count) {
  const int n = static_cast<int>(points.size());
  count = std::clamp(count, 0, std::max(n - 1, 0));
  const KdTree tree(points);
  std::vector<int> rows;
  rows.reserve(static_cast<std::size_t>(n) * static_cast<std::size_t>(count));
  std::vector<KdTree::Found> row, nearest;
  for (int v = 0; v < n; ++v) {
    row.clear();
    add_quadrants(tree, points, v, per_quadrant, row);
    if (static_cast<int>(row.size()) > count) {
      std::sort(row.begin(), row.end());
      row.resize(static_cast<std::size_t>(count));
    }
    tree.nearest(
        points[v], count, everywhere(), [v](int w) { return w != v; }, nearest);
    for (const auto& f : nearest) {
      if (static_cast<int>(row.size()) == count) break;
      if (std::find(row.begin(), row.end(), f) == row.end()) row.push_back(f);
    }
    std::sort(row.begin(), row.end());
    for (const auto& f : row) rows.push_back(f.second);
  }
  return {std::move(rows), count};
}

}  // namespace clearcut::order
