// The nearest points of each point, for candidate lists, found by a static k-d tree over points of the plane
// [bentley1975] with a filter and a window. No matrix of distances is ever kept.
#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "geometry/box.h"
#include "geometry/vec2.h"

namespace clearcut::order {

/// Built in O(n log n); a query takes O(log n + k) for points spread evenly and never misses a point.
class KdTree {
 public:
  struct Node {
    Box box;
    int first = 0;  ///< range of `item(i)`
    int last = 0;
    int left = -1;  ///< children; -1 for a leaf
    int right = -1;
  };
  /// Squared distance and index: compares by distance, then index, so answers do not depend on the tree.
  using Found = std::pair<double, int>;

  explicit KdTree(std::span<const Vec2> points);

  const std::vector<Node>& nodes() const { return nodes_; }  ///< root first, children after parents
  int item(int i) const { return items_[i]; }
  Vec2 point(int i) const { return sorted_[i]; }  ///< coordinates of item(i)

  /// Up to k accepted points inside `window`, nearest first. `accept(index)` sees each candidate once.
  template <class Accept>
  void nearest(Vec2 q, int k, const Box& window, Accept accept, std::vector<Found>& found) const {
    found.clear();
    if (!nodes_.empty() && k > 0) visit(0, q, static_cast<std::size_t>(k), window, accept, found);
    std::sort_heap(found.begin(), found.end());
  }

 private:
  static double squared_distance(const Box& box, Vec2 q) {
    const double dx = std::max({box.min.x - q.x, 0.0, q.x - box.max.x});
    const double dy = std::max({box.min.y - q.y, 0.0, q.y - box.max.y});
    return dx * dx + dy * dy;
  }

  template <class Accept>
  void visit(int at, Vec2 q, std::size_t k, const Box& window, Accept& accept,
             std::vector<Found>& found) const {
    const Node& node = nodes_[at];
    if (!node.box.overlaps(window)) return;
    if (node.left < 0) return scan(node, q, k, accept, found);
    int near = node.left, far = node.right;
    double near_distance = squared_distance(nodes_[near].box, q);
    double far_distance = squared_distance(nodes_[far].box, q);
    if (far_distance < near_distance) {
      std::swap(near, far);
      std::swap(near_distance, far_distance);
    }
    if (found.size() < k || near_distance <= found.front().first) visit(near, q, k, window, accept, found);
    if (found.size() < k || far_distance <= found.front().first) visit(far, q, k, window, accept, found);
  }

  template <class Accept>
  void scan(const Node& node, Vec2 q, std::size_t k, Accept& accept, std::vector<Found>& found) const {
    for (int i = node.first; i < node.last; ++i) {
      const Found candidate{norm_squared(sorted_[i] - q), items_[i]};
      if (found.size() == k && !(candidate < found.front())) continue;
      if (!accept(items_[i])) continue;
      if (found.size() == k) {
        std::pop_heap(found.begin(), found.end());
        found.pop_back();
      }
      found.push_back(candidate);
      std::push_heap(found.begin(), found.end());
    }
  }

  int build(int first, int last, std::span<const Vec2> points);

  std::vector<Node> nodes_;
  std::vector<int> items_;
  std::vector<Vec2> sorted_;
};

/// Rows of equal length `count()`, nearest first; equal distances by index.
class Neighbours {
 public:
  Neighbours() = default;
  Neighbours(std::vector<int> rows, int count) : rows_(std::move(rows)), count_(count) {}

  int count() const { return count_; }
  int size() const { return count_ == 0 ? 0 : static_cast<int>(rows_.size()) / count_; }
  std::span<const int> of(int v) const {
    return {rows_.data() + static_cast<std::size_t>(v) * static_cast<std::size_t>(count_),
            static_cast<std::size_t>(count_)};
  }

 private:
  std::vector<int> rows_;
  int count_ = 0;
};

/// The `count` points nearest to each point by straight distance (all others when there are fewer).
/// Cost O(n (log n + count)) for points spread evenly; memory O(n count).
Neighbours nearest_neighbours(std::span<const Vec2> points, int count);

/// Up to `per_quadrant` nearest points from each quadrant, then the nearest overall until `count` are found:
/// keeps clusters connected with each other [johnson1997]. Sorted by distance. Cost about five times the
/// above.
Neighbours quadrant_neighbours(std::span<const Vec2> points, int per_quadrant, int count);

}  // namespace clearcut::order
