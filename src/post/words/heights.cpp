#include "post/words/heights.h"

#include <algorithm>

namespace clearcut::post {

double safe_height(const Toolpath& toolpath, const Part& part) {
  double highest = part.safe_z();
  for (const Section& section : toolpath.sections) {
    for (const Move& move : section.moves) highest = std::max({highest, move.z_from, move.z_to});
  }
  return highest;
}

}  // namespace clearcut::post
