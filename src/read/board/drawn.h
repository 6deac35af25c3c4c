// Items drawn on a layer of a circuit board, one over the other, and the resulting dark area.
#pragma once

#include <vector>

#include "geometry/region.h"
#include "read/common/affine.h"
#include "read/repair/repair.h"

namespace clearcut::read {

struct Drawn {
  bool dark = true;          ///< else the item clears earlier ones
  std::vector<Path> pieces;  ///< loops; their union by the nonzero rule is drawn
  Path line;                 ///< a stroke: path of the aperture's centre
};

/// Under a similarity or any other affine map; circles may become ellipses within kCurveTolerance.
Drawn mapped(const Drawn& drawn, const Affine& map);

/// Throws InputError as repair does. Cost O(n log n) and a boolean for each change between dark and clear.
Regions dark_area(const std::vector<Drawn>& drawn, const RepairOptions& options);

}  // namespace clearcut::read
