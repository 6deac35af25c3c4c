// Broken edges and fillets of a solid that tools at hand make by their own shape.
#include "read/step_solid/leaning_faces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

#include "geometry/contours/boolean.h"
#include "geometry/region.h"

namespace clearcut::read {
namespace {

using ::testing::HasSubstr;

const Stock kBlock{{{0, 0}, {60, 40}}, -10, 0};

Tool cone(ToolKind kind, double degrees, double diameter) {
  Tool tool;
  tool.kind = kind;
  tool.tip_angle = Radians::of(degrees * kPi / 180);
  tool.diameter = diameter;
  return tool;
}

Tool mill(ToolKind kind, double diameter, double corner) {
  Tool tool;
  tool.kind = kind;
  tool.diameter = diameter;
  tool.corner_radius = corner;
  return tool;
}

/// A through hole of 6 mm whose edge a cone of 90 degrees breaks by 1 mm.
struct ChamferedHole {
  SolidModel solid;
  std::vector<Feature> found;

  ChamferedHole() {
    solid.plan = kBlock.plan;
    solid.z_bottom = kBlock.z_bottom;
    SolidFace face;
    face.number = 1;
    face.surface = "cone";
    face.facing = Facing::kUp;
    face.z_low = -1;
    face.lean = kPi / 4;
    face.foot = {disc_about({20, 20}, 3).outer()};
    solid.faces = {face};
    Feature hole;
    hole.kind = FeatureKind::kRoundHole;
    hole.hole_diameter = 6;
    hole.target = hole.allowed = {disc_about({20, 20}, 3)};
    hole.floor_z = -10.5;
    found = {hole};
  }

  ShapedFaces with(const std::vector<Tool>& tools) const {
    return broken_edges_of({solid, {}, found, kBlock, tools}, Tolerances{});
  }
};

TEST(BrokenEdges, AWideConeSinksIntoAHoleAndANarrowOneGoesRoundIt) {
  const ChamferedHole part;
  const Tool drill = mill(ToolKind::kDrill, 6, 0);
  const ShapedFaces sunk = part.with({drill, cone(ToolKind::kSpotDrill, 90, 10)});
  ASSERT_EQ(sunk.features.size(), 1u);
  ASSERT_TRUE(sunk.features[0].hole);
  EXPECT_EQ(sunk.features[0].hole->kind, HoleKind::kCountersunk);
  EXPECT_NEAR(*sunk.features[0].hole_diameter, 8, 1e-9);
  EXPECT_EQ(sunk.faces, std::set<int>{1});
  const ShapedFaces round = part.with({drill, cone(ToolKind::kChamferMill, 90, 6)});
  ASSERT_EQ(round.features.size(), 1u);
  ASSERT_TRUE(round.features[0].chamfer);
  EXPECT_NEAR(round.features[0].chamfer->depth, 1, 1e-9);
}

/// The tip of the countersink lies 4 mm below its top.
TEST(BrokenEdges, AConeSinksOnlyIntoHolesThatAreDeepEnoughForItsTip) {
  const std::vector<Tool> tools{mill(ToolKind::kDrill, 6, 0), cone(ToolKind::kSpotDrill, 90, 10)};
  ChamferedHole part;
  for (const auto& [floor, sunk] : {std::pair(-4.5, 1U), std::pair(-3.5, 0U)}) {
    part.found[0].floor_z = floor;
    EXPECT_EQ(part.with(tools).features.size(), sunk) << floor;
  }
  SolidFace end;
  end.number = 2;
  end.surface = "cone";
  end.facing = Facing::kUp;
  end.z_low = -5.3;
  end.z_high = -3.5;
  part.solid.faces.push_back(end);
  const std::vector<Cell> cells{{1, -3.5, true, {}, part.found[0].target, {{20, 20}}}};
  const ShapedFaces pointed = broken_edges_of({part.solid, cells, part.found, kBlock, tools}, Tolerances{});
  EXPECT_EQ(pointed.features.size(), 1U) << "the drill's point is deep enough";
}

TEST(BrokenEdges, WithoutAConeOfTheirAngleTheyAreLeftAndOneIsProposed) {
  const ChamferedHole part;
  const Tool drill = mill(ToolKind::kDrill, 6, 0);
  const ShapedFaces none = part.with({drill, cone(ToolKind::kChamferMill, 60, 6)});
  EXPECT_TRUE(none.features.empty());
  ASSERT_EQ(none.proposals.size(), 1u);
  EXPECT_THAT(none.proposals[0], HasSubstr("chamfer:90deg:6"));
  EXPECT_TRUE(part.with({cone(ToolKind::kSpotDrill, 90, 10)}).features.empty()) << "nothing makes the hole";
}

TEST(BrokenEdges, AFootWithoutAWallUnderItIsNone) {
  ChamferedHole part;
  part.found[0].floor_z = -1;  // the cone stands on the pocket's floor: a drafted wall
  EXPECT_TRUE(part.with({cone(ToolKind::kChamferMill, 90, 6)}).features.empty());
}

/// A pocket of 30 x 20 mm whose walls meet the floor in fillets of 2 mm.
ShapedFaces filleted(const std::vector<Tool>& tools) {
  const Regions wall{rectangular_region({{10, 10}, {40, 30}})};
  const Regions floor{rectangular_region({{12, 12}, {38, 28}})};
  SolidModel solid;
  SolidFace face;
  face.number = 1;
  face.surface = "cylinder";
  face.facing = Facing::kUp;
  face.z_low = -5;
  face.z_high = -3;
  face.fillet = 2;
  solid.faces = {face};
  const Cell cell{0, -3, false, {}, subtract(wall, floor, Tolerances{}), {{11, 20}}};
  Feature above;
  above.target = above.allowed = wall;
  above.floor_z = -3;
  return fillets_of({solid, {cell}, {above}, kBlock, tools}, Tolerances{});
}

TEST(Fillets, AnEndAsRoundMakesThem) {
  const ShapedFaces made = filleted({mill(ToolKind::kBullNoseEndMill, 8, 2)});
  ASSERT_EQ(made.features.size(), 1u);
  EXPECT_NEAR(made.features[0].floor_z, -5, 1e-9);
  EXPECT_NEAR(made.features[0].top_z, -3, 1e-9);
  EXPECT_NEAR(made.features[0].floor_fillet, 2, 1e-9);
  EXPECT_NEAR(area(made.features[0].target), 600 - 26 * 16, 1e-6);
  EXPECT_NEAR(area(made.features[0].allowed), 600, 1e-6);
  EXPECT_EQ(filleted({mill(ToolKind::kBallEndMill, 4, 0)}).features.size(), 1u);
  const ShapedFaces none = filleted({mill(ToolKind::kBullNoseEndMill, 8, 1)});
  EXPECT_TRUE(none.features.empty());
  ASSERT_EQ(none.proposals.size(), 1u);
  EXPECT_THAT(none.proposals[0], HasSubstr("bullnose:8:corner=2"));
}

}  // namespace
}  // namespace clearcut::read
