#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "geometry/region.h"

namespace clearcut::inline geometry {
namespace {

using ::testing::HasSubstr;

Loop loop(std::vector<Vec2> points) {
  return loop_from_points(points);
}

Loop square(double x, double y, double side) {
  return loop({{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}});
}

TEST(RegionPromise, KeptByWhatTouchesInPoints) {
  EXPECT_EQ(broken_promise(square(0, 0, 10), {square(2, 2, 2), square(4, 4, 2)}), "");
  EXPECT_EQ(broken_promise(square(0, 0, 10), {loop({{0, 5}, {2, 4}, {2, 6}})}), "");
  EXPECT_EQ(broken_promise(square(0, 0, 10), {loop({{-5e-4, 5}, {2, 4}, {2, 6}})}), "");
}

Loop disc(Vec2 center, double radius) {
  const Vec2 right = center + Vec2{radius, 0}, left = center - Vec2{radius, 0};
  return {Edge::arc(left, right, center, Turn::kCounterClockwise),
          Edge::arc(right, left, center, Turn::kCounterClockwise)};
}

TEST(RegionPromise, KeptByWhatTouchesAlongItsWay) {
  EXPECT_EQ(broken_promise(square(0, 0, 50), {disc({25, 10}, 10)}), "");
  EXPECT_EQ(broken_promise(square(0, 0, 50), {disc({25, 9.9995}, 10)}), "");
  EXPECT_EQ(broken_promise(disc({0, 0}, 20), {disc({0, -12}, 8)}), "");
  EXPECT_THAT(broken_promise(square(0, 0, 50), {disc({25, 9.998}, 10)}), HasSubstr("cross"));
}

TEST(RegionPromise, KeptByAWallOfNoThickness) {
  EXPECT_EQ(broken_promise(square(0, 0, 10), {loop({{2, 2}, {8, 8}})}), "");
}

TEST(RegionPromise, BrokenByOpenAndEmptyLoops) {
  Loop open = square(0, 0, 10);
  open.pop_back();
  EXPECT_THAT(broken_promise(open, {}), HasSubstr("not closed"));
  EXPECT_THAT(broken_promise({}, {}), HasSubstr("empty"));
  EXPECT_THAT(broken_promise(loop({{0, 0}, {1, 0}}), {}), HasSubstr("encloses nothing"));
}

TEST(RegionPromise, BrokenByCrossings) {
  EXPECT_THAT(broken_promise(loop({{0, 0}, {10, 10}, {12, 0}, {0, 9}}), {}), HasSubstr("cross"));
  EXPECT_THAT(broken_promise(square(0, 0, 10), {square(8, 2, 4)}), HasSubstr("cross"));
  const Loop disc{Edge::arc({-3, 5}, {3, 5}, {0, 5}, Turn::kCounterClockwise),
                  Edge::arc({3, 5}, {-3, 5}, {0, 5}, Turn::kCounterClockwise)};
  EXPECT_THAT(broken_promise(square(0, 0, 10), {disc}), HasSubstr("cross"));
}

/// Two arcs that bow inwards go through each other before they meet in their corner.
TEST(RegionPromise, BrokenByNeighboursThatCross) {
  const std::vector<BulgeVertex> corners{{{11, 9}, -0.2}, {{-12, 0}, -0.2}, {{1, -5}, -0.2}};
  EXPECT_THAT(broken_promise(loop_from_bulges(corners), {}), HasSubstr("cross"));
  const std::vector<BulgeVertex> straight{{{11, 9}, 0}, {{-12, 0}, 0}, {{1, -5}, 0.1}};
  EXPECT_EQ(broken_promise(loop_from_bulges(straight), {}), "");
}

TEST(RegionPromise, BrokenByIslandsInWrongPlaces) {
  EXPECT_THAT(broken_promise(square(0, 0, 10), {square(20, 0, 2)}), HasSubstr("outside"));
  EXPECT_THAT(broken_promise(square(0, 0, 10), {square(2, 2, 6), square(4, 4, 1)}),
              HasSubstr("within another"));
}

#ifndef NDEBUG
TEST(RegionPromise, IsCheckedWhereRegionsAreMade) {
  EXPECT_THROW(Region::from_valid_loops(square(0, 0, 10), {square(8, 2, 4)}), InternalError);
}
#endif

}  // namespace
}  // namespace clearcut::inline geometry
