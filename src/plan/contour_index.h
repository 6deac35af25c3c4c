// Finds what lies near a place: numbers sorted into square cells. Used by the planner alone.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "geometry/box.h"

namespace clearcut {

/// Numbers by the box they lie in. Cells exist only where something lies; cost of a look-up: cells of its
/// box.
class BoxIndex {
 public:
  explicit BoxIndex(double cell) : cell_(cell) {}

  void add(const Box& box, std::uint32_t number) {
    for_cells(box, [&](std::uint64_t key) { cells_[key].push_back(number); });
  }

  /// All numbers whose cells `box` touches, ascending, each once; some of them lie a cell away.
  std::vector<std::uint32_t> near(const Box& box) const {
    std::vector<std::uint32_t> found;
    for_cells(box, [&](std::uint64_t key) {
      if (const auto at = cells_.find(key); at != cells_.end()) {
        found.insert(found.end(), at->second.begin(), at->second.end());
      }
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

 private:
  template <typename F>
  void for_cells(const Box& box, F&& f) const {
    const auto index = [&](double v) { return static_cast<std::int32_t>(std::floor(v / cell_)); };
    for (std::int32_t r = index(box.min.y); r <= index(box.max.y); ++r) {
      for (std::int32_t c = index(box.min.x); c <= index(box.max.x); ++c) {
        f(static_cast<std::uint64_t>(static_cast<std::uint32_t>(r)) << 32 | static_cast<std::uint32_t>(c));
      }
    }
  }

  double cell_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

}  // namespace clearcut
