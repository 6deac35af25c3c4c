#include "plan/adaptive/clearing/clearing_outline.h"

#include <gtest/gtest.h>

#include <vector>

#include "base/elementary.h"
#include "base/units.h"

namespace clearcut::plan::adaptive {
namespace {

Region region_of(const std::vector<Vec2>& corners, std::vector<Loop> islands = {}) {
  return Region::from_valid_loops(loop_from_points(corners), std::move(islands));
}

TEST(FrontArea, LeavesTheSameOnAllOfALongWallAndNothingInCorners) {
  const Region legal = region_of({{0, 0}, {40, 0}, {40, 40}, {0, 40}});
  const Region front = front_area(legal, 3, 1.36);
  double left = 0;
  while (!front.contains({20, left})) left += 1e-3;
  EXPECT_GT(left, 0.4 * 3);
  EXPECT_LT(left, 0.6 * 3);
  EXPECT_LT(front.boundary_distance({2, 1e-3}), 2e-3);
}

TEST(FrontArea, IsSmoothBetweenWallsThatComeNearer) {
  // A wedge: what is left falls with its width, in few straight pieces.
  const Region front = front_area(region_of({{0, 0}, {60, 0}, {0, 20}}), 3, 1.36);
  EXPECT_LE(front.outer().size(), 36U);
}

TEST(FrontArea, GoesRoundIslandsInFewArcs) {
  const Edge right = Edge::arc({30, 20}, {10, 20}, {20, 20}, Turn::kClockwise),
             left = Edge::arc({10, 20}, {30, 20}, {20, 20}, Turn::kClockwise);
  const Region front =
      front_area(region_of({{-10, -10}, {50, -10}, {50, 34}, {-10, 34}}, {{right, left}}), 3, 1.36);
  ASSERT_EQ(front.islands().size(), 1U);
  EXPECT_LE(front.islands()[0].size(), 16U);
}

TEST(FrontArea, StaysInsideRoundEndsOfManyShortLines) {
  // Half of a circle of 1.5 mm in 32 lines: a circle through their ends is 1.8 um beyond their middles.
  std::vector<Vec2> corners{{-20, -1.5}};
  for (int i = 0; i <= 32; ++i) {
    const double at = (i / 32.0 - 0.5) * kPi;
    corners.push_back({1.5 * base::cos(at), 1.5 * base::sin(at)});
  }
  corners.push_back({-20, 1.5});
  const Region legal = region_of(corners);
  for (const Edge& edge : front_area(legal, 3, kPi / 3).edges()) {
    for (int i = 0; i <= 64; ++i) {
      const Vec2 p = edge.at(i / 64.0);
      EXPECT_TRUE(legal.contains(p) || legal.boundary_distance(p) < 5e-4) << p.x << ' ' << p.y;
    }
  }
}

}  // namespace
}  // namespace clearcut::plan::adaptive
