// How far a cutter keeps off the raw block.
#pragma once

#include <algorithm>

namespace clearcut::features {

/// mm that a cutter's rim stays off the block, which is sawn, where it goes down beside it: its radius, within limits that are usual.
inline double clear_of_raw_stock(double radius) {
  constexpr double kLeast = 1, kMost = 2;
  return std::clamp(radius, kLeast, kMost);
}

}  // namespace clearcut::features
