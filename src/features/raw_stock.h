// Distance of a cutter from the raw block.
#pragma once

#include <algorithm>

namespace clearcut::features {

/// mm; distance of a cutter's rim from the sawn block if the cutter descends beside the block: its radius, within
/// usual limits.
inline double clear_of_raw_stock(double radius) {
  constexpr double kLeast = 1, kMost = 2;
  return std::clamp(radius, kLeast, kMost);
}

}  // namespace clearcut::features
