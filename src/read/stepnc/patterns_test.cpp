// Patterns and compounds of ISO 14649.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "read/stepnc/test_program.h"

namespace clearcut::read::stepnc {
namespace {

using testing::all_diagnostics;
using testing::expect_box;
using ::testing::HasSubstr;
using testing::Program;

/// A blind 6 mm hole (#40) at (30, 40, 0), drilled; feature #20 is what the case says.
Program with_hole() {
  return Program()
      .with(40, "ROUND_HOLE('HOLE',#3,(),#41,#23,#43,$,#44)")
      .with(41, "AXIS2_PLACEMENT_3D('',#42,$,$)")
      .with(42, "CARTESIAN_POINT('',(30.,40.,0.))")
      .with(43, "TOLERANCED_LENGTH_MEASURE(6.,$)")
      .with(44, "FLAT_HOLE_BOTTOM()")
      .with(30, "DRILLING($,$,'DRILL',8.,$,#31,#34,#35,$,$,$,$,$,$)")
      .with(32, "TWIST_DRILL(#33,2,$,$,$)")
      .with(33, "MILLING_TOOL_DIMENSION(6.,$,$,25.,$,$,$)")
      .with(50, "AXIS2_PLACEMENT_3D('',#51,$,$)")
      .with(51, "CARTESIAN_POINT('',(50.,40.,0.))");
}

std::vector<Vec2> centres(const Part& part) {
  std::vector<Vec2> result;
  for (const Feature& feature : part.features) result.push_back(box(feature.target).center());
  return result;
}

void expect_centres(const Part& part, const std::vector<Vec2>& expected) {
  const std::vector<Vec2> got = centres(part);
  ASSERT_EQ(got.size(), expected.size());
  for (std::size_t i = 0; i < got.size(); ++i) EXPECT_LT(distance(got[i], expected[i]), 1e-9) << i;
}

TEST(StepNcPattern, CircularInDegrees) {
  const Part part = with_hole().feature("CIRCULAR_PATTERN('RING',#3,(),#50,#40,90.,4,(),(),$,0.)").read();
  expect_centres(part, {{30, 40}, {50, 20}, {70, 40}, {50, 60}});
  ASSERT_EQ(part.workplan.size(), 4U);
  EXPECT_EQ(part.features[3].name, "HOLE (4)");
  EXPECT_EQ(part.features[3].hole_diameter, 6);
  EXPECT_EQ(part.features[3].floor_z, -5);
  EXPECT_EQ(part.workplan[3].operation.kind, OperationKind::kDrilling);
  EXPECT_EQ(part.workplan[3].operation.retract_z, 8);
}

TEST(StepNcPattern, CircularInRadians) {
  expect_centres(
      with_hole().feature("CIRCULAR_PATTERN('',#3,(),#50,#40,1.5707963267948966,3,$,$,$,$)").read(),
      {{30, 40}, {50, 20}, {70, 40}});
}

/// Four increments of a quarter: the fifth member is the first once more.
TEST(StepNcPattern, RadiansThatCloseOneTurnAreNoDegrees) {
  for (const char* quarter : {"1.5707963267948966", "1.5708", "-1.57079"}) {
    const Part part =
        with_hole()
            .feature("CIRCULAR_PATTERN('',#3,(),#50,#40," + std::string(quarter) + ",5,$,$,$,$)")
            .read();
    ASSERT_EQ(centres(part).size(), 4U) << quarter;
    EXPECT_LT(distance(centres(part)[2], {70, 40}), 1e-3) << quarter;
    EXPECT_THAT(all_diagnostics(part), HasSubstr("lies on its first"));
  }
}

/// Four members by 3 would be more than once round in radians.
TEST(StepNcPattern, SmallAnglesAreDegreesWhereRadiansWouldGoRoundTwice) {
  const Part part = with_hole().feature("CIRCULAR_PATTERN('',#3,(),#50,#40,3.,4,(),(),$,0.)").read();
  EXPECT_NEAR(centres(part)[1].y, 40 - 20 * std::sin(kPi / 60), 1e-9);
  EXPECT_THAT(all_diagnostics(part), HasSubstr("read in degrees"));
}

TEST(StepNcPattern, CircularWithMissingAndRelocatedMembers) {
  const Part part = with_hole()
                        .feature("CIRCULAR_PATTERN('RING',#3,(),#50,#40,90.,4,(#52),(#53),40.,0.)")
                        .with(52, "CIRCULAR_OFFSET(-90.,4)")
                        .with(53, "CIRCULAR_OMIT(3)")
                        .read();
  expect_centres(part, {{30, 40}, {50, 20}, {70, 40}});
  EXPECT_THAT(with_hole()
                  .feature("CIRCULAR_PATTERN('RING',#3,(),#50,#40,90.,4,(),(#53),40.,0.)")
                  .with(53, "CIRCULAR_OMIT(5)")
                  .error(),
              HasSubstr("#53 CIRCULAR_OMIT: its index is outside the pattern"));
}

TEST(StepNcPattern, PlacesCountFromZeroWhereOneIsZero) {
  const Part part = with_hole()
                        .feature("CIRCULAR_PATTERN('RING',#3,(),#50,#40,90.,4,(),(#52,#53),40.,0.)")
                        .with(52, "CIRCULAR_OMIT(0)")
                        .with(53, "CIRCULAR_OMIT(3)")
                        .read();
  expect_centres(part, {{50, 20}, {70, 40}});
  EXPECT_THAT(all_diagnostics(part), HasSubstr("counted from 0"));
}

/// Writers that place the base in the pattern's frame, or at its centre.
TEST(StepNcPattern, CircularBaseInOtherPlaces) {
  const std::string ring = "CIRCULAR_PATTERN('RING',#3,(),#50,#40,180.,2,(),(),40.,0.)";
  const Part inside = with_hole().with(42, "CARTESIAN_POINT('',(20.,0.,0.))").feature(ring).read();
  expect_centres(inside, {{70, 40}, {30, 40}});
  EXPECT_THAT(all_diagnostics(inside), HasSubstr("only when it is placed in the pattern"));
  const Part middle = with_hole().with(42, "CARTESIAN_POINT('',(50.,40.,0.))").feature(ring).read();
  expect_centres(middle, {{70, 40}, {30, 40}});
  EXPECT_THAT(all_diagnostics(middle), HasSubstr("placed at its centre"));
  EXPECT_THAT(with_hole()
                  .with(42, "CARTESIAN_POINT('',(50.,40.,0.))")
                  .feature("CIRCULAR_PATTERN('RING',#3,(),#50,#40,180.,2,(),(),$,0.)")
                  .error(),
              HasSubstr("lies on its axis"));
}

TEST(StepNcPattern, PocketsTurnByTheRotationOfTheBase) {
  Program program;
  program.with(40, "CLOSED_POCKET('P',#3,(),#41,#23,(),$,#26,$,$,#45)")
      .with(41, "AXIS2_PLACEMENT_3D('',#42,$,$)")
      .with(42, "CARTESIAN_POINT('',(20.,40.,0.))")
      .with(45, "RECTANGULAR_CLOSED_PROFILE($,#62,#46)")
      .with(46, "TOLERANCED_LENGTH_MEASURE(10.,$)")
      .with(62, "TOLERANCED_LENGTH_MEASURE(14.,$)")
      .with(50, "AXIS2_PLACEMENT_3D('',#51,$,$)")
      .with(51, "CARTESIAN_POINT('',(50.,40.,0.))");
  const Part turned = program.feature("CIRCULAR_PATTERN('RING',#3,(),#50,#40,90.,2,(),(),$,90.)").read();
  expect_box(turned.features[0].target, 15, 25, 33, 47);
  expect_box(turned.features[1].target, 43, 57, 5, 15);
  const Part parallel = program.feature("CIRCULAR_PATTERN('RING',#3,(),#50,#40,90.,2,(),(),$,0.)").read();
  expect_box(parallel.features[1].target, 45, 55, 3, 17);
}

TEST(StepNcPattern, RectangularWithMissingAndRelocatedMembers) {
  Program program = with_hole();
  program.with(42, "CARTESIAN_POINT('',(20.,20.,0.))")
      .with(52, "DIRECTION('',(1.,0.,0.))")
      .with(53, "TOLERANCED_LENGTH_MEASURE(15.,$)")
      .with(54, "TOLERANCED_LENGTH_MEASURE(12.,$)")
      .with(55, "DIRECTION('',(0.,1.,0.))")
      .with(56, "RECTANGULAR_OFFSET(#55,#57,1,3)")
      .with(57, "TOLERANCED_LENGTH_MEASURE(2.,$)")
      .with(58, "RECTANGULAR_OMIT(2,2)");
  const Part part =
      program.feature("RECTANGULAR_PATTERN('GRID',#3,(),#41,#40,#53,#52,2,3,#54,#55,(#56),(#58))").read();
  expect_centres(part, {{20, 20}, {35, 20}, {50, 22}, {20, 32}, {50, 32}});
  const Part row = program.feature("RECTANGULAR_PATTERN('GRID',#3,(),#41,#40,#53,#52,$,3,$,$,(),())").read();
  expect_centres(row, {{20, 20}, {35, 20}, {50, 20}});
  const Part spaced =
      program.feature("RECTANGULAR_PATTERN('GRID',#3,(),#41,#40,#53,#52,1,3,#54,#55,(),())").read();
  EXPECT_THAT(all_diagnostics(spaced), HasSubstr("its spacing of rows asks for nothing"));
  EXPECT_THAT(all_diagnostics(spaced), ::testing::Not(HasSubstr("not followed")));
  EXPECT_THAT(program.feature("RECTANGULAR_PATTERN('GRID',#3,(),#41,#40,#53,#52,2,3,$,$,(),())").error(),
              HasSubstr("spacing of rows"));
}

TEST(StepNcPattern, GeneralIsTheBaseAndACopyAtEachPlace) {
  const Part part = with_hole()
                        .feature("GENERAL_PATTERN('SOME',#3,(),#50,#40,(#52,#54))")
                        .with(52, "AXIS2_PLACEMENT_3D('',#53,$,$)")
                        .with(53, "CARTESIAN_POINT('',(10.,5.,0.))")
                        .with(54, "AXIS2_PLACEMENT_3D('',#55,$,$)")
                        .with(55, "CARTESIAN_POINT('',(-20.,0.,0.))")
                        .read();
  expect_centres(part, {{30, 40}, {60, 45}});
  EXPECT_THAT(all_diagnostics(part), HasSubstr("cut once"));
}

TEST(StepNcPattern, WhatCannotBeIsRefusedByName) {
  const auto error = [](const std::string& entity) { return with_hole().feature(entity).error(); };
  EXPECT_THAT(error("CIRCULAR_PATTERN('R',#3,(),#50,#40,90.,0,(),(),$,0.)"), HasSubstr("number of features"));
  EXPECT_THAT(error("CIRCULAR_PATTERN('R',#3,(),#50,#40,90.,1000000000,(),(),$,0.)"), HasSubstr("10000"));
  EXPECT_THAT(error("GENERAL_PATTERN('R',#3,(),#50,#20,(#21))"), HasSubstr("in a circle"));
  EXPECT_THAT(error("GENERAL_PATTERN('R',#3,(),#50,#40,())"), HasSubstr("no locations"));
  EXPECT_THAT(error("COMPOUND_FEATURE('C',#3,(),#50,#23,())"), HasSubstr("no elements"));
  EXPECT_THAT(error("EDGE_ROUND('C',#3,(),#40,#40,#43,$,$)"), HasSubstr("round it by hand"));
}

/// A counterbore: 20 mm wide 3 mm deep, and under it 6 mm, placed in the compound.
Program with_counterbore() {
  return with_hole()
      .feature("COMPOUND_FEATURE('CB',#3,(),#50,#23,(#46,#40))")
      .with(42, "CARTESIAN_POINT('',(0.,0.,-3.))")
      .with(46, "ROUND_HOLE('',#3,(),$,#47,#62,$,#44)")
      .with(47, "PLANE('',#48)")
      .with(48, "AXIS2_PLACEMENT_3D('',#49,$,$)")
      .with(49, "CARTESIAN_POINT('',(0.,0.,-3.))");
}

TEST(StepNcCompound, DrillsTakeTheHoleOfTheirDiameter) {
  const Part part = with_counterbore().read();
  ASSERT_EQ(part.workplan.size(), 1U);
  const Feature& hole = part.features[0];
  EXPECT_EQ(hole.name, "HOLE");
  EXPECT_EQ(hole.hole_diameter, 6);
  EXPECT_EQ(hole.floor_z, -8);
  expect_centres(part, {{50, 40}});
}

TEST(StepNcCompound, CuttersTakeWhatTheyFitInto) {
  Program program = with_counterbore();
  program.with(2, "WORKPLAN('MAIN',(#11,#10),$,#4,$)")
      .with(11, "MACHINING_WORKINGSTEP('MILL',#7,#20,#70,$)")
      .with(70, "BOTTOM_AND_SIDE_ROUGH_MILLING($,$,'OP',2.,$,#71,#34,#35,$,$,$,$,2.,$,$,$)")
      .with(71, "MILLING_CUTTING_TOOL('T6',#72,(),$,$,$)")
      .with(72, "ENDMILL(#73,3,.RIGHT.,$,$)")
      .with(73, "MILLING_TOOL_DIMENSION(10.,$,$,25.,0.,$,$)");
  const Part part = program.read();
  ASSERT_EQ(part.workplan.size(), 2U);
  EXPECT_EQ(part.features[0].name, "CB");
  EXPECT_EQ(part.features[0].hole_diameter, 20);
  EXPECT_EQ(part.features[0].floor_z, -3);
  EXPECT_EQ(part.workplan[0].operation.retract_z, 2);
  EXPECT_EQ(part.features[1].hole_diameter, 6);
  EXPECT_EQ(part.features[1].top_z, -3);
}

/// 21 mm of flutes bring all of a point 3 mm long below the block, 20 mm high, if the counterbore is cut first.
TEST(StepNcCompound, FlutesReachToTheFloorOfTheWiderHoleThatWasCutBefore) {
  Program program = with_counterbore();
  program.with(44, "THROUGH_BOTTOM_CONDITION()")
      .with(25, "CARTESIAN_POINT('',(0.,0.,-17.))")
      .with(33, "MILLING_TOOL_DIMENSION(6.,1.5707963267948966,$,21.,$,$,$)")
      .with(11, "MACHINING_WORKINGSTEP('MILL',#7,#20,#70,$)")
      .with(70, "BOTTOM_AND_SIDE_ROUGH_MILLING($,$,'OP',2.,$,#71,#34,#35,$,$,$,$,2.,$,$,$)")
      .with(71, "MILLING_CUTTING_TOOL('T6',#72,(),$,$,$)")
      .with(72, "ENDMILL(#73,3,.RIGHT.,$,$)")
      .with(73, "MILLING_TOOL_DIMENSION(10.,$,$,25.,0.,$,$)");
  const Part after = program.with(2, "WORKPLAN('MAIN',(#11,#10),$,#4,$)").read();
  EXPECT_NEAR(feature_of(after, after.workplan[1]).floor_z, -23, 1e-6);
  const Part before = program.with(2, "WORKPLAN('MAIN',(#10,#11),$,#4,$)").read();
  EXPECT_NEAR(feature_of(before, before.workplan[0]).floor_z, -21, 1e-6);
  EXPECT_THAT(all_diagnostics(before), HasSubstr("its width down to 2 mm over the underside"));
}

/// What an element lists as its own operation goes before what fits.
TEST(StepNcCompound, ElementsNameTheirOperations) {
  const Part part = with_counterbore().with(46, "ROUND_HOLE('',#3,(#30),$,#47,#62,$,#44)").read();
  ASSERT_EQ(part.features.size(), 1U);
  EXPECT_EQ(part.features[0].hole_diameter, 20);
}

TEST(StepNcCompound, AnElementAloneLiesInItsCompound) {
  const Part part = with_counterbore().with(10, "MACHINING_WORKINGSTEP('WS1',#7,#40,#30,$)").read();
  expect_centres(part, {{50, 40}});
  EXPECT_EQ(part.features[0].floor_z, -8);
}

TEST(StepNcCompound, ElementsThatCannotBeMadeAreLeftOutByName) {
  const Part part = with_counterbore()
                        .feature("COMPOUND_FEATURE('CB',#3,(),#50,#23,(#46,#40,#80))")
                        .with(80, "EDGE_ROUND('C',#3,(),#40,#46,#43,$,$)")
                        .read();
  EXPECT_EQ(part.features.size(), 1U);
  EXPECT_THAT(all_diagnostics(part), HasSubstr("a part of #20 COMPOUND_FEATURE is left out: "));
  EXPECT_THAT(all_diagnostics(part), HasSubstr("#80 EDGE_ROUND"));
}

TEST(StepNcCompound, ElementsThatNoWorkingstepMakesAreSaid) {
  const Part part = with_counterbore()
                        .feature("COMPOUND_FEATURE('CB',#3,(),#50,#23,(#46,#40,#80))")
                        .with(80, "CHAMFER('C',#3,(),#40,#46,0.7,#43)")
                        .read();
  EXPECT_EQ(part.features.size(), 1U);
  EXPECT_THAT(all_diagnostics(part),
              HasSubstr("#80 CHAMFER, a part of #20 COMPOUND_FEATURE, is made by no workingstep"));
}

TEST(StepNcCompound, PatternsOfCompoundsAndCompoundsOfPatterns) {
  const Part pattern = with_counterbore()
                           .with(81, "CIRCULAR_PATTERN('RING',#3,(),#82,#20,180.,2,(),(),$,0.)")
                           .with(82, "AXIS2_PLACEMENT_3D('',#83,$,$)")
                           .with(83, "CARTESIAN_POINT('',(50.,30.,0.))")
                           .with(10, "MACHINING_WORKINGSTEP('WS1',#7,#81,#30,$)")
                           .read();
  expect_centres(pattern, {{50, 40}, {50, 20}});
  EXPECT_EQ(pattern.features[1].floor_z, -8);
  const Part compound = with_hole()
                            .feature("COMPOUND_FEATURE('C',#3,(),#50,#23,(#81))")
                            .with(42, "CARTESIAN_POINT('',(10.,0.,0.))")
                            .with(81, "CIRCULAR_PATTERN('RING',#3,(),#21,#40,90.,4,(),(),$,0.)")
                            .read();
  expect_centres(compound, {{60, 40}, {50, 50}, {40, 40}, {50, 30}});
}

}  // namespace
}  // namespace clearcut::read::stepnc
