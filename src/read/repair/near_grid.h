// Points by place, so that those near a place are found without looking at all.
#pragma once

#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "geometry/vec2.h"

namespace clearcut::read {

/// Indices filed by place in squares of side `reach`. Ordered, so that visits do not depend on hashing.
class NearGrid {
 public:
  explicit NearGrid(double reach) : reach_(reach) {}

  void add(Vec2 p, int index) { cells_[cell_of(p)].push_back(index); }
  /// Calls visit(index) for all within `reach` of p, and some a little farther.
  template <typename Visit>
  void for_near(Vec2 p, Visit visit) const {
    const Cell at = cell_of(p);
    for (long long dx = -1; dx <= 1; ++dx) {
      for (long long dy = -1; dy <= 1; ++dy) {
        const auto found = cells_.find({at.first + dx, at.second + dy});
        if (found == cells_.end()) continue;
        for (const int i : found->second) visit(i);
      }
    }
  }
  /// The fullest square's indices.
  const std::vector<int>* fullest() const {
    const std::vector<int>* most = nullptr;
    for (const auto& [cell, inside] : cells_) {
      if (!most || inside.size() > most->size()) most = &inside;
    }
    return most;
  }

 private:
  using Cell = std::pair<long long, long long>;
  Cell cell_of(Vec2 p) const {
    return {static_cast<long long>(std::floor(p.x / reach_)),
            static_cast<long long>(std::floor(p.y / reach_))};
  }
  double reach_;
  std::map<Cell, std::vector<int>> cells_;
};

}  // namespace clearcut::read
