// Features of ISO 14649: faces, open pockets, slots, steps, holes, tapered holes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "read/stepnc/test_program.h"

namespace clearcut::read::stepnc {
namespace {

using testing::all_diagnostics;
using testing::count_of;
using testing::expect_box;
using ::testing::HasSubstr;
using testing::Program;
using testing::step;

/// A region of 20 x 10 mm about 50, 40 on the block, 4 mm deep; its curve is drawn 7 mm over the block.
Program region(const std::string& depth = "#70") {
  return Program()
      .feature("REGION_PROJECTION('REGION',#3,(#30),#21,#64,#66," + depth + ")")
      .with(22, "CARTESIAN_POINT('',(50.,40.,7.))")
      .with(64, "POLYLINE('',(#65,#67,#68,#69,#65))")
      .with(65, "CARTESIAN_POINT('',(-10.,-5.,0.))")
      .with(66, "DIRECTION('',(0.,0.,-1.))")
      .with(67, "CARTESIAN_POINT('',(10.,-5.,0.))")
      .with(68, "CARTESIAN_POINT('',(10.,5.,0.))")
      .with(69, "CARTESIAN_POINT('',(-10.,5.,0.))")
      .with(70, "TOLERANCED_LENGTH_MEASURE(4.,$)");
}

TEST(StepNcRegion, LiesAsDeepAsItSaysBelowTheRawPiecesTop) {
  const Part part = region().read();
  ASSERT_EQ(part.features.size(), 1U);
  EXPECT_EQ(part.features[0].top_z, 0);
  EXPECT_EQ(part.features[0].floor_z, -4);
  EXPECT_NEAR(area(part.features[0].target), 200, 1e-9);
  EXPECT_NEAR(area(part.features[0].allowed), 200, 1e-9) << "walls all round";
  EXPECT_THAT(all_diagnostics(part), Not(HasSubstr("proj_")));
}

TEST(StepNcRegion, IsOpenWhereItsCurveLeavesTheStock) {
  const Part part = region().with(22, "CARTESIAN_POINT('',(0.,40.,0.))").read();
  EXPECT_NEAR(area(part.features[0].target), 100, 1e-9);
  EXPECT_GT(area(part.features[0].allowed), 1e5) << "and the air beside the block";
}

TEST(StepNcRegion, IsMilledByFreeFormMillingAndNothingElseIs) {
  const char* const freeform = "FREEFORM_OPERATION($,$,'OP',8.,$,#31,#34,#35,$,#36,$,$)";
  EXPECT_EQ(region().with(30, freeform).read().features[0].floor_z, -4);
  EXPECT_THAT(Program().with(30, freeform).error(), HasSubstr("that of a level REGION_PROJECTION alone"));
}

TEST(StepNcRegion, WhatIsNotLevelIsRefusedByName) {
  EXPECT_THAT(region().with(66, "DIRECTION('',(1.,0.,-1.))").error(), HasSubstr("projected at a slant"));
  EXPECT_THAT(region("$").error(), HasSubstr("depth"));
  EXPECT_THAT(region().with(70, "TOLERANCED_LENGTH_MEASURE(0.,$)").error(), HasSubstr("above zero"));
  EXPECT_THAT(region().with(3, "WORKPIECE('WP',$,$,$,$,$,())").error(), HasSubstr("as its raw piece"));
}

TEST(StepNc, FaceWithoutBoundaryIsTheWholeStockAndOpenAllRound) {
  Program p;
  p.feature("PLANAR_FACE('FACE',#3,(#30),#21,#23,$,$,$,(#70))");
  p.with(70, "BOSS('B1',#3,(),#72,#23,#73,$)").with(72, "AXIS2_PLACEMENT_3D('',#74,$,$)");
  p.with(74, "CARTESIAN_POINT('',(35.,40.,0.))").with(73, "CIRCULAR_CLOSED_PROFILE($,#75)");
  p.with(75, "TOLERANCED_LENGTH_MEASURE(8.,$)");
  const Feature f = p.read().features[0];
  expect_box(f.target, 0, 100, 0, 80);
  expect_box(f.allowed, -kOpenReach, 100 + kOpenReach, -kOpenReach, 80 + kOpenReach);
  EXPECT_EQ(f.target[0].islands().size(), 1U);
  EXPECT_FALSE(contains(f.allowed, {35, 40}));
}

TEST(StepNc, FaceByCourseOfTravelAndRemovalBoundary) {
  Program p;
  p.feature("PLANAR_FACE('FACE',#3,(#30),#21,#23,#70,#71,$,())").with(70, "LINEAR_PATH($,#72,#73)");
  p.with(71, "LINEAR_PROFILE($,#74)").with(72, "TOLERANCED_LENGTH_MEASURE(80.,$)");
  p.with(73, "DIRECTION('',(0.,1.,0.))").with(74, "NUMERIC_PARAMETER('L',40.,'MM')");
  const Feature f = p.read().features[0];
  expect_box(f.target, 0, 40, 0, 80);
  EXPECT_TRUE(contains(f.allowed, {-50, 40})) << "open to the left";
  EXPECT_TRUE(contains(f.allowed, {20, 100})) << "open behind";
  EXPECT_FALSE(contains(f.allowed, {45, 40})) << "a wall at x 40";
  EXPECT_TRUE(contains(f.allowed, {150, 40})) << "beyond the stock is air";
}

TEST(StepNc, FaceInsideTheStockHasWallsAllRound) {
  Program p;
  p.feature("PLANAR_FACE('FACE',#3,(#30),#21,#23,$,$,#27,())");
  const Part part = p.read();
  expect_box(part.features[0].allowed, 20, 80, 30, 50);
  EXPECT_THAT(all_diagnostics(part), HasSubstr("does not reach the edge of the stock"));
}

TEST(StepNc, OpenPocketIsClosedRoundTheStock) {
  // Walls from the lower edge up, across, and down again: 30 x 25 mm, open below; the material is on their
  // left.
  Program p;
  p.feature("OPEN_POCKET('OPEN',#3,(#30),#21,#23,(),$,#26,$,$,#70,$)").with(70, "GENERAL_PROFILE($,#71)");
  p.with(71, "POLYLINE('',(#72,#73,#74,#75))");
  p.with(72, "CARTESIAN_POINT('',(30.,0.,0.))").with(73, "CARTESIAN_POINT('',(30.,25.,0.))");
  p.with(74, "CARTESIAN_POINT('',(60.,25.,0.))").with(75, "CARTESIAN_POINT('',(60.,0.,0.))");
  const Feature f = p.read().features[0];
  EXPECT_EQ(f.kind, FeatureKind::kOpenPocket);
  expect_box(f.target, 30, 60, 0, 25);
  EXPECT_NEAR(area(f.target), 750, 1e-3);
  EXPECT_TRUE(contains(f.allowed, {45, -20}));
  EXPECT_TRUE(contains(f.allowed, {-20, 40}));
  EXPECT_FALSE(contains(f.allowed, {20, 10}));
}

TEST(StepNc, OpenPocketAcrossACorner) {
  Program p;
  p.feature("OPEN_POCKET('OPEN',#3,(#30),#21,#23,(),$,#26,$,$,#70,$)").with(70, "GENERAL_PROFILE($,#71)");
  p.with(71, "POLYLINE('',(#72,#73,#74))");
  p.with(72, "CARTESIAN_POINT('',(70.,0.,0.))").with(73, "CARTESIAN_POINT('',(70.,50.,0.))");
  p.with(74, "CARTESIAN_POINT('',(100.,50.,0.))");
  const Feature f = p.read().features[0];
  expect_box(f.target, 70, 100, 0, 50);
  EXPECT_NEAR(area(f.target), 1500, 1e-3);
}

TEST(StepNc, OpenSidesThatMissTheEdgeByTheToleranceReachIt) {
  Program p;
  p.feature("OPEN_POCKET('OPEN',#3,(#30),#21,#23,(),$,#26,$,$,#70,$)").with(70, "GENERAL_PROFILE($,#71)");
  p.with(71, "POLYLINE('',(#72,#73,#74,#75))");
  p.with(72, "CARTESIAN_POINT('',(30.,0.006,0.))").with(73, "CARTESIAN_POINT('',(30.,25.,0.))");
  p.with(74, "CARTESIAN_POINT('',(60.,25.,0.))").with(75, "CARTESIAN_POINT('',(60.,0.,0.))");
  const Feature f = p.read().features[0];
  EXPECT_NEAR(area(f.target), 750, 1e-3);
  EXPECT_EQ(f.allowed.size(), 1U);
}

Program slot(const std::string& profile, const std::string& ends) {
  Program p;
  p.feature("SLOT('SLOT',#3,(#30),#21,#23,#70,#71," + ends + ")").with(22, "CARTESIAN_POINT('',(0.,40.,0.))");
  p.with(70, "LINEAR_PATH($,#72,#73)").with(71, profile).with(72, "TOLERANCED_LENGTH_MEASURE(100.,$)");
  p.with(73, "DIRECTION('',(1.,0.,0.))").with(74, "TOLERANCED_LENGTH_MEASURE(12.,$)");
  p.with(75, "OPEN_SLOT_END_TYPE()")
      .with(76, "RADIUSED_SLOT_END_TYPE()")
      .with(77, "WOODRUFF_SLOT_END_TYPE(#74)");
  return p.with(9, "WORKPIECE_SETUP(#3,$,$,$,())");
}

TEST(StepNc, PathsThatLeanAreReadLevelAndSaid) {
  Program p = slot("SQUARE_U_PROFILE($,#74,$,$,$,$)", "(#75,#75)");
  p.with(81, "CARTESIAN_POINT('',(0.,0.,0.))").with(70, "LINEAR_PATH(#80,#72,#73)");
  const auto said = [&](const std::string& axis) {
    p.with(82, axis).with(80, "AXIS2_PLACEMENT_3D('',#81,#82,$)");
    return all_diagnostics(p.read());
  };
  EXPECT_THAT(said("DIRECTION('',(0.,0.,1.))"), ::testing::Not(HasSubstr("not level")));
  EXPECT_THAT(said("DIRECTION('',(0.75,0.,1.))"), HasSubstr("#70 LINEAR_PATH: its placement is not level"));
  p.with(70, "LINEAR_PATH($,#72,#73)").with(73, "DIRECTION('',(1.,0.,0.75))");
  const Part leaning = p.read();
  EXPECT_THAT(all_diagnostics(leaning), HasSubstr("#70 LINEAR_PATH: its direction leaves the plane"));
}

TEST(StepNc, SlotOpenAtBothEnds) {
  const Feature f = slot("SQUARE_U_PROFILE($,#74,$,$,$,$)", "(#75,#75)").read().features[0];
  EXPECT_EQ(f.kind, FeatureKind::kSlot);
  expect_box(f.target, 0, 100, 34, 46);
  EXPECT_TRUE(contains(f.allowed, {-30, 40}));
  EXPECT_TRUE(contains(f.allowed, {130, 40}));
  EXPECT_FALSE(contains(f.allowed, {50, 30}));
}

TEST(StepNc, SlotWithARoundEndInsideTheStock) {
  Program p = slot("SQUARE_U_PROFILE($,#74,$,$,$,$)", "(#75,#76)");
  const Feature f = p.with(72, "TOLERANCED_LENGTH_MEASURE(60.,$)").read().features[0];
  expect_box(f.target, 0, 66, 34, 46);
  EXPECT_NEAR(area(f.target), 720 + kPi * 18, 1e-3);
}

TEST(StepNc, SlotsWithWallsAtBothEndsNeedNoStock) {
  Program program;
  program.with(3, "WORKPIECE('WP',$,$,$,$,$,())")
      .feature("SLOT('SLOT',#3,(#30),#21,#23,#40,#41,(#42,#42))")
      .with(40, "LINEAR_PATH(#28,#63,#43)")
      .with(41, "SQUARE_U_PROFILE($,#62,$,$,$,$)")
      .with(42, "RADIUSED_SLOT_END_TYPE()")
      .with(43, "DIRECTION('',(1.,0.,0.))");
  const Part part = program.read();
  expect_box(part.features[0].target, 40, 120, 30, 50);
  EXPECT_NEAR(area(part.features[0].allowed), area(part.features[0].target), 1e-12);
  EXPECT_THAT(program.with(42, "OPEN_SLOT_END_TYPE()").error(), HasSubstr("give the WORKPIECE a BLOCK"));
}

TEST(StepNc, SlotAlongAnArc) {
  Program p = slot("SQUARE_U_PROFILE($,#74,$,$,$,$)", "(#76,#76)");
  p.with(70, "PARTIAL_CIRCULAR_PATH(#78,#79,1.5707963267948966)")
      .with(79, "TOLERANCED_LENGTH_MEASURE(20.,$)");
  p.with(78, "AXIS2_PLACEMENT_3D('',#80,$,$)").with(80, "CARTESIAN_POINT('',(40.,-10.,0.))");
  const Feature f = p.read().features[0];
  EXPECT_NEAR(area(f.target), kPi / 4 * (26 * 26 - 14 * 14) + kPi * 36, 1e-3);
}

TEST(StepNc, RoundedSlotIsCutWhereItsSidesAreUpright) {
  const Part part =
      slot("ROUNDED_U_PROFILE($,#74)", "(#75,#75)").with(25, "CARTESIAN_POINT('',(0.,0.,-9.))").read();
  EXPECT_EQ(part.features[0].floor_z, -3) << "6 mm of the 9 are the half round";
  EXPECT_EQ(count_of(part, Severity::kSkipped), 1);
}

TEST(StepNc, SlotsWithoutAFlatFloorAreRefusedByName) {
  EXPECT_THAT(slot("VEE_PROFILE($,#74,1.,0.5)", "(#75,#75)").error(),
              HasSubstr("VEE_PROFILE: its sides do not lean alike"));
  EXPECT_THAT(slot("TEE_PROFILE($,0.,0.,#74,#74,$,#74,$,$)", "(#75,#75)").error(), HasSubstr("TEE_PROFILE"));
  EXPECT_THAT(slot("SQUARE_U_PROFILE($,#74,$,$,$,$)", "(#75,#77)").error(),
              HasSubstr("WOODRUFF_SLOT_END_TYPE: this end of a slot rises in an arc"));
}

TEST(StepNc, StepTakesTheSideAwayFromTheMaterial) {
  const Part part = step(85, "0.,1.,0.").read();
  expect_box(part.features[0].target, 85, 100, 0, 80);
  EXPECT_EQ(count_of(part, Severity::kWarning), 0);
  EXPECT_FALSE(contains(part.features[0].allowed, {84, 40}));
  EXPECT_TRUE(contains(part.features[0].allowed, {120, 40}));
}

TEST(StepNc, StepDrawnTheOtherWayRoundTakesTheSmallerSideAndSaysSo) {
  const Part part = step(15, "0.,1.,0.").read();
  expect_box(part.features[0].target, 0, 15, 0, 80);
  EXPECT_THAT(all_diagnostics(part), HasSubstr("the other side is taken"));
}

TEST(StepNc, RoundHoleBlindAndThrough) {
  Program p;
  p.feature("ROUND_HOLE('HOLE',#3,(#30),#28,#23,#62,$,#70)").with(70, "THROUGH_BOTTOM_CONDITION()");
  p.with(25, "CARTESIAN_POINT('',(0.,0.,-21.))")
      .with(30, "DRILLING($,$,'DRILL',$,$,#31,#34,#35,$,$,$,$,$,$)");
  p.with(32, "TWIST_DRILL(#33,2,$,$,$)");
  const Part part = p.read();
  EXPECT_EQ(part.features[0].kind, FeatureKind::kRoundHole);
  EXPECT_TRUE(part.features[0].through);
  EXPECT_EQ(part.features[0].hole_diameter, 20);
  EXPECT_EQ(part.features[0].floor_z, -21) << "a through hole may end below the stock";
  EXPECT_EQ(part.workplan[0].operation.kind, OperationKind::kDrilling);
  EXPECT_NEAR(area(part.features[0].target), 100 * kPi, 1e-9);
}

/// Down to the underside of the stock it is as wide as it should be: the point of the drill goes below.
TEST(StepNc, ThroughHolesAreDrilledTheirWholeWidthDown) {
  Program p;
  p.feature("ROUND_HOLE('HOLE',#3,(#30),#28,#23,#63,$,#70)").with(70, "THROUGH_BOTTOM_CONDITION()");
  p.with(63, "TOLERANCED_LENGTH_MEASURE(10.,$)").with(25, "CARTESIAN_POINT('',(0.,0.,-20.))");
  p.with(30, "DRILLING($,$,'DRILL',$,$,#31,#34,#35,$,$,$,$,$,$)").with(32, "TWIST_DRILL(#33,2,$,$,$)");
  p.with(33, "MILLING_TOOL_DIMENSION(10.,1.5707963267948966,$,40.,$,$,$)");
  EXPECT_NEAR(p.read().features[0].floor_z, -25, 1e-6) << "5 mm of the point of 90 degrees";
  p.with(25, "CARTESIAN_POINT('',(0.,0.,-27.))");
  EXPECT_EQ(p.read().features[0].floor_z, -27) << "deep enough as it is";
  p.with(25, "CARTESIAN_POINT('',(0.,0.,-20.))")
      .with(33, "MILLING_TOOL_DIMENSION(10.,1.5707963267948966,$,22.,$,$,$)");
  EXPECT_EQ(p.read().features[0].floor_z, -22) << "its flutes are no longer";
  EXPECT_THAT(all_diagnostics(p.read()), HasSubstr("its width down to 3 mm over the underside"));
  p.with(25, "CARTESIAN_POINT('',(0.,0.,-20.))")
      .with(30, "DRILLING($,$,'DRILL',$,$,#31,#34,#35,$,20.,$,$,$,$)");
  EXPECT_EQ(p.read().features[0].floor_z, -20) << "a stated cutting depth has precedence";
}

TEST(StepNc, TaperedHolesAreRoundPocketsWithLeaningWalls) {
  Program program;
  program.feature("ROUND_HOLE('HOLE',#3,(),#28,#23,#62,#40,#41)").with(41, "FLAT_HOLE_BOTTOM()");
  const Part part =
      program.with(40, "DIAMETER_TAPER(#42)").with(42, "TOLERANCED_LENGTH_MEASURE(18.,$)").read();
  EXPECT_EQ(part.features[0].kind, FeatureKind::kClosedPocket);
  EXPECT_NEAR(std::tan(part.features[0].wall_slope.radians()), 0.2, 1e-12);
  expect_box(part.features[0].target, 40, 60, 30, 50);
  const Part by_angle = program.with(40, "ANGLE_TAPER(0.19739555984988)").read();
  EXPECT_NEAR(std::tan(by_angle.features[0].wall_slope.radians()), 0.2, 1e-9);
  EXPECT_THAT(program.with(40, "DIAMETER_TAPER(#42)").with(42, "TOLERANCED_LENGTH_MEASURE(22.,$)").error(),
              HasSubstr("widens downwards"));
  EXPECT_THAT(program.with(40, "ANGLE_TAPER(1.2)").error(), HasSubstr("comes to a point"));
  EXPECT_THAT(program.with(40, "ANGLE_TAPER(0.1)")
                  .with(30, "DRILLING($,$,'DRILL',$,$,#31,#34,#35,$,$,$,$,$,$)")
                  .error(),
              HasSubstr("milled, not drilled"));
}

}  // namespace
}  // namespace clearcut::read::stepnc
