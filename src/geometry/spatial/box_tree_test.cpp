#include "geometry/spatial/box_tree.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"

namespace clearcut {
namespace {

TEST(BoxTree, FindsTheNearestAndTheFirstOfSeveralAsTryingAllDoes) {
  Random random(7);
  for (const std::uint32_t count : {0u, 1u, 7u, 8u, 9u, 100u, 1000u}) {
    std::vector<Vec2> points;
    // On a lattice, so that many are equally far.
    for (std::uint32_t i = 0; i < count; ++i)
      points.push_back({std::floor(random.between(0, 9)), std::floor(random.between(0, 9))});
    BoxTree tree;
    tree.build(count, [&](std::uint32_t i) { return Box{points[i], points[i]}; });
    for (int k = 0; k < 200; ++k) {
      const Vec2 p{std::floor(random.between(-5, 15)), random.between(-5, 15)};
      std::uint32_t best = 0;
      for (std::uint32_t i = 1; i < count; ++i)
        if (norm_squared(points[i] - p) < norm_squared(points[best] - p)) best = i;
      EXPECT_EQ(tree.nearest(p, [&](std::uint32_t i) { return norm_squared(points[i] - p); }), best);
    }
  }
}

}  // namespace
}  // namespace clearcut
