#include "geometry/spatial/apart.h"

#include <gtest/gtest.h>

#include "base/random.h"
#include "base/units.h"
#include "geometry/contours/boolean.h"

namespace clearcut::inline geometry {
namespace {

Loop square(Vec2 center, double half) {
  return loop_from_points(std::vector<Vec2>{center + Vec2{-half, -half}, center + Vec2{half, -half},
                                            center + Vec2{half, half}, center + Vec2{-half, half}});
}

Loop ring(Vec2 center, double radius) {
  const Vec2 right = center + Vec2{radius, 0}, left = center - Vec2{radius, 0};
  return {Edge::arc(right, left, center, Turn::kCounterClockwise),
          Edge::arc(left, right, center, Turn::kCounterClockwise)};
}

Regions plain(Loop outer) {
  return {Region::from_valid_loops(std::move(outer), {})};
}

TEST(Apart, AnAreaInAnothersIslandIsApartFromIt) {
  const Regions frame{Region::from_valid_loops(square({0, 0}, 20), {ring({0, 0}, 10)})};
  EXPECT_TRUE(are_apart(frame, plain(square({0, 0}, 5)), 0.01));
  EXPECT_TRUE(are_apart(plain(square({0, 0}, 5)), frame, 0.01));
  EXPECT_FALSE(are_apart(frame, plain(square({0, 0}, 8)), 0.01));
  EXPECT_FALSE(are_apart(frame, plain(ring({15, 0}, 2)), 0.01));
}

TEST(Apart, WhatHoldsTheOtherWholeIsNot) {
  EXPECT_FALSE(are_apart(plain(square({0, 0}, 20)), plain(ring({3, 2}, 1)), 0.01));
  EXPECT_FALSE(are_apart(plain(ring({3, 2}, 1)), plain(square({0, 0}, 20)), 0.01));
}

TEST(Apart, TheGapCounts) {
  const Regions left = plain(square({0, 0}, 5)), right = plain(square({10.02, 0}, 5));
  EXPECT_TRUE(are_apart(left, right, 0.01));
  EXPECT_FALSE(are_apart(left, right, 0.03));
}

TEST(Apart, WhatIsCalledApartHasNoIntersection) {
  Random random(5);
  const Tolerances tol;
  int apart = 0;
  for (int i = 0; i < 300; ++i) {
    const auto blob = [&] {
      const Vec2 center{random.between(-10, 10), random.between(-10, 10)};
      std::vector<Vec2> points;
      for (int k = 0; k < 9; ++k)
        points.push_back(center + rotated(Vec2{random.between(1, 9), 0}, 2 * kPi * k / 9));
      return plain(loop_from_points(points));
    };
    const Regions a = blob(), b = blob();
    const bool meet = !intersect(a, b, tol).empty();
    if (are_apart(a, b, 0.001)) {
      ++apart;
      EXPECT_FALSE(meet) << i;
    }
  }
  EXPECT_GT(apart, 60);
}

}  // namespace
}  // namespace clearcut::inline geometry
