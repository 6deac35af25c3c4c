// Random pockets for studies: convex, acute, concave, with arcs, with islands.
#pragma once

#include <string>

#include "base/random.h"
#include "base/tolerances.h"
#include "model/part.h"

namespace clearcut::studies {

/// A pocket and a cutter that fits it.
struct RandomPocket {
  std::string kind;  ///< "convex", "acute", "concave", "arcs", "islands"
  Part part;         ///< one closed pocket 2 mm deep, one end mill
};

/// Shape   polygons of 3 to 12 corners about 40 to 160 mm wide, no angle below 8 degrees ("acute": one between 8 and 30);
///         "arcs" rounds most corners; "islands" leaves one to three discs and boxes standing. The cutter has 8 to 60 % of the
///         largest diameter that fits.
/// The same seed gives the same pocket.
RandomPocket random_pocket(std::uint64_t seed, const Tolerances& tol);

}  // namespace clearcut::studies
