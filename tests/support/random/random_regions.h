// Families of random regions for property tests: from plain polygons to walls that touch or nearly fit a cutter.
#pragma once

#include <vector>

#include "base/random.h"
#include "geometry/region.h"

namespace clearcut::test_support {

/// A valid region, corners between 8 and 352 degrees, and the distances that matter in it (radii of its arcs, half
/// widths of its necks), where there are any. mm; some 10 to 60 across.
struct RandomRegion {
  Region region;
  std::vector<double> levels;
};

struct RandomFamily {
  const char* name;
  RandomRegion (*make)(Random&);
  int share;  ///< of every hundred
};

/// Family of the i-th case: runs through all of them in proportion to their shares.
const RandomFamily& family_of(int i);

}  // namespace clearcut::test_support
