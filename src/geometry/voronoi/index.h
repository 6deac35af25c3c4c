// Numbers of nodes and sites are ints, because some are -1; containers ask for std::size_t.
#pragma once

#include <cstddef>

namespace clearcut::geometry::voronoi {

/// `i` >= 0.
constexpr std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace clearcut::geometry::voronoi
