#include <gtest/gtest.h>

#include "base/units.h"
#include "verify/coverage/feature_work.h"
#include "verify/test_program.h"

namespace clearcut::verify {
namespace {

using testing::circle_loop;
using testing::rectangle;

const Box kStock{{0, 0}, {40, 40}};

TEST(WithinStock, WhatLiesInItStaysAsItIs) {
  const Regions square = rectangle(0, 10, 20, 40);
  EXPECT_EQ(within_stock(square, kStock).front().outer(), square.front().outer());
  EXPECT_EQ(within_stock(square, std::nullopt).size(), 1u);
}

TEST(WithinStock, ADiscAcrossTheEdgeIsHalved) {
  const Regions disc{Region::from_valid_loops(circle_loop({20, 0}, 10), {})};
  const Regions half = within_stock(disc, kStock);
  ASSERT_EQ(half.size(), 1u);
  EXPECT_NEAR(area(half), kPi * 50, 1e-9);
  EXPECT_TRUE(contains(half, {20, 1}));
  EXPECT_FALSE(contains(half, {20, -1}));
}

TEST(WithinStock, AcrossACornerAQuarterIsLeft) {
  const Regions ring{Region::from_valid_loops(circle_loop({40, 40}, 10), {circle_loop({40, 40}, 5)})};
  const Regions quarter = within_stock(ring, kStock);
  EXPECT_NEAR(area(quarter), kPi * 75 / 4, 1e-9);
  EXPECT_TRUE(contains(quarter, {34, 36}));
  EXPECT_FALSE(contains(quarter, {38, 38}));
}

TEST(WithinStock, WhatLiesBesideItIsNothing) {
  EXPECT_TRUE(within_stock(rectangle(50, 0, 60, 10), kStock).empty());
  EXPECT_TRUE(within_stock({Region::from_valid_loops(circle_loop({55, 55}, 4), {})}, kStock).empty());
}

/// Two teeth of a comb whose back lies beyond the edge.
TEST(WithinStock, WhatHangsTogetherBeyondTheEdgeMayFallApart) {
  const std::vector<Vec2> comb{{10, -5}, {30, -5}, {30, 8}, {25, 8}, {25, -2}, {15, -2}, {15, 8}, {10, 8}};
  const Regions teeth = within_stock({Region::from_valid_loops(loop_from_points(comb), {})}, kStock);
  EXPECT_NEAR(area(teeth), 2 * 5 * 8, 1e-9);
  EXPECT_TRUE(contains(teeth, {12, 4}));
  EXPECT_TRUE(contains(teeth, {28, 4}));
  EXPECT_FALSE(contains(teeth, {20, 4}));
}

/// A slot that runs over the edge at an angle: what lies beyond leaves no edge along the side of the stock.
TEST(WithinStock, NothingIsLeftOfWhatLiesBeyondTheEdge) {
  const std::vector<Vec2> slot{{-8, 10}, {20, 18}, {20, 24}, {-8, 16}};
  const Regions within = within_stock({Region::from_valid_loops(loop_from_points(slot), {})}, kStock);
  ASSERT_EQ(within.size(), 1u);
  EXPECT_NEAR(area(within), 20 * 6, 1e-9);
  EXPECT_NEAR(box(within).min.y, 10 + 8 * 8.0 / 28, 1e-9);
}

/// Where its walls cross the side is rounded.
TEST(WithinStock, SlotsAtAnyAngleEndWhereTheyCrossTheEdge) {
  for (int i = 0; i < 40; ++i) {
    const double rise = -0.8 + i / 24.0, low = 12 + i / 7.0;
    const std::vector<Vec2> slot{{-8, low}, {20, low + 28 * rise}, {20, low + 28 * rise + 3}, {-8, low + 3}};
    const Regions within =
        within_stock({Region::from_valid_loops(loop_from_points(slot), {})}, {{{0, -100}, {40, 100}}});
    EXPECT_NEAR(box(within).min.y, low + (rise < 0 ? 28 : 8) * rise, 1e-6) << i;
    EXPECT_NEAR(box(within).max.y, low + 3 + (rise < 0 ? 8 : 28) * rise, 1e-6) << i;
  }
}

/// An island that sticks out over the edge: the side of the stock ends at it.
TEST(WithinStock, AnIslandAcrossTheEdgeLeavesNoEdgeBeforeIt) {
  const Regions ring{Region::from_valid_loops(circle_loop({0, 20}, 10), {circle_loop({0, 20}, 5)})};
  const Regions half = within_stock(ring, kStock);
  EXPECT_NEAR(area(half), kPi * 75 / 2, 1e-9);
  for (const Region& region : half)
    for (const Edge& edge : region.edges()) EXPECT_GT(distance(edge, Vec2{0, 20}), 4.9);
}

}  // namespace
}  // namespace clearcut::verify
