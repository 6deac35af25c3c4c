#include "geometry/region.h"

#include <gtest/gtest.h>

#include "base/random.h"
#include "base/units.h"

namespace clearcut::inline geometry {
namespace {

Loop square(double half) {
  const Vec2 points[] = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
  return loop_from_points(points);
}

Loop circle(Vec2 c, double r) {
  const BulgeVertex vertices[] = {{c - Vec2{r, 0}, 1}, {c + Vec2{r, 0}, 1}};
  return loop_from_bulges(vertices);
}

TEST(Loop, PointsWrittenTwiceAreOneVertex) {
  const Vec2 points[] = {{0, 0}, {1, 0}, {1, 0}, {0, 1}, {0, 0}};
  EXPECT_EQ(loop_from_points(points).size(), 3U);
}

TEST(Loop, BulgesComeBack) {
  const BulgeVertex vertices[] = {{{0, 0}, 0}, {{10, 0}, 0.4}, {{10, 8}, -0.2}, {{0, 8}, 0}};
  const auto back = to_bulges(loop_from_bulges(vertices));
  ASSERT_EQ(back.size(), 4U);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(back[i].point, vertices[i].point);
    EXPECT_NEAR(back[i].bulge, vertices[i].bulge, 1e-14);
  }
}

TEST(Loop, AreaIsExactForArcsAndFarFromTheOrigin) {
  EXPECT_NEAR(signed_area(circle({3, 4}, 2)), 4 * kPi, 1e-12);
  EXPECT_NEAR(signed_area(circle({3e6, 4e6}, 2)), 4 * kPi, 1e-7);
  EXPECT_NEAR(signed_area(reversed(circle({3, 4}, 2))), -4 * kPi, 1e-12);
}

TEST(Loop, FlattenedStartsAtItsFirstVertex) {
  const auto points = flattened(circle({0, 0}, 5), 0.01);
  EXPECT_EQ(points.front(), (Vec2{-5, 0}));
  for (const Vec2 p : points) EXPECT_NEAR(norm(p), 5, 1e-12);
  EXPECT_EQ(flattened(square(1), 0.01).size(), 4U);
}

TEST(Contains, CircleEverywhere) {
  const Loop loop = circle({1, 2}, 3);
  Random random(3);
  for (int i = 0; i < 20000; ++i) {
    const Vec2 p{random.between(-3, 5), random.between(-2, 6)};
    const double d = norm(p - Vec2{1, 2});
    if (std::abs(d - 3) > 1e-9) {
      ASSERT_EQ(contains(loop, p), d < 3) << p.x << ' ' << p.y;
    }
  }
}

TEST(Contains, PointsLevelWithVerticesOnChordsAndCenters) {
  // The ray from each of these runs through vertices, along chords or through arc ends.
  EXPECT_TRUE(contains(circle({0, 0}, 5), {0, 0}));
  EXPECT_TRUE(contains(circle({0, 0}, 5), {-4.999, 0}));
  EXPECT_FALSE(contains(circle({0, 0}, 5), {-5.001, 0}));
  EXPECT_FALSE(contains(circle({0, 0}, 5), {5.001, 0}));
  const Vec2 diamond[] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
  EXPECT_TRUE(contains(loop_from_points(diamond), {0, 0}));
  EXPECT_FALSE(contains(loop_from_points(diamond), {-2, 0}));
  EXPECT_FALSE(contains(loop_from_points(diamond), {-1, 1}));
  EXPECT_FALSE(contains(loop_from_points(diamond), {-1, -1}));
}

/// A loop of alternating bows against the even-odd count of its fine polygon.
TEST(Contains, AgreesWithTheFinePolygonOnWavyLoops) {
  Random random(4);
  for (int shape = 0; shape < 40; ++shape) {
    std::vector<BulgeVertex> vertices;
    const int n = 3 + static_cast<int>(random.below(8));
    for (int i = 0; i < n; ++i) {
      // Rounded radii put many vertices on common levels.
      const Vec2 p = direction_of(2 * kPi * i / n) * static_cast<double>(5 + random.below(6));
      vertices.push_back({{std::round(p.x), std::round(p.y)}, random.between(-0.3, 0.3)});
    }
    const Loop loop = loop_from_bulges(vertices);
    const Loop fine = loop_from_points(flattened(loop, 1e-6));
    for (int i = 0; i < 300; ++i) {
      const Vec2 p{std::round(random.between(-12, 12) * 2) / 2, std::round(random.between(-12, 12) * 2) / 2};
      double d = 1e300;
      for (const Edge& edge : loop) d = std::min(d, distance(edge, p));
      if (d > 1e-5) {
        ASSERT_EQ(contains(loop, p), contains(fine, p)) << shape << ": " << p.x << ' ' << p.y;
      }
    }
  }
}

TEST(Region, OrientsItsLoops) {
  const Region region = Region::from_valid_loops(reversed(square(10)), {circle({0, 0}, 2)});
  EXPECT_GT(signed_area(region.outer()), 0);
  EXPECT_LT(signed_area(region.islands()[0]), 0);
  EXPECT_NEAR(region.area(), 400 - 4 * kPi, 1e-9);
  EXPECT_TRUE(region.contains({5, 5}));
  EXPECT_FALSE(region.contains({1, 0}));
  EXPECT_FALSE(region.contains({11, 0}));
  EXPECT_NEAR(region.boundary_distance({6, 0}), 4, 1e-12);
  EXPECT_NEAR(region.boundary_distance({3, 0}), 1, 1e-12);
  EXPECT_EQ(region.edges().size(), 6U);
}

TEST(Regions, AreaBoxContainsOfAll) {
  const Regions two{Region::from_valid_loops(circle({0, 0}, 1), {}),
                    Region::from_valid_loops(circle({10, 0}, 2), {})};
  EXPECT_NEAR(area(two), 5 * kPi, 1e-12);
  EXPECT_NEAR(box(two).max.x, 12, 1e-12);
  EXPECT_TRUE(contains(two, {11, 0}));
  EXPECT_FALSE(contains(two, {5, 0}));
}

}  // namespace
}  // namespace clearcut::inline geometry
