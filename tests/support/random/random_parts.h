// Random parts of one feature: what every strategy has to clear.
#pragma once

#include <cstdlib>

#include "base/random.h"
#include "model/part.h"

namespace clearcut::test_support {

/// Discs, boxes and stars united, less some islands: arcs, necks, corners of all angles, several regions at times.
Regions random_regions(Random& random);

/// A closed pocket with that outline, or (every third) a block around walls with that outline, open on all sides.
/// The outline is that of the cutter's scale: necks about as wide as `diameter` are common.
Part random_part(Random& random, double diameter);

/// A part of one feature cut by one end mill.
Part part_of(Regions target, Regions allowed, FeatureKind kind, double diameter);

/// How many random parts a test takes: CLEARCUT_RANDOM_PARTS, else `usual`.
inline int random_count(int usual) {
  const char* set = std::getenv("CLEARCUT_RANDOM_PARTS");
  return set ? std::atoi(set) : usual;
}

}  // namespace clearcut::test_support
