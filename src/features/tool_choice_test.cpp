// The largest cutters of notches that are open at a side, held against formulas.
#include "features/tool_choice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "geometry/region.h"

namespace clearcut::features {
namespace {

/// A notch into the material below y = 0, `width` wide and `depth` deep, with everything above free.
Feature notch(double width, double depth) {
  const double w = width / 2, far = kOpenReach;
  const Vec2 corners[] = {{-far, 0}, {-w, 0},  {-w, -depth}, {w, -depth},
                          {w, 0},    {far, 0}, {far, far},   {-far, far}};
  Feature feature;
  feature.kind = FeatureKind::kOpenPocket;
  feature.target = {rectangular_region({{-w, -depth}, {w, 0}})};
  feature.allowed = {Region::from_valid_loops(loop_from_points(corners), {})};
  feature.floor_z = -1;
  return feature;
}

double largest_for(const Feature& feature) {
  Part part;
  part.features = {feature};
  return largest_cutters(part, {}).front();
}

TEST(Fitting, DeepNotchesTakeACutterOfTheirWidth) {
  EXPECT_NEAR(largest_for(notch(10, 60)), 10, 0.01);
  EXPECT_NEAR(largest_fitting_diameter(notch(10, 60), {}), 10, 0.01);
}

/// mm2 that a cutter of this radius leaves in both corners of a shallow notch, whose brims it touches: integrated over the height.
double left_in_corners(double radius, double depth) {
  constexpr int kSlices = 20000;
  const auto half_chord = [&](double y) { return std::sqrt(radius * radius - (radius - y) * (radius - y)); };
  double left = 0;
  for (int i = 0; i < kSlices; ++i)
    left += (half_chord(depth) - half_chord((i + 0.5) / kSlices * depth)) * depth / kSlices;
  return 2 * left;
}

TEST(Fitting, WideCuttersComeIntoShallowNotchesFromOutside) {
  const Feature shallow = notch(40, 3);
  EXPECT_LT(largest_fitting_diameter(shallow, {}), 6.01) << "over the floor itself";
  const double radius = largest_for(shallow) / 2;
  EXPECT_NEAR(left_in_corners(radius, 3) / 120, 0.1, 0.02);
}

TEST(Fitting, StripsAlongAStraightSideTakeAny) {
  Feature strip = notch(40, 0.04);
  const Vec2 corners[] = {
      {-kOpenReach, -0.04}, {kOpenReach, -0.04}, {kOpenReach, kOpenReach}, {-kOpenReach, kOpenReach}};
  strip.allowed = {Region::from_valid_loops(loop_from_points(corners), {})};
  EXPECT_GT(largest_for(strip), kOpenReach / 2);
}

/// A chamfer mill does not cut with its flat tip, which would have to go down into the material of a line.
TEST(Engraving, IsNotForTheFlatTipOfAChamferMill) {
  Feature line;
  line.kind = FeatureKind::kEngraving;
  line.profile = ProfileCut{};
  line.profile->side = ProfileSide::kOn;
  const auto tool = [](ToolKind kind, double diameter) {
    Tool one;
    one.kind = kind;
    one.diameter = diameter;
    return one;
  };
  const auto cone = [&](ToolKind kind, double tip) {
    Tool one = tool(kind, 8);
    one.tip_angle = Radians::of_degrees(90);
    one.tip_diameter = tip;
    return one;
  };
  const Tool chamfer = cone(ToolKind::kChamferMill, 0.4), sharp = cone(ToolKind::kChamferMill, 0),
             bit = cone(ToolKind::kVBit, 0.4), ball = tool(ToolKind::kBallEndMill, 2),
             mill = tool(ToolKind::kEndMill, 3), drill = tool(ToolKind::kDrill, 5);
  const auto chosen = [&](const std::vector<Tool>& tools) { return tool_for(line, tools, {}, {}); };
  EXPECT_EQ(chosen({drill, chamfer, ball}), 2);
  EXPECT_EQ(chosen({ball, chamfer, bit}), 2);
  EXPECT_EQ(chosen({chamfer, mill}), 1);
  EXPECT_EQ(chosen({mill, sharp}), 1);
  EXPECT_EQ(chosen({drill, chamfer}), 1) << "there is nothing else";
}

/// A rounded end leaves its shape at the foot of the wall.
TEST(Profiles, AreCutByFlatEndsWhereThereAreAny) {
  Feature outside;
  outside.profile = ProfileCut{};
  outside.profile->line = rectangular_region({{0, 0}, {40, 30}}).outer();
  const auto mill = [](ToolKind kind, double diameter, double corner) {
    Tool one;
    one.kind = kind;
    one.diameter = diameter;
    one.corner_radius = corner;
    return one;
  };
  const Tool ball = mill(ToolKind::kBallEndMill, 6, 0), bull = mill(ToolKind::kBullNoseEndMill, 8, 1),
             flat = mill(ToolKind::kEndMill, 6, 0);
  const auto chosen = [&](const std::vector<Tool>& tools) { return tool_for(outside, tools, {}, {}); };
  EXPECT_EQ(chosen({ball, flat}), 1);
  EXPECT_EQ(chosen({flat, bull}), 0);
  EXPECT_EQ(chosen({ball, bull}), 1) << "there is nothing else";
}

}  // namespace
}  // namespace clearcut::features
