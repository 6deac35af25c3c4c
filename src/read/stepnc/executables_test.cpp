// What a workplan may hold beside workingsteps, set-ups, and what of a file nobody uses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "model/results/findings.h"
#include "read/stepnc/test_program.h"

namespace clearcut::read::stepnc {
namespace {

using testing::all_diagnostics;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::Program;

std::vector<std::string> open_conditions_of(const Part& part) {
  std::vector<std::string> texts;
  for (const Diagnostic& one : part.diagnostics.items())
    if (!one.condition.empty()) texts.push_back(one.what);
  return texts;
}

/// A second workingstep #11 on a pocket #80 beside the first.
Program two_pockets(const std::string& elements) {
  Program program;
  program.with(2, "WORKPLAN('MAIN',(" + elements + "),$,#4,$)");
  program.with(11, "MACHINING_WORKINGSTEP('WS2',#7,#80,#30,$)");
  program.with(80, "CLOSED_POCKET('SECOND',#3,(#30),#81,#23,(),$,#26,$,$,#27)");
  program.with(81, "AXIS2_PLACEMENT_3D('',#82,$,$)").with(82, "CARTESIAN_POINT('',(0.,20.,0.))");
  return program.with(62, "TOLERANCED_LENGTH_MEASURE(14.,$)");
}

TEST(StepNcExecutables, BranchesInParallelAndInAnyOrderAreCutAsWritten) {
  for (const char* kind : {"PARALLEL", "NON_SEQUENTIAL"}) {
    const Part part = two_pockets("#12").with(12, std::string(kind) + "('ALL',(#11,#10))").read();
    ASSERT_EQ(part.workplan.size(), 2U) << kind;
    EXPECT_EQ(part.workplan[0].name, "WS2");
    EXPECT_THAT(names_not_machined(part.diagnostics), IsEmpty());
    EXPECT_THAT(open_conditions_of(part), IsEmpty());
  }
}

TEST(StepNcExecutables, OfSelectiveElementsTheFirstIsCutAndTheOthersAreNamed) {
  const Part part = two_pockets("#12").with(12, "SELECTIVE('EITHER',(#11,#10))").read();
  ASSERT_EQ(part.workplan.size(), 1U);
  EXPECT_EQ(part.workplan[0].name, "WS2");
  EXPECT_THAT(all_diagnostics(part), HasSubstr("the first is, and not: WS1"));
}

TEST(StepNcExecutables, BranchesAndLoopsThatDependOnTheMachineAreNotMachinedByName) {
  Program branch = two_pockets("#10,#12").with(12, "IF_STATEMENT('IF',#13,#11,$)");
  branch.with(13, "COMPARISON_EQUAL(#14,#15)").with(14, "NC_CONSTANT('A',1.)").with(15, "NC_PROBED('B')");
  EXPECT_THAT(names_not_machined(branch.read().diagnostics), ElementsAre("WS2"));
  const Part loop = two_pockets("#10,#12").with(12, "WHILE_STATEMENT('LOOP',$,#11)").read();
  EXPECT_THAT(names_not_machined(loop.diagnostics), ElementsAre("WS2"));
  EXPECT_THAT(all_diagnostics(loop), HasSubstr("how often it is repeated is known at the machine alone"));
}

TEST(StepNcExecutables, ABranchWhoseConditionIsAConstantIsTaken) {
  const auto cut = [](const std::string& value) {
    Program program = two_pockets("#12").with(12, "IF_STATEMENT('IF',#13,#10,#11)");
    program.with(13, "COMPARISON_EQUAL(#14,2.)").with(14, "NC_CONSTANT('A'," + value + ")");
    const Part part = program.read();
    EXPECT_THAT(names_not_machined(part.diagnostics), IsEmpty());
    return part.workplan.size() == 1 ? part.workplan[0].name : "";
  };
  EXPECT_EQ(cut("2."), "WS1");
  EXPECT_EQ(cut("3."), "WS2");
}

TEST(StepNcExecutables, StopsAndMessagesComeBeforeTheNextStep) {
  Program program = two_pockets("#10,#12,#13,#14,#11");
  program.with(12, "PROGRAM_STOP('TURN THE CLAMP')").with(13, "OPTIONAL_STOP('LOOK')");
  const Part part = program.with(14, "DISPLAY_MESSAGE('M','NOW THE SECOND')").read();
  ASSERT_EQ(part.workplan.size(), 2U);
  EXPECT_TRUE(part.workplan[0].stops.empty());
  ASSERT_EQ(part.workplan[1].stops.size(), 3U);
  EXPECT_EQ(part.workplan[1].stops[0].text, "TURN THE CLAMP");
  EXPECT_TRUE(part.workplan[1].stops[1].kind == StopKind::kOptional);
  EXPECT_TRUE(part.workplan[1].stops[2].kind == StopKind::kMessage);
  EXPECT_EQ(part.workplan[1].stops[2].text, "NOW THE SECOND");
}

TEST(StepNcExecutables, OthersAreOpenConditionsAndWorkingstepsOfOtherMachinesAreNotMachined) {
  for (const char* kind :
       {"ASSIGNMENT('A',$,$)", "RAPID_MOVEMENT('R',$,$,$)", "INDEX_TABLE('I',90.)", "TOUCH('T')"}) {
    const Part part = two_pockets("#10,#12").with(12, kind).read();
    EXPECT_EQ(open_conditions_of(part).size(), 1U) << all_diagnostics(part);
  }
  const Part turned = two_pockets("#10,#12").with(12, "TURNING_WORKINGSTEP('TURN IT',$,$,$,$)").read();
  EXPECT_THAT(names_not_machined(turned.diagnostics), ElementsAre("TURN IT"));
}

TEST(StepNcLedger, WhatBearsOnThePartIsAnOpenConditionAndAnnotationsAreNotes) {
  Program program;
  program.with(3, "WORKPIECE('WP',$,0.05,$,$,#5,())");
  program.with(30, "BOTTOM_AND_SIDE_ROUGH_MILLING(#90,$,'OP',8.,$,#31,#34,#35,$,#36,$,#37,2.,4.,0.3,0.1)");
  program.with(90, "TOOLPATH_LIST((#91))").with(91, "CUTTER_LOCATION_TRAJECTORY(.T.,$,$,$,$,$,$,$,$)");
  const Part part = program.read();
  ASSERT_EQ(open_conditions_of(part).size(), 1U) << all_diagnostics(part);
  EXPECT_THAT(open_conditions_of(part)[0],
              HasSubstr("#30 BOTTOM_AND_SIDE_ROUGH_MILLING: its toolpath is not followed"));
  EXPECT_THAT(all_diagnostics(part), HasSubstr("an annotation: WORKPIECE: global_tolerance of #3 (line "));
}

TEST(StepNcLedger, AFileThatAsksForNothingMoreHasNoConditions) {
  EXPECT_THAT(open_conditions_of(Program().read()), IsEmpty()) << all_diagnostics(Program().read());
}

TEST(StepNcSetups, EachHasItsStepsAndItsAxes) {
  Program program = two_pockets("#70,#71");
  program.with(2, "WORKPLAN('MAIN',(#70,#71),$,$,$)");
  program.with(70, "WORKPLAN('A',(#10),$,#4,$)").with(71, "WORKPLAN('B',(#11),$,#72,$)");
  program.with(72, "SETUP('S2',$,#7,(#73))").with(73, "WORKPIECE_SETUP(#3,#74,$,$,())");
  program.with(74, "AXIS2_PLACEMENT_3D('',#22,$,#75)").with(75, "DIRECTION('',(0.,1.,0.))");
  EXPECT_EQ(count_setups(program.text(), "t.p21"), 2);
  SetupPlace place;
  const Part first = read_setup(program.text(), "t.p21", {}, 1, place);
  ASSERT_EQ(first.workplan.size(), 1U);
  EXPECT_EQ(first.workplan[0].name, "WS1");
  EXPECT_THAT(open_conditions_of(first), IsEmpty()) << all_diagnostics(first);
  const Part second = read_setup(program.text(), "t.p21", {}, 2, place);
  ASSERT_EQ(second.workplan.size(), 1U);
  EXPECT_EQ(second.workplan[0].name, "WS2");
  // The workpiece's x lies along y: what was at x 20..80, y 53..67 is at x -67..-53, y 20..80.
  testing::expect_box(second.features[0].target, -67, -53, 20, 80);
  EXPECT_NEAR(second.stock->plan.min.x, -80, 1e-9);
  EXPECT_NEAR(place.turn[1][0], 1, 1e-12);
  EXPECT_THAT(open_conditions_of(program.read()), ElementsAre(HasSubstr("cut in 2 set-ups")));
}

TEST(StepNcSetups, ThatAreNotThereAreRefused) {
  SetupPlace place;
  for (const int number : {-1, 2, 1000})
    EXPECT_THROW(read_setup(Program().text(), "t.p21", {}, number, place), InputError) << number;
  EXPECT_NO_THROW(read_setup(Program().text(), "t.p21", {}, 1, place));
}

/// What an earlier set-up has cut away over a feature is not known when the file is read.
TEST(StepNcSetups, ALaterOneMayBeginLowerThanTheBlock) {
  Program program = two_pockets("#70,#71");
  program.with(2, "WORKPLAN('MAIN',(#70,#71),$,$,$)").with(82, "CARTESIAN_POINT('',(0.,20.,-5.))");
  program.with(70, "WORKPLAN('A',(#10),$,#4,$)").with(71, "WORKPLAN('B',(#11),$,#72,$)");
  program.with(72, "SETUP('S2',$,#7,(#73))").with(73, "WORKPIECE_SETUP(#3,#74,$,$,())");
  program.with(74, "AXIS2_PLACEMENT_3D('',#22,$,#75)").with(75, "DIRECTION('',(0.,1.,0.))");
  SetupPlace place;
  const Part second = read_setup(program.text(), "t.p21", {}, 2, place);
  ASSERT_EQ(second.features.size(), 1U);
  EXPECT_EQ(second.features[0].top_z, 0);
  EXPECT_EQ(second.features[0].floor_z, -10);
  EXPECT_THAT(all_diagnostics(second), Not(HasSubstr("what is cut before it leaves material")));
  EXPECT_THAT(all_diagnostics(second), HasSubstr("where earlier set-ups have left material above"));
}

TEST(StepNcSetups, AWorkpieceThatIsTurnedOverIsCutFromItsOtherSide) {
  Program program;
  program.with(9, "WORKPIECE_SETUP(#3,#74,$,$,())").with(74, "AXIS2_PLACEMENT_3D('',#22,#75,#76)");
  program.with(75, "DIRECTION('',(0.,0.,-1.))").with(76, "DIRECTION('',(1.,0.,0.))");
  program.with(21, "AXIS2_PLACEMENT_3D('',#77,#75,#76)").with(77, "CARTESIAN_POINT('',(0.,0.,-20.))");
  program.with(28, "AXIS2_PLACEMENT_3D('',#29,$,$)").with(29, "CARTESIAN_POINT('',(50.,-40.,0.))");
  const Part part = program.read();
  ASSERT_EQ(part.features.size(), 1U) << all_diagnostics(part);
  EXPECT_NEAR(part.features[0].top_z, 20, 1e-9);
  EXPECT_NEAR(part.features[0].floor_z, 15, 1e-9);
  testing::expect_box(part.features[0].target, 20, 80, -50, -30);
}

TEST(StepNcSetups, ClampsAndRestrictedAreasAreKeptOutOf) {
  Program program;
  program.with(3, "WORKPIECE('WP',$,$,$,$,#5,(#70,#71))");
  program.with(70, "CARTESIAN_POINT('C1',(0.,40.,-5.))").with(71, "CARTESIAN_POINT('C2',(0.,40.,25.))");
  program.with(9, "WORKPIECE_SETUP(#3,#21,$,#72,(#75))").with(72, "BLOCK('JAW',#73,100.,5.,30.)");
  program.with(73, "AXIS2_PLACEMENT_3D('',#74,$,$)").with(74, "CARTESIAN_POINT('',(0.,80.,-20.))");
  const Part part = program.with(75, "SETUP_INSTRUCTION('20 NM',$)").read();
  ASSERT_EQ(part.keep_outs.size(), 2U);
  EXPECT_EQ(part.keep_outs[0].top_z, -5);
  EXPECT_EQ(part.keep_outs[1].plan.min.y, 80);
  EXPECT_EQ(part.keep_outs[1].top_z, 10);
  EXPECT_THAT(all_diagnostics(part), HasSubstr("#71 CARTESIAN_POINT: the clamping position does not lie on"));
  EXPECT_THAT(all_diagnostics(part), HasSubstr("the set-up's instruction: 20 NM"));
}

/// The units of the file `contexts` say; the example in units of them.
Part with_units(const std::string& units) {
  Program program;
  program.with(900,
               "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#901))REPRESENTATION_"
               "CONTEXT('',''))");
  program.with(901, units).with(902, "LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#903)");
  return program.with(903, "(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))").read();
}

TEST(StepNcUnits, TheGlobalUnitOfLengthHoldsForAllLengths) {
  const Part inch = with_units("(CONVERSION_BASED_UNIT('INCH',#902)LENGTH_UNIT()NAMED_UNIT(*))");
  testing::expect_box(inch.features[0].target, 20 * 25.4, 80 * 25.4, 30 * 25.4, 50 * 25.4);
  EXPECT_NEAR(inch.features[0].floor_z, -5 * 25.4, 1e-9);
  EXPECT_NEAR(inch.tools[0].diameter, 254, 1e-9);
  EXPECT_NEAR(*inch.workplan[0].operation.stepdown, 2 * 25.4, 1e-9);
  EXPECT_NEAR(inch.stock->plan.max.x, 2540, 1e-9);
  const Part cm = with_units("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.CENTI.,.METRE.))");
  EXPECT_NEAR(cm.tools[0].diameter, 100, 1e-9);
  const Part mm = with_units("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
  EXPECT_EQ(mm.tools[0].diameter, 10);
}

TEST(StepNcUnits, DegreesAreDegreesHoweverSmall) {
  Program program;
  program.with(900,
               "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#901))REPRESENTATION_"
               "CONTEXT('',''))");
  program.with(901, "(CONVERSION_BASED_UNIT('DEGREE',#902)NAMED_UNIT(*)PLANE_ANGLE_UNIT())");
  program.with(902, "PLANE_ANGLE_MEASURE_WITH_UNIT(PLANE_ANGLE_MEASURE(0.0174532925),#903)");
  program.with(903, "(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
  const Part part = program.with(36, "PLUNGE_RAMP($,3.)").read();
  EXPECT_NEAR(part.workplan[0].operation.entry_angle->degrees(), 3, 1e-9);
}

TEST(StepNcUnits, UnitsThatCannotBeReadAreRefusedByLine) {
  Program program;
  program.with(900, "(GLOBAL_UNIT_ASSIGNED_CONTEXT((#901))REPRESENTATION_CONTEXT('',''))");
  program.with(901, "(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.GIGA.,.METRE.))");
  EXPECT_THAT(program.error(), HasSubstr("#901: its prefix .GIGA. is not known"));
}

}  // namespace
}  // namespace clearcut::read::stepnc
