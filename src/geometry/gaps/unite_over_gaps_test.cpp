#include "geometry/gaps/unite_over_gaps.h"

#include <gtest/gtest.h>

#include "base/random.h"
#include "geometry/contours/boolean.h"
#include "geometry/region.h"

namespace clearcut::inline geometry {
namespace {

Regions polygon(const std::vector<Vec2>& corners) {
  return {Region::from_valid_loops(loop_from_points(corners), {})};
}

/// A rectangle, and another one above it, `gap` mm away at its left end and `far` mm at its right.
Regions lower() {
  return polygon({{0, -5}, {10, -5}, {10, 0}, {0, 0}});
}
Regions upper(double gap, double far) {
  return polygon({{0, gap}, {10, far}, {10, 5}, {0, 5}});
}

TEST(UniteOverGaps, ClosesWhatIsNotWider) {
  const Tolerances tol;
  for (const double gap : {1e-9, 1e-7, 1e-5, 1e-4, 3e-4, 9.9e-4}) {
    const Regions all = unite_over_gaps(lower(), upper(gap, gap), 1e-3, tol);
    ASSERT_EQ(all.size(), 1u) << gap;
    EXPECT_TRUE(all[0].islands().empty());
    for (double x = 0.01; x < 10; x += 0.1) EXPECT_TRUE(contains(all, {x, gap / 2})) << gap << " at " << x;
  }
  EXPECT_EQ(unite_over_gaps(lower(), upper(1.1e-3, 1.1e-3), 1e-3, tol).size(), 2u);
}

TEST(UniteOverGaps, ClosesAWedgeAsFarAsItIsNotWider) {
  const Regions all = unite_over_gaps(lower(), upper(0, 2e-3), 1e-3, Tolerances{});
  for (double x = 0.05; x < 10; x += 0.1) EXPECT_EQ(contains(all, {x, x * 1e-4}), x < 5) << x;
}

TEST(UniteOverGaps, ClosesRoundGapsAndOnesBetweenRoundAndStraight) {
  const double radius = 6;
  const auto disc = [&](double r) {
    return Loop{Edge::arc({r, 0}, {-r, 0}, {0, 0}, Turn::kCounterClockwise),
                Edge::arc({-r, 0}, {r, 0}, {0, 0}, Turn::kCounterClockwise)};
  };
  for (const double gap : {1e-5, 1e-4, 5e-4, 9e-4}) {
    const Regions plate{Region::from_valid_loops(rectangle(Box{{-9, -9}, {9, 9}}), {disc(radius + gap)})};
    const Regions all =
        unite_over_gaps({Region::from_valid_loops(disc(radius), {})}, plate, 1e-3, Tolerances{});
    ASSERT_EQ(all.size(), 1u) << gap;
    EXPECT_TRUE(all[0].islands().empty()) << gap;
  }
}

TEST(UniteOverGaps, IsTheUnionWhereNoGapIsNarrow) {
  Random random(7);
  const Tolerances tol;
  for (int i = 0; i < 200; ++i) {
    const auto corner = [&](double x) { return Vec2{x + random.between(0, 4), random.between(0, 9)}; };
    const Vec2 a = corner(0), b = corner(3);
    const Regions one{Region::from_valid_loops(rectangle(Box{a, a + Vec2{4, 3}}), {})};
    const Regions other{Region::from_valid_loops(rectangle(Box{b, b + Vec2{3, 4}}), {})};
    EXPECT_NEAR(area(unite_over_gaps(one, other, 1e-3, tol)), area(unite(one, other, tol)), 0.02);
  }
}

TEST(WithoutShortEdges, DrawsRunsTogetherIntoOneCorner) {
  const Regions dirty = polygon({{0, 0}, {10, 0}, {10, 9.9998}, {9.9999, 10}, {9.9996, 10.0001}, {0, 10}});
  const Regions clean = without_short_edges(dirty, 1e-3);
  ASSERT_EQ(clean[0].outer().size(), 4u);
  EXPECT_NEAR(area(clean), area(dirty), 0.01);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(clean[0].outer()[i].to, clean[0].outer()[(i + 1) % 4].from);
}

TEST(WithoutShortEdges, LeavesWhatIsNotShort) {
  const Regions plain = lower();
  EXPECT_EQ(without_short_edges(plain, 1e-3)[0].outer(), plain[0].outer());
  const Regions tiny = polygon({{0, 0}, {5e-4, 0}, {5e-4, 5e-4}, {0, 5e-4}});
  EXPECT_EQ(without_short_edges(tiny, 1e-3)[0].outer().size(), 4u);
}

}  // namespace
}  // namespace clearcut::inline geometry
