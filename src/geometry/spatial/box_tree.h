// Finds numbered items near a point. Items with neighbouring numbers should be near each other, like the pieces of a
// path.
#pragma once

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "geometry/box.h"

namespace clearcut::inline geometry {

/// A binary tree of boxes over numbers in their order. Building it costs O(n); a look-up about O(log n).
class BoxTree {
 public:
  /// `box_of(i)` for i below `count`.
  template <typename BoxOf>
  void build(std::uint32_t count, BoxOf&& box_of) {
    count_ = count;
    leaves_ = 1;
    while (leaves_ * kLeaf < count) leaves_ *= 2;
    boxes_.assign(2 * std::size_t{leaves_}, {});
    for (std::uint32_t i = 0; i < count; ++i) boxes_[leaves_ + i / kLeaf].add(box_of(i));
    for (std::size_t node = leaves_; node-- > 1;) {
      boxes_[node] = boxes_[2 * node];
      boxes_[node].add(boxes_[2 * node + 1]);
    }
  }

  /// The number with the least squared distance(i) from p, the smallest of several; 0 if there are no numbers.
  template <typename SquaredDistance>
  std::uint32_t nearest(Vec2 p, SquaredDistance&& squared_distance) const {
    std::uint32_t best = 0;
    double best_squared = std::numeric_limits<double>::infinity();
    std::vector<std::size_t> open{1};
    while (!open.empty()) {
      const std::size_t node = open.back();
      open.pop_back();
      if (bound(node, p) > best_squared) continue;
      if (node >= leaves_) {
        const auto first = static_cast<std::uint32_t>(node - leaves_) * kLeaf;
        for (std::uint32_t i = first; i < std::min(first + kLeaf, count_); ++i) {
          const double squared = squared_distance(i);
          if (!(squared < best_squared || (squared == best_squared && i < best))) continue;
          best_squared = squared;
          best = i;
        }
        continue;
      }
      std::size_t near = 2 * node, far = near + 1;
      if (bound(far, p) < bound(near, p)) std::swap(near, far);
      open.push_back(far);
      open.push_back(near);
    }
    return best;
  }

  /// Calls visit(number) for all numbers in the boxes for which open(box) is true, in ascending order: up to kLeaf
  /// numbers share a box. `open` is called again after each visit, so that its condition may become stricter.
  template <typename Open, typename Visit>
  void descend(Open&& open, Visit&& visit) const {
    descend_ranges([&](const Box& box, std::uint32_t, std::uint32_t) { return open(box); }, visit);
  }

  /// The same in another order: of two boxes side by side the one nearer to p first.
  template <typename Open, typename Visit>
  void descend_nearest_first(Vec2 p, Open&& open, Visit&& visit) const {
    if (count_ > 0) descend_near(1, 0, leaves_ * kLeaf, p, open, visit);
  }

  /// The same as descend; open(box, first, end) also receives the numbers in the box, first to below end.
  template <typename Open, typename Visit>
  void descend_ranges(Open&& open, Visit&& visit) const {
    if (count_ > 0) descend_from(1, 0, leaves_ * kLeaf, open, visit);
  }

  /// The box of all.
  const Box& box() const { return boxes_[1]; }

  static constexpr std::uint32_t kLeaf = 8;

 private:
  template <typename Open, typename Visit>
  void descend_from(std::size_t node, std::uint32_t first, std::uint32_t size, Open& open,
                    Visit& visit) const {
    const std::uint32_t end = std::min(first + size, count_);
    if (first >= end || !open(boxes_[node], first, end)) return;
    if (node < leaves_) {
      descend_from(2 * node, first, size / 2, open, visit);
      descend_from(2 * node + 1, first + size / 2, size / 2, open, visit);
      return;
    }
    for (std::uint32_t i = first; i < end; ++i) visit(i);
  }

  template <typename Open, typename Visit>
  void descend_near(std::size_t node, std::uint32_t first, std::uint32_t size, Vec2 p, Open& open,
                    Visit& visit) const {
    const std::uint32_t end = std::min(first + size, count_), half = size / 2;
    if (first >= end || !open(boxes_[node])) return;
    if (node >= leaves_) {
      for (std::uint32_t i = first; i < end; ++i) visit(i);
    } else if (bound(2 * node + 1, p) < bound(2 * node, p)) {
      descend_near(2 * node + 1, first + half, half, p, open, visit);
      descend_near(2 * node, first, half, p, open, visit);
    } else {
      descend_near(2 * node, first, half, p, open, visit);
      descend_near(2 * node + 1, first + half, half, p, open, visit);
    }
  }

  /// Squared distance to a box, less by more than rounding.
  double bound(std::size_t node, Vec2 p) const {
    const Box& box = boxes_[node];
    const double dx = std::max({box.min.x - p.x, 0.0, p.x - box.max.x});
    const double dy = std::max({box.min.y - p.y, 0.0, p.y - box.max.y});
    return (dx * dx + dy * dy) * (1 - 1e-9);
  }

  std::uint32_t count_ = 0;
  std::uint32_t leaves_ = 1;
  std::vector<Box> boxes_{2};  ///< the root at 1, the children of node i at 2 i and 2 i + 1
};

}  // namespace clearcut::inline geometry
