#include "post/heights.h"

#include <algorithm>

namespace clearcut {

double safe_height(const Toolpath& toolpath, const Part& part) {
  constexpr double kAboveStock = 10;
  double highest = part.clearance_z.value_or((part.stock ? part.stock->z_top : 0) + kAboveStock);
  for (const Section& section : toolpath.sections) {
    for (const Move& move : section.moves) highest = std::max({highest, move.z_from, move.z_to});
  }
  return highest;
}

}  // namespace clearcut
