// Tops by stacking: the height that earlier features leave over a later one's target.
#include <gtest/gtest.h>

#include "base/random.h"
#include "features/standing.h"
#include "model/part.h"

namespace clearcut::features {
namespace {

Region rectangle(double x0, double y0, double x1, double y1) {
  const Vec2 corners[] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  return Region::from_valid_loops(loop_from_points(corners), {});
}

void add(Part& part, const Region& target, double declared_top, double floor_z) {
  Feature feature;
  feature.name = "F" + std::to_string(part.features.size() + 1);
  feature.target = feature.allowed = {target};
  feature.top_z = declared_top;
  feature.floor_z = floor_z;
  Workingstep step;
  step.feature = static_cast<int>(part.features.size());
  part.features.push_back(feature);
  part.workplan.push_back(step);
}

Part block() {
  Part part;
  part.stock = Stock{{{0, 0}, {100, 100}}, -50, 0};
  return part;
}

TEST(Stacking, AFeatureInsideAnEarlierOneBeginsAtItsFloor) {
  Part part = block();
  add(part, rectangle(10, 10, 90, 90), 0, -5);
  add(part, rectangle(20, 20, 80, 80), -5, -12);
  stack_tops(part, {});
  EXPECT_EQ(part.features[0].top_z, 0);
  EXPECT_EQ(part.features[1].top_z, -5);
  EXPECT_TRUE(part.diagnostics.items().empty());
}

TEST(Stacking, AFeatureThatReachesBeyondAnEarlierOneBeginsAtTheHighestPlaceLeft) {
  Part part = block();
  add(part, rectangle(10, 10, 50, 90), 0, -5);
  add(part, rectangle(50, 10, 90, 90), 0, -3);
  add(part, rectangle(20, 20, 80, 80), -5, -12);
  stack_tops(part, {});
  EXPECT_EQ(part.features[2].top_z, -3);
  ASSERT_EQ(part.diagnostics.items().size(), 1U);
  EXPECT_EQ(part.diagnostics.items()[0].severity, Severity::kWarning) << "declared lower than it is";
}

/// A hole of 10 mm in the floor of a pocket 5 mm deep, 1 mm beside one of its walls.
TEST(Stacking, BesideAToolStandsWhatItsShankWouldMeet) {
  Part part = block();
  add(part, rectangle(10, 10, 90, 90), 0, -5);
  const Regions hole{rectangle(11, 20, 21, 30)};
  Tool tool;
  tool.diameter = 6;
  EXPECT_EQ(top_beside_tool(part, 1, hole, tool, {}), -5);
  EXPECT_EQ(top_beside_tool(part, 0, hole, tool, {}), 0) << "before the pocket";
  EXPECT_EQ(top_beside_tool(part, 1, {rectangle(10, 20, 21, 30)}, tool, {}), 0) << "under its wall";
  tool.shank_diameter = 7;
  EXPECT_EQ(top_beside_tool(part, 1, hole, tool, {}), -5);
  tool.shank_diameter = 8;
  EXPECT_EQ(top_beside_tool(part, 1, hole, tool, {}), 0) << "1.2 mm beside the hole";
}

TEST(Stacking, ThinFeaturesAreNoSliversOfThemselves) {
  Part part = block();
  part.tools = {Tool{}};
  add(part, rectangle(10, 10, 50, 50), 0, -20);
  add(part, rectangle(60, 10, 90, 10.03), 0, -12);
  add(part, rectangle(10, 60, 90, 90), 0, -5);
  add(part, rectangle(20, 70, 80, 70.03), -5, -12);
  stack_tops(part, {});
  EXPECT_EQ(part.features[1].top_z, 0);
  EXPECT_NEAR(area(Standing(part, 1, {}).above(-12)), 0.9, 1e-6);
  EXPECT_EQ(part.features[3].top_z, -5);
  EXPECT_NEAR(area(Standing(part, 3, {}).above(-12)), 1.8, 1e-6);
}

TEST(Stacking, SharedOutlinesLeaveNoSlivers) {
  Part part = block();
  add(part, rectangle(10, 10, 90, 90), 0, -5);
  add(part, rectangle(10 - 0.02, 10, 90, 90 + 0.018), 0, -12);
  stack_tops(part, {});
  EXPECT_EQ(part.features[1].top_z, -5);
}

TEST(Stacking, OrderIsTheWorkplansAndFeaturesOutsideItAreLeftAlone) {
  Part part = block();
  add(part, rectangle(20, 20, 80, 80), 0, -12);
  add(part, rectangle(10, 10, 90, 90), 0, -5);
  add(part, rectangle(30, 30, 40, 40), -7, -20);
  part.workplan = {part.workplan[1], part.workplan[0]};
  stack_tops(part, {});
  EXPECT_EQ(part.features[0].top_z, -5);
  EXPECT_EQ(part.features[1].top_z, 0);
  EXPECT_EQ(part.features[2].top_z, -7);
}

TEST(Stacking, NothingLeftToCutGivesTheFloor) {
  Part part = block();
  add(part, rectangle(10, 10, 90, 90), 0, -5);
  add(part, rectangle(20, 20, 80, 80), 0, -4);
  stack_tops(part, {});
  EXPECT_EQ(part.features[1].top_z, -4);
}

TEST(Stacking, LeaningWallsLeaveMaterialUnderThem) {
  Part part = block();
  add(part, rectangle(10, 10, 90, 90), 0, -10);
  part.features[0].wall_slope = Radians::of(0.5);
  add(part, rectangle(10, 10, 90, 90), -10, -20);
  add(part, rectangle(20, 20, 80, 80), -10, -20);
  stack_tops(part, {});
  EXPECT_EQ(part.features[1].top_z, 0) << "5.46 mm of the first one's walls stand over it";
  EXPECT_EQ(part.features[2].top_z, -20) << "inside the second";
}

// Rectangles on a grid of whole millimetres: stacking is checked cell by cell, by a height map.
TEST(Stacking, AgreesWithAHeightMapOnRandomParts) {
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    Random random(seed);
    Part part = block();
    double height[20][20] = {};
    std::vector<double> expected;
    const auto features = 1 + random.below(8);
    for (std::uint64_t k = 0; k < features; ++k) {
      const int x0 = static_cast<int>(random.below(19)), y0 = static_cast<int>(random.below(19));
      const int x1 = x0 + 1 + static_cast<int>(random.below(static_cast<std::uint64_t>(20 - x0)));
      const int y1 = y0 + 1 + static_cast<int>(random.below(static_cast<std::uint64_t>(20 - y0)));
      const double floor_z = -static_cast<double>(1 + random.below(20));
      add(part, rectangle(5 * x0, 5 * y0, 5 * x1, 5 * y1), 0, floor_z);
      double top = floor_z;
      for (int x = x0; x < x1; ++x)
        for (int y = y0; y < y1; ++y) {
          top = std::max(top, height[x][y]);
          height[x][y] = std::min(height[x][y], floor_z);
        }
      expected.push_back(top);
    }
    EXPECT_EQ(stacked_tops(part, {}), expected) << "seed " << seed;
  }
}

TEST(Names, ToolKindsAreNamedAsOnTheCommandLine) {
  for (const ToolKind kind :
       {ToolKind::kEndMill, ToolKind::kFaceMill, ToolKind::kBallEndMill, ToolKind::kBullNoseEndMill,
        ToolKind::kDrill, ToolKind::kReamer, ToolKind::kOther})
    EXPECT_EQ(tool_kind_named(name_of(kind)), kind);
  EXPECT_FALSE(tool_kind_named("spoon"));
  EXPECT_STREQ(name_of(FeatureKind::kPlanarFace), "planar_face");
}

}  // namespace
}  // namespace clearcut::features
