#include "features/round_hole.h"

#include <gtest/gtest.h>

namespace clearcut::features {
namespace {

/// A round pocket of 12 mm, first cut by a tool of `diameter` that leaves `stock` on the wall, then by one of 3 mm.
Part pocket_cut_by(ToolKind kind, double diameter, double stock) {
  Part part;
  part.tools.resize(2);
  part.tools[0].kind = kind;
  part.tools[0].diameter = diameter;
  part.tools[1].diameter = 3;
  const Vec2 right{6, 0}, left{-6, 0};
  const Loop circle{Edge::arc(right, left, {0, 0}, Turn::kCounterClockwise),
                    Edge::arc(left, right, {0, 0}, Turn::kCounterClockwise)};
  Feature feature;
  feature.floor_z = -3;
  feature.target = feature.allowed = {Region::from_valid_loops(circle, {})};
  part.features.push_back(feature);
  part.workplan.resize(2);
  part.workplan[0].operation.tool = 0;
  part.workplan[0].operation.allowance_side = stock;
  part.workplan[1].operation.tool = 1;
  return part;
}

double hole_before_second(const Part& part) {
  const auto holes = holes_before(part, 1, Tolerances{});
  return holes.empty() ? 0 : holes.front().diameter;
}

TEST(HolesBefore, AreAsWideAsWhatWasCut) {
  EXPECT_EQ(hole_before_second(pocket_cut_by(ToolKind::kEndMill, 8, 0)), 12);
  EXPECT_EQ(hole_before_second(pocket_cut_by(ToolKind::kEndMill, 8, 0.5)), 11);
  EXPECT_EQ(hole_before_second(pocket_cut_by(ToolKind::kReamer, 10, 0)), 10);
  EXPECT_EQ(hole_before_second(pocket_cut_by(ToolKind::kEndMill, 12, 0)), 12);
}

TEST(HolesBefore, OfBullNosesAreNarrowerWhereTheyRoundOff) {
  Part part = pocket_cut_by(ToolKind::kBullNoseEndMill, 8, 0);
  part.tools[0].corner_radius = 1;
  EXPECT_EQ(hole_before_second(part), 10);
  part.tools[0].corner_radius = 4;
  part.tools[0].kind = ToolKind::kBallEndMill;
  EXPECT_EQ(hole_before_second(part), 0);
}

TEST(HolesBefore, OfDrillsEndWhereTheirPointBegins) {
  Part part = pocket_cut_by(ToolKind::kDrill, 10, 0);
  EXPECT_EQ(hole_before_second(part), 0) << "its cone stands over the floor of the second step";
  part.features.push_back(part.features.front());
  part.workplan[1].feature = 1;
  part.features[0].floor_z -= point_length(part.tools[0]) + 1e-9;
  EXPECT_EQ(hole_before_second(part), 10);
}

/// What just fits into the hole does not fit within the stock that it has to leave: the next tool finds it solid.
TEST(HolesBefore, AreNoneWhereTheToolFoundNoRoom) {
  EXPECT_EQ(hole_before_second(pocket_cut_by(ToolKind::kEndMill, 12, 0.3)), 0);
  EXPECT_EQ(hole_before_second(pocket_cut_by(ToolKind::kEndMill, 11.5, 0.3)), 0);
  EXPECT_EQ(hole_before_second(pocket_cut_by(ToolKind::kDrill, 12.5, 0)), 0);
}

}  // namespace
}  // namespace clearcut::features
