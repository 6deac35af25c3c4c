// The nearest points of each point, for candidate lists. No matrix of distances is ever kept.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "geometry/vec2.h"

namespace clearcut::order {

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
