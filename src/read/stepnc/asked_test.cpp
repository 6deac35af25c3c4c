// What features and operations ask for beyond their outlines: fillets, low bosses, depths and bottoms of holes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/units.h"
#include "model/results/findings.h"
#include "read/stepnc/shapes/curve.h"
#include "read/stepnc/test_program.h"

namespace clearcut::read::stepnc {
namespace {

using testing::all_diagnostics;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::Program;

std::vector<std::string> conditions_of(const Part& part) {
  std::vector<std::string> texts;
  for (const Diagnostic& one : part.diagnostics.items())
    if (!one.condition.empty()) texts.push_back(one.what);
  return texts;
}

/// The pocket of 60 x 20 with fillets of `radius` between its walls.
Program with_fillets(const std::string& radius) {
  Program program;
  return program.feature("CLOSED_POCKET('POCKET',#3,(#30),#21,#23,(),$,#26,$,#70,#27)")
      .with(70, "TOLERANCED_LENGTH_MEASURE(" + radius + ",$)");
}

TEST(StepNcFillets, BetweenWallsAreArcsInTheCorners) {
  const Part part = with_fillets("4.").read();
  EXPECT_NEAR(area(part.features[0].target), 1200 - (4 - kPi) * 16, 1e-9);
  EXPECT_EQ(part.features[0].target[0].outer().size(), 8U);
  EXPECT_THAT(conditions_of(part), IsEmpty());
}

TEST(StepNcFillets, AsWideAsThePocketMakeHalfCircles) {
  const Part part = with_fillets("10.").read();
  EXPECT_NEAR(area(part.features[0].target), 1200 - (4 - kPi) * 100, 1e-6);
  EXPECT_EQ(part.features[0].target[0].outer().size(), 6U);
}

TEST(StepNcFillets, ThatDoNotFitAreSaidByPlace) {
  const Part part = with_fillets("12.").read();
  ASSERT_FALSE(conditions_of(part).empty());
  EXPECT_THAT(conditions_of(part)[0],
              HasSubstr("no fillet of 12 mm (orthogonal_radius) fits into the corner at"));
}

TEST(StepNcFillets, AlsoBetweenLinesAndArcsAndOnTheOtherSide) {
  // A half disc of radius 10 about the origin, flat below: its two corners lie on the x axis.
  const Loop half{Edge::line({-10, 0}, {10, 0}),
                  Edge::arc({10, 0}, {-10, 0}, {0, 0}, Turn::kCounterClockwise)};
  const Filleted rounded = filleted(half, true, 2);
  EXPECT_TRUE(rounded.sharp.empty());
  ASSERT_EQ(rounded.path.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const Edge &a = rounded.path[i], &b = rounded.path[(i + 1) % 4];
    EXPECT_NEAR(distance(a.to, b.from), 0, 1e-9);
    EXPECT_NEAR(std::abs(cross(a.tangent_at(1), b.tangent_at(0))), 0, 1e-9);
  }
  // The centre of a fillet lies 2 above the line and 8 from the origin.
  EXPECT_NEAR(rounded.path[0].to.x, std::sqrt(64.0 - 4.0), 1e-9);
  const Filleted other = filleted_on_the_right(reversed(half), 2);
  EXPECT_NEAR(length(other.path), length(filleted(half, false, 2).path), 1e-9);
}

TEST(StepNcFillets, AtTheFloorAreThoseOfTheCutterOrSaid) {
  Program program;
  program.feature("CLOSED_POCKET('POCKET',#3,(#30),#21,#23,(),$,#26,#70,$,#27)");
  program.with(30, "BOTTOM_AND_SIDE_ROUGH_MILLING($,$,'OP',8.,$,#31,#34,#35,$,#36,$,#37,2.,4.,0.,0.)");
  program.with(70, "TOLERANCED_LENGTH_MEASURE(0.5,$)");
  EXPECT_THAT(conditions_of(program.read()), IsEmpty());
  EXPECT_EQ(program.read().features[0].floor_fillet, 0.5);
  program.with(70, "TOLERANCED_LENGTH_MEASURE(3.,$)");
  EXPECT_THAT(conditions_of(program.read()), ElementsAre(HasSubstr("cuts 1.036 mm into it")));
  program.with(70, "TOLERANCED_LENGTH_MEASURE(0.2,$)");
  EXPECT_THAT(conditions_of(program.read()), IsEmpty());
  EXPECT_THAT(all_diagnostics(program.read()), HasSubstr("is that of the cutter, 0.5 mm"));
}

Program with_boss(double top) {
  Program program;
  program.feature("CLOSED_POCKET('POCKET',#3,(#30),#21,#23,(#70),$,#26,$,$,#27)");
  program.with(70, "BOSS('BOSS',#3,(),#71,#23,#73,$)").with(71, "AXIS2_PLACEMENT_3D('',#72,$,$)");
  program.with(72, "CARTESIAN_POINT('',(50.,40.," + std::to_string(top) + "))");
  return program.with(73, "CIRCULAR_CLOSED_PROFILE($,#74)").with(74, "TOLERANCED_LENGTH_MEASURE(6.,$)");
}

TEST(StepNcBosses, ThatEndBelowTheTopAreMilledOver) {
  const Part part = with_boss(-2).read();
  ASSERT_EQ(part.features.size(), 2U);
  EXPECT_NEAR(area(part.features[0].target), 1200, 1e-9);
  EXPECT_EQ(part.features[0].floor_z, -2);
  EXPECT_NEAR(area(part.features[1].target), 1200 - kPi * 9, 1e-9);
  EXPECT_EQ(part.features[1].top_z, -2);
  EXPECT_EQ(part.features[1].floor_z, -5);
  EXPECT_EQ(part.features[1].name, "POCKET");
  ASSERT_EQ(part.workplan.size(), 2U);
  const Part full = with_boss(0).read();
  ASSERT_EQ(full.features.size(), 1U);
  const Part none = with_boss(-6).read();
  ASSERT_EQ(none.features.size(), 1U);
  EXPECT_NEAR(area(none.features[0].target), 1200, 1e-9) << "it ends below the floor";
}

TEST(StepNcBosses, WhoseWallsLeanLessThanTheirPocketsAreSaid) {
  const auto boss_with = [](const std::string& slope) {
    Program program = with_boss(0);
    program.feature("CLOSED_POCKET('POCKET',#3,(#30),#21,#23,(#70),0.1,#26,$,$,#27)");
    return program.with(70, "BOSS('BOSS',#3,(),#71,#23,#73," + slope + ")").read();
  };
  EXPECT_THAT(conditions_of(boss_with("0.")), ElementsAre(HasSubstr("less than those of its pocket")));
  EXPECT_THAT(conditions_of(boss_with("0.1")), IsEmpty());
  EXPECT_THAT(all_diagnostics(boss_with("$")), HasSubstr("its walls lean as those of its pocket"));
}

TEST(StepNcOpenPockets, DrawnTheOtherWayRoundAreTakenFromTheSmallerSide) {
  const auto pocket = [](const std::string& points) {
    Program p;
    p.feature("OPEN_POCKET('OPEN',#3,(#30),#21,#23,(),$,#26,$,$,#70,$)").with(70, "GENERAL_PROFILE($,#71)");
    p.with(71, "POLYLINE('',(" + points + "))");
    p.with(72, "CARTESIAN_POINT('',(30.,0.,0.))").with(73, "CARTESIAN_POINT('',(30.,25.,0.))");
    p.with(74, "CARTESIAN_POINT('',(60.,25.,0.))").with(75, "CARTESIAN_POINT('',(60.,0.,0.))");
    return p.read();
  };
  const Part right = pocket("#72,#73,#74,#75"), other = pocket("#75,#74,#73,#72");
  EXPECT_NEAR(area(right.features[0].target), 750, 1e-6);
  EXPECT_THAT(conditions_of(right), IsEmpty());
  EXPECT_NEAR(area(other.features[0].target), 750, 1e-6);
  EXPECT_THAT(conditions_of(other), IsEmpty());
  EXPECT_THAT(all_diagnostics(other), HasSubstr("that side is taken"));
}

/// A pocket in a corner of the stock, and one about a block that stands there, are drawn alike.
TEST(StepNcOpenPockets, InACornerOfTheStockAreTakenFromTheSmallerSideOnACondition) {
  Program p;
  p.feature("OPEN_POCKET('OPEN',#3,(#30),#21,#23,(),$,#26,$,$,#70,$)").with(70, "GENERAL_PROFILE($,#71)");
  p.with(71, "POLYLINE('',(#72,#73,#74))").with(72, "CARTESIAN_POINT('',(30.,0.,0.))");
  p.with(73, "CARTESIAN_POINT('',(30.,25.,0.))").with(74, "CARTESIAN_POINT('',(0.,25.,0.))");
  const Part part = p.read();
  EXPECT_NEAR(area(part.features[0].target), 750, 1e-6);
  EXPECT_THAT(conditions_of(part), ElementsAre(HasSubstr("that side is taken")));
}

TEST(StepNcOutsideProfiles, OfOpenRectanglesLeaveWhatIsBetweenTheirSides) {
  Program p;
  p.feature("RECTANGULAR_OPEN_SHAPE_PROFILE('P',#3,(#30),#21,#23,$,$,$,#70)");
  p.with(70, "SQUARE_U_PROFILE($,#72,$,$,$,$)").with(72, "TOLERANCED_LENGTH_MEASURE(20.,$)");
  const Part part = p.with(22, "CARTESIAN_POINT('',(50.,40.,0.))").read();
  EXPECT_NEAR(area(part.features[0].target), 100 * 80 - 20 * 40, 1e-6);
  EXPECT_THAT(conditions_of(part), IsEmpty());
}

TEST(StepNcOutsideProfiles, ThatEndInsideTheStockAreOpenedOnACondition) {
  Program p;
  p.feature("PARTIAL_CIRCULAR_SHAPE_PROFILE('P',#3,(#30),#21,#23,$,$,$,#70)")
      .with(70, "PARTIAL_CIRCULAR_PROFILE($,#71,3.141592653589793)")
      .with(71, "TOLERANCED_LENGTH_MEASURE(30.,$)");
  const Part across = p.with(22, "CARTESIAN_POINT('',(50.,0.,0.))").read();
  EXPECT_NEAR(area(across.features[0].target), 100 * 80 - kPi / 2 * 900, 1e-6);
  EXPECT_THAT(conditions_of(across), IsEmpty());
  const Part inside = p.with(22, "CARTESIAN_POINT('',(50.,10.,0.))").read();
  EXPECT_THAT(conditions_of(inside), ElementsAre(HasSubstr("it is opened straight to the nearest edge")));
}

TEST(StepNcOutsideProfiles, OfAFullTurnHaveNoOpenSide) {
  for (const char* sweep : {"6.283185307179586", "-6.283185307179586", "6.28319", "-6.2832", "360."}) {
    Program p;
    p.feature("PARTIAL_CIRCULAR_SHAPE_PROFILE('P',#3,(#30),#21,#23,$,$,$,#70)")
        .with(70, "PARTIAL_CIRCULAR_PROFILE($,#71," + std::string(sweep) + ")")
        .with(71, "TOLERANCED_LENGTH_MEASURE(30.,$)");
    const Part part = p.with(22, "CARTESIAN_POINT('',(50.,40.,0.))").read();
    EXPECT_NEAR(area(part.features[0].target), 100 * 80 - kPi * 900, 1e-6);
    EXPECT_THAT(conditions_of(part), IsEmpty());
  }
}

/// What an entry asks for bears on a program only where the cutter goes down in material.
TEST(StepNcEntries, AreToldAsRead) {
  const auto told = [](const char* approach) {
    return testing::all_diagnostics(Program().with(36, approach).read());
  };
  EXPECT_THAT(told("PLUNGE_HELIX($,2.5,0.05)"),
              HasSubstr("entries and leads as read: helix 2.5 mm 2.8648 deg (#30)"));
  EXPECT_THAT(told("PLUNGE_RAMP($,0.05)"), HasSubstr("entries and leads as read: ramp 2.8648 deg (#30)"));
  EXPECT_THAT(told("AP_RETRACT_ANGLE($,0.5,3.)"), HasSubstr("as read: lead 3 mm 28.6479 deg (#30)"));
}

/// A slot of 60 x 12 along x.
Program slot_with_ends(const std::string& ends) {
  Program p;
  p.feature("SLOT('SLOT',#3,(#30),#70,#23,#72,#73," + ends + ")");
  p.with(70, "AXIS2_PLACEMENT_3D('',#71,$,$)").with(71, "CARTESIAN_POINT('',(20.,40.,0.))");
  p.with(72, "LINEAR_PATH($,#63,$)").with(73, "SQUARE_U_PROFILE($,#74,$,$,$,$)");
  p.with(74, "TOLERANCED_LENGTH_MEASURE(12.,$)").with(75, "RADIUSED_SLOT_END_TYPE()");
  return p.with(76, "WOODRUFF_SLOT_END_TYPE(#74)").with(77, "LOOP_SLOT_END_TYPE()");
}

TEST(StepNcSlots, WithOneEndHaveItAtBothOnACondition) {
  const Part both = slot_with_ends("(#75,#75)").read(), one = slot_with_ends("(#75)").read();
  EXPECT_NEAR(area(both.features[0].target), 720 + kPi * 36, 1e-3);
  EXPECT_THAT(conditions_of(both), IsEmpty());
  EXPECT_NEAR(area(one.features[0].target), 720 + kPi * 36, 1e-3);
  EXPECT_THAT(conditions_of(one), ElementsAre(HasSubstr("it is taken for both ends")));
}

TEST(StepNcSlots, LoseNoEndThatTheFileStates) {
  EXPECT_THAT(slot_with_ends("(#76)").error(), HasSubstr("WOODRUFF_SLOT_END_TYPE: this end of a slot"));
  EXPECT_THAT(slot_with_ends("(#75,#75,#76)").error(), HasSubstr("more than two end conditions"));
  EXPECT_THAT(conditions_of(slot_with_ends("(#77)").read()),
              ElementsAre(HasSubstr("does not come back to its begin")));
}

TEST(StepNcOpenPockets, AreClosedByTheirWallsWhereThoseMeetTheOpenSide) {
  Program p;
  p.feature("OPEN_POCKET('OPEN',#3,(#30),#21,#23,(),$,#26,$,$,#70,#76)").with(70, "GENERAL_PROFILE($,#71)");
  p.with(71, "POLYLINE('',(#72,#75))").with(76, "GENERAL_PROFILE($,#77)");
  p.with(77, "POLYLINE('',(#72,#73,#74,#75))");
  p.with(72, "CARTESIAN_POINT('',(30.,0.,0.))").with(73, "CARTESIAN_POINT('',(30.,25.,0.))");
  p.with(74, "CARTESIAN_POINT('',(60.,25.,0.))").with(75, "CARTESIAN_POINT('',(60.,0.,0.))");
  const Part part = p.read();
  EXPECT_NEAR(area(part.features[0].target), 750, 1e-6);
  EXPECT_TRUE(contains(part.features[0].allowed, {45, -5})) << "open below";
  EXPECT_THAT(conditions_of(part), IsEmpty());
}

/// A hole of 10 mm, 12 deep, with one operation or two.
Program hole(const std::string& operation, const std::string& bottom = "FLAT_HOLE_BOTTOM()") {
  Program program;
  program.feature("ROUND_HOLE('HOLE',#3,(#30),#21,#23,#70,$,#71)")
      .with(70, "TOLERANCED_LENGTH_MEASURE(10.,$)");
  program.with(71, bottom)
      .with(22, "CARTESIAN_POINT('',(50.,40.,0.))")
      .with(25, "CARTESIAN_POINT('',(0.,0.,-12.))");
  program.with(30, operation).with(32, "TWIST_DRILL(#33,2,.RIGHT.,$,$)");
  return program.with(33, "MILLING_TOOL_DIMENSION(10.,31.,$,40.,$,$,$)");
}

TEST(StepNcHoles, AreAsDeepAsTheirOperationSays) {
  const Part whole = hole("DRILLING($,$,'D',5.,$,#31,#34,#35,$,$,$,$,$,$)").read();
  EXPECT_EQ(whole.features[0].floor_z, -12);
  EXPECT_THAT(conditions_of(whole), IsEmpty());
  EXPECT_NEAR(whole.tools[0].tip_angle->degrees(), 118, 1e-9) << "31 degrees is the angle of the edge";
  const Part less = hole("DRILLING($,$,'D',5.,$,#31,#34,#35,$,9.,$,$,$,$)").read();
  ASSERT_EQ(less.features.size(), 1U);
  EXPECT_EQ(less.features[0].floor_z, -9);
  EXPECT_THAT(conditions_of(less), ElementsAre(HasSubstr("go 9 of the 12 mm down")));
  const Part more = hole("DRILLING($,$,'D',5.,$,#31,#34,#35,$,15.,$,$,$,$)").read();
  EXPECT_EQ(more.features[0].floor_z, -12);
  EXPECT_THAT(conditions_of(more), ElementsAre(HasSubstr("it is made no deeper")));
}

TEST(StepNcHoles, FeedsDwellsAndEarlierHolesOfDrillingAreKept) {
  Program program = hole("DRILLING($,$,'D',5.,$,#31,#34,#35,$,$,$,1.5,0.5,#80)");
  const Part part = program.with(80, "DRILLING_TYPE_STRATEGY($,50.,2.,$,0.75,3.)").read();
  const HoleFeeds feeds = part.workplan[0].operation.hole_feeds.value();
  EXPECT_EQ(feeds.dwell_s, 1.5);
  EXPECT_EQ(feeds.retract_share, 0.5);
  EXPECT_EQ(feeds.start_share, 0.5);
  EXPECT_EQ(feeds.start_depth, 2);
  EXPECT_EQ(feeds.end_share, 0.75);
  EXPECT_EQ(feeds.end_depth, 3);
  const Part before = hole("DRILLING($,$,'D',5.,$,#31,#34,#35,$,$,4.,$,$,$)").read();
  EXPECT_THAT(conditions_of(before), ElementsAre(HasSubstr("no earlier workingstep makes the hole of 4 mm")));
}

TEST(StepNcHoles, AreCentredBeforeTheyAreDrilled) {
  Program program = hole("DRILLING($,$,'D',5.,$,#31,#34,#35,$,$,$,$,$,$)");
  program.with(2, "WORKPLAN('MAIN',(#11,#10),$,#4,$)").with(11, "MACHINING_WORKINGSTEP('C',#7,#20,#90,$)");
  program.with(90, "CENTER_DRILLING($,$,'C',5.,$,#91,#34,#35,$,3.,$,$,$,$)");
  program.with(91, "MILLING_CUTTING_TOOL('T7',#92,(),$,$,$)").with(92, "CENTER_DRILL(#93,2,.RIGHT.,$,$)");
  const Part part = program.with(93, "MILLING_TOOL_DIMENSION(4.,30.,$,12.,$,$,$)").read();
  ASSERT_EQ(part.workplan.size(), 2U) << all_diagnostics(part);
  const Feature& spot = feature_of(part, part.workplan[0]);
  EXPECT_EQ(spot.floor_z, -3);
  EXPECT_EQ(spot.hole_diameter, 4);
  EXPECT_EQ(feature_of(part, part.workplan[1]).top_z, 0);
  EXPECT_THAT(conditions_of(part), IsEmpty());
}

TEST(StepNcHoles, ThatAreDrilledTwiceAsDeepAreDrilledOnce) {
  Program program = hole("DRILLING($,$,'D',5.,$,#31,#34,#35,$,$,$,$,$,$)");
  program.with(2, "WORKPLAN('MAIN',(#11,#12,#10),$,#4,$)")
      .with(11, "MACHINING_WORKINGSTEP('C',#7,#20,#90,$)");
  program.with(12, "MACHINING_WORKINGSTEP('D',#7,#20,#94,$)");
  program.with(90, "CENTER_DRILLING($,$,'C',5.,$,#91,#34,#35,$,6.,$,$,$,$)");
  program.with(94, "DRILLING($,$,'D',5.,$,#91,#34,#35,$,6.,$,$,$,$)");
  program.with(91, "MILLING_CUTTING_TOOL('T7',#92,(),$,$,$)").with(92, "CENTER_DRILL(#93,2,.RIGHT.,$,$)");
  const Part part = program.with(93, "MILLING_TOOL_DIMENSION(4.,30.,$,12.,$,$,$)").read();
  EXPECT_EQ(part.workplan.size(), 2U);
  EXPECT_THAT(all_diagnostics(part), HasSubstr("#12 'D' has nothing left to cut"));
}

TEST(StepNcHoles, EndAsTheirToolsDoOrItIsSaid) {
  const std::string drilling = "DRILLING($,$,'D',5.,$,#31,#34,#35,$,$,$,$,$,$)";
  EXPECT_THAT(conditions_of(hole(drilling, "CONICAL_HOLE_BOTTOM(118.,$)").read()), IsEmpty());
  EXPECT_THAT(conditions_of(hole(drilling, "CONICAL_HOLE_BOTTOM(90.,$)").read()),
              ElementsAre(HasSubstr("a cone of 90 degrees")));
  EXPECT_THAT(
      conditions_of(
          hole(drilling, "SPHERICAL_HOLE_BOTTOM(#72)").with(72, "TOLERANCED_LENGTH_MEASURE(5.,$)").read()),
      ElementsAre(HasSubstr("with a radius of 5 mm")));
}

TEST(StepNcHoles, ThatGoThroughEndAtTheUndersideOrItIsSaid) {
  Program program = hole("DRILLING($,$,'D',5.,$,#31,#34,#35,$,$,$,$,$,$)", "THROUGH_BOTTOM_CONDITION()");
  program.with(25, "CARTESIAN_POINT('',(0.,0.,-20.))");
  EXPECT_THAT(conditions_of(program.read()), IsEmpty());
  program.with(25, "CARTESIAN_POINT('',(0.,0.,-19.7))");
  EXPECT_THAT(conditions_of(program.read()),
              ElementsAre(HasSubstr("ends 0.3 mm over the underside of the stock")));
}

TEST(StepNcHoles, ShallowerThanThePointOfTheirDrillAreNamed) {
  Program program = hole("DRILLING($,$,'D',5.,$,#31,#34,#35,$,$,$,$,$,$)");
  const auto told = [&](const std::string& depth) {
    return all_diagnostics(program.with(25, "CARTESIAN_POINT('',(0.,0.,-" + depth + "))").read());
  };
  EXPECT_THAT(told("2.9"), HasSubstr("nowhere has it its diameter"));
  EXPECT_THAT(told("3.1"), ::testing::Not(HasSubstr("nowhere has it its diameter")))
      << "the point has 3.004 mm";
}

TEST(StepNcHoles, TakeTheSizeOfADrillWithinTheirField) {
  Program program = hole("DRILLING($,$,'D',5.,$,#31,#34,#35,$,$,$,$,$,$)");
  program.with(70, "TOLERANCED_LENGTH_MEASURE(10.,#73)").with(73, "PLUS_MINUS_VALUE(0.2,0.,3)");
  EXPECT_EQ(program.read().features[0].hole_diameter, 10);
  // Of what is milled the middle of the field counts.
  Program pocket;
  pocket.with(62, "TOLERANCED_LENGTH_MEASURE(20.,#73)").with(73, "PLUS_MINUS_VALUE(0.5,0.3,3)");
  testing::expect_box(pocket.read().features[0].target, 20, 80, 40 - 10.05, 40 + 10.05);
}

}  // namespace
}  // namespace clearcut::read::stepnc
