// All loops of regions in one list.
#pragma once

#include <vector>

#include "geometry/region.h"

namespace clearcut::inline geometry {

/// Of each region the outer loop, counter-clockwise, then its islands, clockwise.
inline std::vector<Loop> loops_of(const Regions& regions) {
  std::vector<Loop> loops;
  for (const Region& region : regions) {
    loops.push_back(region.outer());
    loops.insert(loops.end(), region.islands().begin(), region.islands().end());
  }
  return loops;
}

}  // namespace clearcut::inline geometry
