#include "plan/adaptive.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
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

/// The closed form against counting on the circle, at the places that the closed form samples and between
/// them.
TEST(Adaptive, ContactOfACrescentIsItsGreatestCountedContact) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Disc cleared{{0, 0}, random.between(4, 20)};
    const Disc next{direction_of(random.between(-3, 3)) * random.between(0.1, 1.5),
                    cleared.radius + random.between(-1, 1)};
    if (next.radius < kTool + 0.5) continue;
    const double half = crescent_half_angle(cleared, next);
    const double axis = angle_of(next.center);
    double counted = 0;
    for (int k = 0; k <= 48; ++k) {
      const double direction = axis + half * (k / 24.0 - 1);
      const Vec2 u = direction_of(direction);
      counted =
          std::max(counted, counted_contact(next.center + u * (next.radius - kTool), left_of(u), cleared));
    }
    EXPECT_NEAR(crescent_engagement(cleared, next, kTool), counted, 0.02) << i;
  }
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
  ASSERT_EQ(passes.size(), 2u);
  EXPECT_TRUE(passes[0].closed);
  const auto& clearing = passes[1];
  EXPECT_EQ(clearing.path.size(), clearing.kinds.size());
  EXPECT_EQ(clearing.parent, 0);
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
