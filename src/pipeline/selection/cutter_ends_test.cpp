// Plans with cutters whose ends are not flat: what they leave, the next one cuts, and nothing runs into it before.
#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/run.h"

namespace clearcut::pipeline {
namespace {

Loop disc(Vec2 center, double radius) {
  const Vec2 a = center + Vec2{radius, 0}, b = center - Vec2{radius, 0};
  return {Edge::arc(a, b, center, Turn::kCounterClockwise), Edge::arc(b, a, center, Turn::kCounterClockwise)};
}

Loop box_of(double width, double height) {
  return loop_from_points(std::vector<Vec2>{{0, 0}, {width, 0}, {width, height}, {0, height}});
}

Feature pocket(const char* name, const Loop& outline, double depth) {
  Feature feature;
  feature.name = name;
  feature.target = feature.allowed = {Region::from_valid_loops(outline, {})};
  feature.floor_z = -depth;
  return feature;
}

Part part_of(const std::vector<Feature>& features) {
  Part part;
  part.name = "ends";
  part.stock = Stock{Box{{-20, -20}, {60, 60}}, -40, 0};
  part.features = features;
  part.workplan.resize(features.size());
  for (std::size_t i = 0; i < features.size(); ++i) part.workplan[i].feature = static_cast<int>(i);
  return part;
}

PlanResult planned(const Part& part, const std::vector<std::string>& tools, bool rest) {
  PlanOptions options;
  for (const std::string& tool : tools) options.tools.push_back(resolve::parse_tool(tool));
  options.shop.rest = rest;
  options.accept = {"out-of-reach"};
  return plan_part(part, options);
}

int tool_of_last(const PlanResult& plan) {
  return plan.toolpath.sections.empty() ? 0 : plan.toolpath.sections.back().tool_number;
}

void expect_no_faults(const PlanResult& plan) {
  EXPECT_EQ(verdict_and_reasons(plan.findings), "CLEAN\n");
}

TEST(CutterEnds, FlatRoundPocketsAreMilledAndNotDrilled) {
  const PlanResult plan =
      planned(part_of({pocket("POCKET", disc({10, 10}, 3), 3)}), {"drill:6:T1", "endmill:4:T2"}, false);
  EXPECT_EQ(tool_of_last(plan), 2);
  expect_no_faults(plan);
}

TEST(CutterEnds, HolesAreDrilled) {
  Feature hole = pocket("HOLE", disc({10, 10}, 3), 3);
  hole.kind = FeatureKind::kRoundHole;
  hole.hole_diameter = 6;
  const PlanResult plan = planned(part_of({hole}), {"drill:6:T1", "endmill:4:T2"}, false);
  EXPECT_EQ(tool_of_last(plan), 1);
  expect_no_faults(plan);
}

/// With a drill alone the cone that it leaves is said, and nobody takes it for a flat floor.
TEST(CutterEnds, ADrillAloneLeavesAFlatFloorOutOfReach) {
  PlanOptions options;
  options.tools = {resolve::parse_tool("drill:6:T1")};
  const PlanResult plan = plan_part(part_of({pocket("POCKET", disc({10, 10}, 3), 3)}), options);
  ASSERT_EQ(verdict_of(plan.findings), Verdict::kConditional);
  const auto open = open_conditions(plan.findings);
  ASSERT_EQ(open.size(), 1u);
  EXPECT_EQ(open[0].name, "out-of-reach");
  EXPECT_NE(open[0].text.find("ends in a point"), std::string::npos) << open[0].text;
}

TEST(CutterEnds, AFlatMillFinishesWhatABullNoseLeaves) {
  for (const char* mill : {"endmill:4:T2", "endmill:8:T2"}) {
    const PlanResult plan =
        planned(part_of({pocket("POCKET", box_of(40, 30), 6)}), {"bullnose:8:corner=2:T1", mill}, true);
    EXPECT_EQ(tool_of_last(plan), 2) << mill;
    expect_no_faults(plan);
    // Corners alone stay: less than a quarter of the square about each of the flat mill's discs.
    EXPECT_LT(plan.findings.all.unreachable_mm2, 14) << mill;
  }
}

/// The fillets at the walls, and the ridges between the ball's passes, layer by layer.
TEST(CutterEnds, AFlatMillFinishesWhatABallLeaves) {
  for (const char* mill : {"endmill:8:T2", "endmill:3:T2"}) {
    const PlanResult plan =
        planned(part_of({pocket("POCKET", box_of(30, 20), 4)}), {"ball:8:T1", mill}, true);
    EXPECT_EQ(tool_of_last(plan), 2) << mill;
    expect_no_faults(plan);
  }
}

/// In a round pocket the ring that a bull-nose leaves is all that stands, and no hole to start from is as wide as the pocket.
TEST(CutterEnds, TheRingOfARoundPocketIsCutByEveryStrategy) {
  for (const char* strategy : {"contour", "zigzag", "spiral", "adaptive"}) {
    PlanOptions options;
    options.tools = {resolve::parse_tool("bullnose:7:corner=0.6:T1"), resolve::parse_tool("endmill:7:T2")};
    options.shop.rest = true;
    options.strategy = strategy;
    expect_no_faults(plan_part(part_of({pocket("POCKET", disc({10, 10}, 5.6), 1.2)}), options));
  }
}

/// The start hole of a pocket is as deep as its drill is wide: a mill that may not plunge enters where the cone ends, or on a slope.
TEST(CutterEnds, AMillThatMayNotPlungeKeepsOffTheConeOfItsStartHole) {
  Feature hole = pocket("HOLE", disc({20, 15}, 4.5), 4);
  hole.kind = FeatureKind::kRoundHole;
  hole.hole_diameter = 9;
  const Part part = part_of({hole, pocket("POCKET", box_of(40, 30), 4)});
  expect_no_faults(planned(part, {"drill:9:T1", "endmill:8:noplunge:T2"}, false));
}

}  // namespace
}  // namespace clearcut::pipeline
