// The heights at which the fishhead's features begin.
#include "studies/fishhead.h"

#include <gtest/gtest.h>

#include <cstddef>

#include "features/standing.h"
#include "geometry/region.h"

namespace clearcut::studies {
namespace {

// The wall that FACE2 leaves is wider than what FACE3 leaves of it: a wedge beside it stands at -2, the rest
// at -12.
TEST(Fishhead, TopsByStacking) {
  const Part part = fishhead(false, {});
  const double tops[] = {0, -2, -2, -12, -17, -17, -23.5, -23.5, -23.5, -23.5};
  ASSERT_EQ(part.features.size(), 10U);
  for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(part.features[i].top_z, tops[i]) << part.features[i].name;
  const features::Standing third(part, 2, {});
  EXPECT_LT(area(third.above(-11)), 200);
  EXPECT_NEAR(area(third.above(-13)), area(part.features[2].target), 1e-2);
}

}  // namespace
}  // namespace clearcut::studies
