#include "report/picture/job_view.h"

#include <gtest/gtest.h>

#include "report/picture/plan_lines.h"
#include "report/sample_job.h"

namespace clearcut::report {
namespace {

class ReachOfSample : public testing::Test {
 protected:
  Reach reach(int feature) const { return reach_of(Job{part, toolpath, findings}, feature); }
  Part part = sample::part();
  Toolpath toolpath = sample::toolpath();
  Findings findings;
};

TEST_F(ReachOfSample, CentresKeepTheRadiusFromWallsAndIslands) {
  const Reach r = reach(0);
  EXPECT_EQ(r.diameter, 10);
  EXPECT_NEAR(area(r.centers), 50 * 40 - kPi * 13 * 13, 0.01);
}

TEST_F(ReachOfSample, StockToLeaveIsOutOfReach) {
  part.workplan[0].operation.allowance_side = 1;
  EXPECT_NEAR(area(reach(0).centers), 48 * 38 - kPi * 14 * 14, 0.01);
}

TEST_F(ReachOfSample, TheSmallestCutterThatWorkedCounts) {
  part.tools.push_back(Tool{2, "T2", ToolKind::kEndMill, 6, 0, 2, {}, true});
  EXPECT_EQ(reach(1).diameter, 10);
  toolpath.sections.push_back(toolpath.sections[1]);
  toolpath.sections.back().tool_number = 2;
  EXPECT_EQ(reach(1).diameter, 6);
}

TEST_F(ReachOfSample, WithoutMovesTheCutterThatWasMeantCounts) {
  toolpath.sections.clear();
  EXPECT_EQ(reach(0).diameter, 10);
  part.workplan.clear();
  EXPECT_EQ(reach(0).diameter, 0);
}

TEST_F(ReachOfSample, CutAreasAreAsWideAsTheCutterIsAtTheirHeight) {
  const Job job{part, toolpath, findings};
  const Box everywhere{{-1000, -1000}, {1000, 1000}};
  const auto widest = [&](double z, std::optional<double> height) {
    double most = 0;
    for (const Sweep& sweep : sweeps_at(job, z, everywhere, 0, height)) most = std::max(most, sweep.diameter);
    return most;
  };
  const double floor = part.features[0].floor_z;
  EXPECT_NEAR(widest(floor, {}), 10, 1e-9);
  EXPECT_NEAR(reach(0).flat, 10, 1e-9);
  part.tools[0].corner_radius = 2;
  EXPECT_NEAR(widest(floor, {}), 6, 1e-9);
  EXPECT_NEAR(widest(floor, floor + 2), 10, 1e-9);
  EXPECT_NEAR(reach(0).flat, 6, 1e-9);
  part.tools[0].kind = ToolKind::kBallEndMill;
  EXPECT_EQ(widest(floor, {}), 0);
  EXPECT_NEAR(widest(floor, floor + 1), 6, 1e-9);
  part.tools[0].kind = ToolKind::kVBit;
  part.tools[0].tip_angle = Radians::of_degrees(90);
  EXPECT_NEAR(widest(floor, floor + 1.5), 3, 1e-9);
}

TEST_F(ReachOfSample, ACutterThatJustFitsHasALine) {
  part.features[1].target =
      part.features[1].allowed = {Region::from_valid_loops(sample::rectangle(80, 10, 110, 20), {})};
  const Reach r = reach(1);
  EXPECT_LT(area(r.centers), 1e-3);
  double fits = 0;
  for (const Path& line : r.fit_lines) fits += length(line);
  EXPECT_NEAR(fits, 20, 0.01);
}

TEST_F(ReachOfSample, ADrillFitsItsHoleInOnePoint) {
  part.features[1].target =
      part.features[1].allowed = {Region::from_valid_loops(sample::circle({90, 40}, 5), {})};
  const Reach r = reach(1);
  EXPECT_LT(area(r.centers), 1e-3);
  ASSERT_FALSE(r.fit_points.empty());
  for (const Vec2 point : r.fit_points) EXPECT_LT(distance(point, {90, 40}), 0.01);
}

TEST_F(ReachOfSample, LeaningWallsMakeTheFloorSmaller) {
  Feature& slot = part.features[1];  // 30 x 12, 8 deep
  slot.wall_slope = Radians::of(std::atan(0.25));
  EXPECT_NEAR(area(floor_target(slot)), 26 * 8, 0.01);
  EXPECT_EQ(area(floor_target(part.features[0])), area(part.features[0].target));
}

TEST(JobView, SectionsFindTheirFeature) {
  const Part part = sample::part();
  Section section;
  EXPECT_EQ(feature_of(part, section), -1);
  section.label = "SLOT <2>";
  EXPECT_EQ(feature_of(part, section), 1);
  section.workingstep = 0;
  EXPECT_EQ(feature_of(part, section), 0);
  section.workingstep = 7;
  EXPECT_EQ(feature_of(part, section), 1) << "a workingstep that is none gives way to the label";
}

TEST(JobView, TheLastLayerHasItsEntryAndItsRapidsButNoOtherLayer) {
  const Section section = sample::slot_section();
  EXPECT_EQ(last_layer(section), -8);
  const auto shown = shown_moves(section, false);
  ASSERT_EQ(shown.size(), 7u) << "two ramps, four cuts, the retract";
  EXPECT_EQ(shown[0].kind, MoveKind::kRamp);
  EXPECT_EQ(shown[1].kind, MoveKind::kRamp);
  for (const Move& move : shown_moves(sample::pocket_section(), false)) {
    EXPECT_FALSE(move.kind == MoveKind::kCut && move.z_to > -4);
  }
  EXPECT_EQ(shown_moves(section, true).size(), section.moves.size());
}

TEST(JobView, DrillingHasALastLayerToo) {
  sample::Moves m({5, 5}, 2);
  m.to(MoveKind::kPlunge, {5, 5}, -3).to(MoveKind::kRapid, {5, 5}, 2).to(MoveKind::kPlunge, {5, 5}, -9);
  Section section;
  section.moves = m.moves;
  EXPECT_EQ(last_layer(section), -9);
}

TEST(JobView, ShadesGrowWithDepthAndTellNearFloorsApart) {
  Part part = sample::part();
  part.features[0].floor_z = -20;
  part.features[1].floor_z = -20.5;
  EXPECT_EQ(depth_fraction(part, 0), 0);
  EXPECT_EQ(depth_fraction(part, -20.5), 1);
  EXPECT_LT(depth_fraction(part, -20), 0.8);
  double last = -1;
  for (double z = 1; z > -25; z -= 0.25) {
    EXPECT_GE(depth_fraction(part, z), last) << z;
    last = depth_fraction(part, z);
  }
}

/// Cuts of an earlier set-up, turned over, are hollows: they count for what begins at their ceiling or under it.
TEST_F(ReachOfSample, WhatWasCutBeforeIsSwept) {
  Toolpath earlier = toolpath, none;
  Job job{part, none, findings};
  const Box everywhere{{-1000, -1000}, {1000, 1000}};
  const double deep = part.stock ? part.stock->z_top : 0;
  EXPECT_TRUE(earlier_sweeps_at(job, deep, everywhere, -5).empty());
  job.earlier = &earlier;
  EXPECT_FALSE(earlier_sweeps_at(job, deep, everywhere, -5).empty());
  for (Section& section : earlier.sections) section.carried_below = -5;
  EXPECT_FALSE(earlier_sweeps_at(job, deep, everywhere, -5).empty());
  EXPECT_TRUE(earlier_sweeps_at(job, deep, everywhere, -4).empty());
}

}  // namespace
}  // namespace clearcut::report
