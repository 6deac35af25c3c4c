// What is drawn on a layer of a circuit board, one thing over the other, and the area that is dark in the end.
#pragma once

#include <vector>

#include "geometry/region.h"
#include "read/common/affine.h"
#include "read/repair/repair.h"

namespace clearcut::read {

struct Drawn {
  bool dark = true;          ///< else it clears what was drawn before
  std::vector<Path> pieces;  ///< loops; their union by the nonzero rule is drawn
  Path line;                 ///< a stroke: what the aperture's centre follows
};

/// Under a similarity or any other affine map; circles may become ellipses within kCurveTolerance.
Drawn mapped(const Drawn& drawn, const Affine& map);

/// Throws InputError as repair does. Cost O(n log n) and a boolean for each change between dark and clear.
Regions dark_area(const std::vector<Drawn>& drawn, const RepairOptions& options);

}  // namespace clearcut::read
