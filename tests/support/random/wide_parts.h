// Random parts many times as wide as the cutter: what free ways round the material do not lead back to.
#pragma once

#include "base/random.h"
#include "model/part.h"

namespace clearcut::test_support {

/// A block 20 to 50 cutter diameters wide around one to four walls, some of which reach its edge, open on all sides; or
/// (every third) a pocket of that size with islands. `diameter` in mm.
Part wide_part(Random& random, double diameter);

}  // namespace clearcut::test_support
