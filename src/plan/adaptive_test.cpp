#include "plan/adaptive.h"

#include <gtest/gtest.h>

#include <cmath>

#include "plan/adaptive_cut.h"

namespace clearcut {
namespace {

constexpr double kTool = 3;

/// Contact of the cutter at p, moving along `travel`, where only `cleared` is free: counted on its circle.
double counted_contact(Vec2 p, Vec2 travel, const Disc& cleared) {
  constexpr int kParts = 20000;
  int inside = 0;
  for (int i = 0; i < kParts; ++i) {
    const Vec2 u = direction_of(2 * kPi * (i + 0.5) / kParts);
    if (dot(u, travel) > 0 && distance(p + u * kTool, cleared.center) > cleared.radius) ++inside;
  }
  return 2 * kPi * inside / kParts;
}

TEST(Adaptive, WidenedCircleHasExactlyTheContactAskedFor) {
  for (const double angle : {0.3, 0.9, 1.4, 2.0}) {
    for (const double cleared : {3.5, 6.0, 30.0}) {
      const double d = widened_circle(cleared, kTool, angle);
      EXPECT_NEAR(counted_contact({d, 0}, {0, 1}, {{0, 0}, cleared}), angle, 2e-3) << angle << " " << cleared;
    }
  }
}

Layer square_layer(double side) {
  Layer layer;
  layer.z = -2;
  layer.tool_radius = kTool;
  layer.allowed = layer.target = {Region::from_valid_loops(
      loop_from_points(std::vector<Vec2>{{0, 0}, {side, 0}, {side, side}, {0, side}}), {})};
  return layer;
}

TEST(Adaptive, PathIsJoinedAndEveryEdgeHasItsKind) {
  const auto passes = plan_adaptive(square_layer(50), {}, {}).passes;
  ASSERT_EQ(passes.size(), 1u);
  const auto& clearing = passes[0];
  EXPECT_EQ(clearing.path.size(), clearing.kinds.size());
  ASSERT_TRUE(clearing.entry_center);
  EXPECT_NEAR(distance(*clearing.entry_center, {25, 25}), 0, 1e-3);
  for (std::size_t i = 1; i < clearing.path.size(); ++i)
    EXPECT_EQ(clearing.path[i].from, clearing.path[i - 1].to);
}

TEST(Adaptive, NothingWhereTheCutterDoesNotFit) {
  EXPECT_TRUE(plan_adaptive(square_layer(5.9), {}, {}).passes.empty());
}

}  // namespace
}  // namespace clearcut
