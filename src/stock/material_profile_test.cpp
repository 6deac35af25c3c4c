// What cutters with rounded, pointed and conical ends leave, in closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "stock/cutting_load.h"

namespace clearcut::stock {
namespace {

Tool tool_of(ToolKind kind, double diameter, double corner_radius = 0) {
  Tool tool;
  tool.kind = kind;
  tool.diameter = diameter;
  tool.corner_radius = corner_radius;
  return tool;
}

Tool cone(ToolKind kind, double diameter, double degrees, double tip = 0) {
  Tool tool = tool_of(kind, diameter);
  tool.tip_angle = Radians::of_degrees(degrees);
  tool.tip_diameter = tip;
  return tool;
}

Move level(Vec2 from, Vec2 to, double z) {
  return {Edge::line(from, to), z, z, MoveKind::kCut, MmPerMin::of(500), 0};
}

Move down(Vec2 at, double z) {
  return {Edge::line(at, at), 5, z, MoveKind::kPlunge, MmPerMin::of(100), 0};
}

Material cut_by(const Tool& tool, const Move& move) {
  Material material(Box{{-50, -50}, {50, 50}}, 0, {tool.radius()});
  remove_cut(material, move, tool);
  return material;
}

TEST(MaterialProfile, DrillsLeaveTheirCone) {
  const Material hole = cut_by(cone(ToolKind::kDrill, 6, 90), down({0, 0}, -5));
  EXPECT_NEAR(hole.height({0, 0}), -5, 1e-12);
  EXPECT_NEAR(hole.height({2, 0}), -3, 1e-12);
  EXPECT_EQ(hole.height({3.1, 0}), 0);
  EXPECT_FALSE(hole.is_removed({2, 0}, -3.01));
  EXPECT_TRUE(hole.is_removed({2, 0}, -2.99));
}

TEST(MaterialProfile, DrillsWithoutAStatedAngleHave118Degrees) {
  const Material hole = cut_by(tool_of(ToolKind::kDrill, 6), down({0, 0}, -5));
  EXPECT_NEAR(hole.height({2, 0}), -5 + 2 / std::tan(59 * kPi / 180), 1e-12);
}

TEST(MaterialProfile, BallsAndBullNosesLeaveFillets) {
  const Material groove = cut_by(tool_of(ToolKind::kBallEndMill, 8, 4), level({-20, 0}, {20, 0}, -4));
  EXPECT_NEAR(groove.height({0, 2}), -4 + 4 - std::sqrt(12), 1e-12);
  const Material slot = cut_by(tool_of(ToolKind::kBullNoseEndMill, 8, 1), level({-20, 0}, {20, 0}, -4));
  EXPECT_NEAR(slot.height({0, 2.9}), -4, 1e-12);
  EXPECT_NEAR(slot.height({0, 3.6}), -4 + 1 - std::sqrt(1 - 0.36), 1e-12);
}

TEST(MaterialProfile, ConesLeaveWhatStandsBesideTheirFlanks) {
  const Material groove = cut_by(cone(ToolKind::kChamferMill, 10, 90, 2), level({-20, 0}, {20, 0}, -3));
  EXPECT_NEAR(groove.height({0, 0.9}), -3, 1e-12);
  EXPECT_NEAR(groove.height({0, 2.5}), -1.5, 1e-12);
}

TEST(MaterialProfile, ToolsThatCutThreadsAndUndercutsTakeNothingForCertain) {
  for (const ToolKind kind : {ToolKind::kTap, ToolKind::kThreadMill, ToolKind::kTSlot}) {
    const Material hole = cut_by(tool_of(kind, 6), down({0, 0}, -5));
    EXPECT_EQ(hole.height({0, 0}), 0) << name_of(kind);
  }
}

/// A ramp of a cone at 45 degrees to the side: over its middle its flank is lowest where the tip has gone on.
TEST(MaterialProfile, RampsOfConesAreLowestWhereTheFlankPassesLast) {
  const Move ramp{Edge::line({0, 0}, {20, 0}), 0, -10, MoveKind::kRamp, MmPerMin::of(100), 0};
  const Material groove = cut_by(cone(ToolKind::kVBit, 20, 90), ramp);
  // z(x) = -x / 2 and the flank at a distance d stands d higher: least at x = 10 + 1 / sqrt(3) for a place 1 mm aside of x = 10.
  const double x = 10 + 1 / std::sqrt(3.0);
  EXPECT_NEAR(groove.height({10, 1}), -x / 2 + std::hypot(x - 10, 1), 1e-9);
}

/// A cutter passes through the groove that a cutter of its shape has cut; a wider one meets the material beside the groove.
TEST(MaterialProfile, ACutterPassesThroughItsOwnGroove) {
  const Tool ball = tool_of(ToolKind::kBallEndMill, 8, 4), mill = tool_of(ToolKind::kEndMill, 8);
  const Move way = level({-10, 0}, {10, 0}, -3);
  const Material groove = cut_by(ball, way);
  const auto met = [&](const Tool& tool, double z) {
    return groove.in_reach(way.path, outer_profile(tool).narrowed(1e-3), z + 1e-3).has_value();
  };
  EXPECT_FALSE(met(ball, -3));
  EXPECT_TRUE(met(ball, -3.1));
  EXPECT_TRUE(met(mill, -2.9));
  EXPECT_TRUE(met(mill, -0.1)) << "the ball is not as wide as the mill before its middle";
  EXPECT_FALSE(met(mill, 0));
}

TEST(MaterialProfile, AMillGoesDownInAHoleAsFarAsItIsWide) {
  const Tool drill = cone(ToolKind::kDrill, 6, 90);
  const Material hole = cut_by(drill, down({0, 0}, -8));
  const Edge here = Edge::line({0, 0}, {0, 0});
  const auto met = [&](double diameter, double z) {
    return hole.in_reach(here, CutterProfile::cylinder(diameter / 2 - 1e-3), z + 1e-3).has_value();
  };
  EXPECT_FALSE(met(6, -4.99));
  EXPECT_TRUE(met(6, -5.1));
  EXPECT_FALSE(met(4, -5.99));
  EXPECT_TRUE(met(4, -6.1));
}

/// The same height whether it is asked at a place or found by cells.
TEST(MaterialProfile, SearchesAgreeWithHeights) {
  Random random(7);
  const Tool tools[] = {tool_of(ToolKind::kBallEndMill, 6, 3), tool_of(ToolKind::kBullNoseEndMill, 7, 1.5),
                        cone(ToolKind::kVBit, 8, 70), tool_of(ToolKind::kEndMill, 5)};
  Material material(Box{{0, 0}, {30, 30}}, 0, {2.5, 3, 3.5, 4});
  const auto point = [&] { return Vec2{random.between(3, 27), random.between(3, 27)}; };
  for (int i = 0; i < 24; ++i) {
    Move move = level(point(), point(), random.between(-5, -1));
    if (i % 3 == 0) move.z_to = random.between(-5, -1);
    remove_cut(material, move, tools[random.below(4)]);
  }
  int met = 0;
  for (int i = 0; i < 300; ++i) {
    const CutterProfile cutter = outer_profile(tools[random.below(4)]);
    const Vec2 at = point();
    const double z = random.between(-4, 0);
    const auto hit = material.in_reach(Edge::line(at, at), cutter, z);
    if (hit) {
      ++met;
      EXPECT_GT(material.height(*hit), z + cutter.height_at(distance(*hit, at)) - 1e-9);
      continue;
    }
    for (int k = 0; k < 200; ++k) {
      const Vec2 p =
          at + direction_of(random.between(-kPi, kPi)) * (cutter.widest * std::sqrt(random.between(0, 1)));
      if (material.height(p) > z + cutter.height_at(distance(p, at)) + 0.3)
        ADD_FAILURE() << "unseen at " << p.x << " " << p.y << " for a tip at " << at.x << " " << at.y << " "
                      << z;
    }
  }
  EXPECT_GT(met, 100);
  EXPECT_LT(met, 290);
}

/// Of its own passes the circle of a cutter counts, whatever its end: what a ball engages beside them is what a flat mill would.
TEST(MaterialProfile, EngagementBesideOwnPassesIsThatOfTheCircle) {
  const Tool ball = tool_of(ToolKind::kBallEndMill, 8, 4), mill = tool_of(ToolKind::kEndMill, 8);
  const Move way = level({-20, 0}, {20, 0}, -2);
  Material by_ball = cut_by(ball, way);
  const Material by_mill = cut_by(mill, way);
  const Move beside = level({-20, 3}, {20, 3}, -2);
  const int own = add_tool(by_ball, ball);
  EXPECT_EQ(by_ball.engagement(beside, 0.5, 3.999, own).angle, by_mill.engagement(beside, 0.5, 3.999).angle);
  EXPECT_GT(by_ball.engagement(beside, 0.5, 3.999).angle, by_mill.engagement(beside, 0.5, 3.999).angle);
}

}  // namespace
}  // namespace clearcut::stock
