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

TEST(BoxTree, DescendsIntoEveryOpenBoxInOrder) {
  Random random(8);
  for (const std::uint32_t count : {0u, 1u, 8u, 9u, 500u}) {
    std::vector<Box> boxes;
    for (std::uint32_t i = 0; i < count; ++i) {
      const Vec2 p{random.between(0, 90), random.between(0, 90)};
      boxes.push_back({p, p + Vec2{random.between(0, 9), random.between(0, 9)}});
    }
    BoxTree tree;
    tree.build(count, [&](std::uint32_t i) { return boxes[i]; });
    for (int k = 0; k < 100; ++k) {
      const Vec2 p{random.between(0, 90), random.between(0, 90)};
      const Box window{p, p + Vec2{10, 5}};
      std::vector<std::uint32_t> wanted, found;
      for (std::uint32_t i = 0; i < count; ++i)
        if (boxes[i].overlaps(window)) wanted.push_back(i);
      tree.descend([&](const Box& box) { return box.overlaps(window); },
                   [&](std::uint32_t i) {
                     if (boxes[i].overlaps(window)) found.push_back(i);
                   });
      EXPECT_EQ(found, wanted);
    }
  }
}

}  // namespace
}  // namespace clearcut
