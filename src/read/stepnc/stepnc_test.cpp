// What each entity of ISO 14649 comes to: stock, set-ups, tools, operations, workplans. Files of real writers are read in
// tests/read/stepnc_test.cpp.
#include "read/stepnc/stepnc.h"

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
using ::testing::Not;
using testing::Program;
using testing::step;

TEST(StepNc, ReadsTheDirectionOfStrokesAndNamesWhatElseIsLeftToThePlanner) {
  const Part part = Program()
                        .with(37, "BIDIRECTIONAL_MILLING(0.5,.T.,#38,.LEFT.,.LOOP_BACK.)")
                        .with(38, "DIRECTION('',(0.,2.,0.))")
                        .read();
  EXPECT_EQ(part.workplan[0].operation.feed_direction, Radians::of(kPi / 2));
  std::string said;
  for (const auto& item : part.diagnostics.items()) said += item.what + "\n";
  EXPECT_NE(said.find("the stroke connection LOOP_BACK is not used"), std::string::npos) << said;
  EXPECT_NE(said.find("the stepover direction LEFT is not used"), std::string::npos) << said;
}

TEST(StepNc, ReadsTheDirectionsOfEveryStrategyOrSaysThatTheyAreNotUsed) {
  const auto with = [](const std::string& strategy) {
    return Program().with(37, strategy).with(38, "DIRECTION('',(1.,1.,0.))").read();
  };
  const Part both = with("BIDIRECTIONAL_CONTOUR(0.5,.F.,#38,.LEFT.,.CW.,.CLIMB.)");
  EXPECT_EQ(both.workplan[0].operation.feed_direction, Radians::of(kPi / 4));
  EXPECT_EQ(both.workplan[0].operation.direction, CutDirection::kClimb);
  for (const char* said :
       {"stepover direction LEFT is not used", "rotation direction is not used", "only one pass in depth"})
    EXPECT_THAT(all_diagnostics(both), HasSubstr(said));
  EXPECT_THAT(all_diagnostics(both), Not(HasSubstr("stroke connection")));
  EXPECT_EQ(with("CONTOUR_PARALLEL(0.5,.T.,.CW.,$)").workplan[0].operation.direction,
            CutDirection::kConventional);
  const Part plain = with("CONTOUR_SPIRAL(0.5,.T.,.CCW.,$)");
  EXPECT_FALSE(plain.workplan[0].operation.direction);
  EXPECT_THAT(all_diagnostics(plain), Not(HasSubstr("rotation direction")));
}

TEST(StepNc, ReadsProjectStockToolsAndOperation) {
  const Part part = Program().read();
  EXPECT_EQ(part.name, "P");
  EXPECT_EQ(part.source_file, "t.p21");
  ASSERT_TRUE(part.stock);
  EXPECT_EQ(part.stock->plan.max, (Vec2{100, 80}));
  EXPECT_EQ(part.stock->z_bottom, -20);
  EXPECT_EQ(part.stock->z_top, 0);
  EXPECT_EQ(part.clearance_z, 30);
  ASSERT_EQ(part.tools.size(), 1U);
  EXPECT_EQ(part.tools[0].number, 5);
  EXPECT_EQ(part.tools[0].name, "T5");
  EXPECT_EQ(part.tools[0].diameter, 10);
  EXPECT_EQ(part.tools[0].corner_radius, 0.5);
  EXPECT_EQ(part.tools[0].teeth, 3);
  EXPECT_EQ(part.tools[0].flute_length, 25);
  ASSERT_EQ(part.workplan.size(), 1U);
  const Operation& op = part.workplan[0].operation;
  EXPECT_EQ(part.workplan[0].name, "WS1");
  EXPECT_EQ(op.name, "OP");
  EXPECT_EQ(op.kind, OperationKind::kRoughing);
  EXPECT_EQ(op.cutting.feed, MmPerMin::of(600)) << "0.01 m/s";
  EXPECT_EQ(op.cutting.spindle_rpm, 6000) << "100 1/s";
  EXPECT_TRUE(op.cutting.spindle_clockwise);
  EXPECT_EQ(op.cutting.coolant, Coolant::kFlood);
  EXPECT_EQ(op.stepdown, 2);
  EXPECT_EQ(op.stepover, 0.4) << "radial depth 4 of 10 mm goes before the strategy's overlap";
  EXPECT_EQ(op.allowance_side, 0.3);
  EXPECT_EQ(op.allowance_floor, 0.1);
  EXPECT_EQ(op.entry, EntryKind::kRamp);
  EXPECT_EQ(op.entry_angle, Radians::of(0.05));
  EXPECT_EQ(op.direction, CutDirection::kConventional);
  EXPECT_EQ(op.strategy_hint, "contour_parallel");
  EXPECT_EQ(op.retract_z, 8);
}

TEST(StepNc, WhatIsNotUsedIsSaid) {
  const std::string radius = "CLOSED_POCKET('POCKET',#3,(#30),#21,#23,(),$,#26,$,#62,#27)";
  EXPECT_THAT(all_diagnostics(Program().feature(radius).read()),
              HasSubstr("the corner stays as it is drawn"));
  EXPECT_THAT(all_diagnostics(Program().feature(radius).with(27, "CIRCULAR_CLOSED_PROFILE(#28,#62)").read()),
              Not(HasSubstr("the corner stays")));
  EXPECT_THAT(
      all_diagnostics(
          Program().with(90, "(CONVERSION_BASED_UNIT('INCH',#91)LENGTH_UNIT()NAMED_UNIT(#92))").read()),
      HasSubstr("no GLOBAL_UNIT_ASSIGNED_CONTEXT assigns it: lengths are mm"));
  EXPECT_THAT(Program().with(2, "WORKPLAN('MAIN',(#11),$,#4,$)").with(11, "SET_MARK('P')").error(),
              HasSubstr("#11 SET_MARK is no machining workingstep"));
}

TEST(StepNc, EveryApproachAndRetractStrategyIsReadOrNamed) {
  struct Row {
    const char* approach;
    std::optional<EntryKind> entry;
    std::optional<double> angle, size, lead, lead_angle;
    int notes;
  };
  const std::nullopt_t none = std::nullopt;
  const Row rows[] = {{"PLUNGE_TOOLAXIS($)", EntryKind::kPlunge, none, none, none, none, 0},
                      {"PLUNGE_RAMP($,0.05)", EntryKind::kRamp, 0.05, none, none, none, 0},
                      {"PLUNGE_HELIX($,3.,0.05)", EntryKind::kHelix, 0.05, 3.0, none, none, 0},
                      {"PLUNGE_ZIGZAG($,0.05,8.)", EntryKind::kZigzagRamp, 0.05, 8.0, none, none, 0},
                      {"AP_RETRACT_TANGENT($,2.5)", none, none, none, 2.5, none, 0},
                      {"AP_RETRACT_ANGLE($,0.5,4.)", none, none, none, 4.0, 0.5, 0},
                      {"AP_LIFT_PATH_ANGLE($,0.1,2.)", EntryKind::kRamp, 0.1, none, none, none, 0},
                      {"AP_LIFT_PATH_TANGENT($,2.,1.)", EntryKind::kRamp, none, none, none, none, 1},
                      {"ALONG_PATH($,#99)", none, none, none, none, none, 1}};
  const int other_notes = count_of(Program().read(), Severity::kNote);
  const auto value = [](const std::optional<Radians>& angle) {
    return angle ? std::optional(angle->radians()) : std::nullopt;
  };
  for (const Row& row : rows) {
    const Part part = Program().with(36, row.approach).read();
    const Operation& op = part.workplan[0].operation;
    EXPECT_EQ(op.entry, row.entry) << row.approach;
    EXPECT_EQ(value(op.entry_angle), row.angle) << row.approach;
    EXPECT_EQ(op.entry_size, row.size) << row.approach;
    EXPECT_EQ(op.lead, row.lead) << row.approach;
    EXPECT_EQ(value(op.lead_angle), row.lead_angle) << row.approach;
    // Entries and leads are told as read, of the program before as of this one, if there are any.
    const int untold = row.entry || row.lead ? 0 : 1;
    EXPECT_EQ(count_of(part, Severity::kNote), other_notes + row.notes - untold) << all_diagnostics(part);
  }
}

TEST(StepNc, RetractStrategiesThatLeaveTheWallGiveLeads) {
  const auto with_retract = [](const std::string& retract) {
    Program p;
    p.with(30, "BOTTOM_AND_SIDE_ROUGH_MILLING($,$,'OP',8.,$,#31,#34,#35,$,#36,#99,#37,2.,4.,0.3,0.1)");
    return p.with(99, retract).read();
  };
  const Part arc = with_retract("AP_RETRACT_TANGENT($,2.5)");
  EXPECT_EQ(arc.workplan[0].operation.lead, 2.5);
  EXPECT_EQ(arc.workplan[0].operation.entry, EntryKind::kRamp);
  const Part line = with_retract("AP_RETRACT_ANGLE($,0.5,4.)");
  EXPECT_EQ(line.workplan[0].operation.lead, 4.0);
  EXPECT_EQ(line.workplan[0].operation.lead_angle, Radians::of(0.5));
  EXPECT_FALSE(with_retract("PLUNGE_TOOLAXIS($)").workplan[0].operation.lead);
  EXPECT_NE(all_diagnostics(with_retract("AP_LIFT_PATH_ANGLE($,0.5,4.)")).find("lifted straight up"),
            std::string::npos);
}

TEST(StepNc, SlopeIsTheAngleFromTheVertical) {
  Program p;
  p.feature("CLOSED_POCKET('POCKET',#3,(#30),#21,#23,(),0.785,#26,$,$,#27)");
  EXPECT_EQ(p.read().features[0].wall_slope, Radians::of(0.785));
  p.feature("CLOSED_POCKET('POCKET',#3,(#30),#21,#23,(),30.,#26,$,$,#27)");
  EXPECT_NEAR(p.read().features[0].wall_slope.degrees(), 30, 1e-12) << "above 2 pi: degrees";
  p.feature("CLOSED_POCKET('POCKET',#3,(#30),#21,#23,(),5.,#26,$,$,#27)");
  EXPECT_NEAR(p.read().features[0].wall_slope.degrees(), 5, 1e-12) << "a wall cannot lean by 5 radians";
  p.feature("CLOSED_POCKET('POCKET',#3,(#30),#21,#23,(),1.,#26,$,$,#27)").with(36, "PLUNGE_RAMP($,45.)");
  EXPECT_NEAR(p.read().features[0].wall_slope.degrees(), 1, 1e-12) << "another angle shows the file's unit";
}

TEST(StepNc, OutsideProfileRemovesTheRestOfTheStock) {
  Program p;
  p.feature("GENERAL_OUTSIDE_PROFILE('OUT',#3,(#30),#21,#23,$,#27)");
  const Feature f = p.read().features[0];
  EXPECT_EQ(f.kind, FeatureKind::kOutsideProfile);
  EXPECT_NEAR(area(f.target), 8000 - 1200, 1e-9);
  EXPECT_FALSE(contains(f.allowed, {50, 40}));
  EXPECT_TRUE(contains(f.allowed, {50, -100}));
}

TEST(StepNc, NestedWorkplansAreCutInOrder) {
  Program p;
  p.with(2, "WORKPLAN('MAIN',(#11,#10,#12),$,#4,$)")
      .with(11, "WORKPLAN('A',(#13),$,$,$)")
      .with(12, "WORKPLAN('B',(#14,#15),$,$,$)");
  for (const int id : {13, 14, 15})
    p.with(id, "MACHINING_WORKINGSTEP('WS" + std::to_string(id) + "',#7,#20,#30,$)");
  const Part part = p.read();
  std::string order;
  for (const Workingstep& step : part.workplan) order += step.name + " ";
  EXPECT_EQ(order, "WS13 WS1 WS14 WS15 ");
  EXPECT_EQ(part.features.size(), 1U);
}

TEST(StepNc, WorkplansInACircleAreRefused) {
  Program p;
  p.with(2, "WORKPLAN('MAIN',(#11),$,#4,$)").with(11, "WORKPLAN('A',(#2,#2),$,$,$)");
  EXPECT_THAT(p.error(), HasSubstr("WORKPLAN: "));
}

TEST(StepNc, StockMayBeACylinderOrARawPiece) {
  Program p;
  p.with(5, "RIGHT_CIRCULAR_CYLINDER('C',#6,20.,50.)");
  EXPECT_EQ(p.read().stock->plan.min, (Vec2{-50, -50}));
  p = Program().with(3, "WORKPIECE('WP',$,$,#80,$,#5,())").with(80, "WORKPIECE('RAW',$,$,$,$,#81,())");
  p.with(81, "BLOCK('B',#82,110.,90.,-25.)")
      .with(82, "AXIS2_PLACEMENT_3D('',#83,$,$)")
      .with(83, "CARTESIAN_POINT('',(-5.,-5.,2.))");
  const Part part = p.read();
  EXPECT_EQ(part.stock->plan.max, (Vec2{105, 85}));
  EXPECT_EQ(part.stock->z_top, 2);
  EXPECT_EQ(part.stock->z_bottom, -23) << "sizes may be negative";
  EXPECT_EQ(part.features[0].top_z, 2) << "the raw piece stands 2 mm higher";
  EXPECT_EQ(count_of(part, Severity::kWarning), 1);
}

TEST(StepNc, SecurityPlaneIsRelativeToTheSetUp) {
  Program p;
  p.with(9, "WORKPIECE_SETUP(#3,#85,$,$,())")
      .with(85, "AXIS2_PLACEMENT_3D('',#86,$,$)")
      .with(86, "CARTESIAN_POINT('',(100.,50.,12.))");
  const Part part = p.read();
  EXPECT_EQ(part.clearance_z, 18);
  EXPECT_THAT(all_diagnostics(part), HasSubstr("program zero is the workpiece's origin"));
}

TEST(StepNc, SecurityPlaneInsideTheStockIsNotUsed) {
  const Part part = Program().with(61, "CARTESIAN_POINT('',(0.,0.,-3.))").read();
  EXPECT_FALSE(part.clearance_z);
  EXPECT_EQ(part.safe_z(), 10);
}

TEST(StepNc, SpindleAndFeedInOtherUnitsAreRecognisedAndReported) {
  Part part = Program().with(34, "MILLING_TECHNOLOGY(400.,.TCP.,$,-1200.,$,$,$,$,$)").read();
  EXPECT_EQ(part.workplan[0].operation.cutting.spindle_rpm, 1200);
  EXPECT_EQ(part.workplan[0].operation.cutting.feed, MmPerMin::of(400));
  EXPECT_THAT(all_diagnostics(part), HasSubstr("read as rpm"));
  EXPECT_THAT(all_diagnostics(part), HasSubstr("read as mm/min"));
  part = Program().with(34, "MILLING_TECHNOLOGY($,.TCP.,100.,$,0.05,$,$,$,$)").read();
  const double rpm = 100000 / (kPi * 10);
  EXPECT_NEAR(*part.workplan[0].operation.cutting.spindle_rpm, rpm, 1e-9) << "cutting speed 100 m/min";
  EXPECT_NEAR(part.workplan[0].operation.cutting.feed->mm_per_min(), 0.05 * 3 * rpm, 1e-9) << "per tooth";
}

TEST(StepNc, FilesOfItsOwnWriterAreInTheUnitsOfTheStandard) {
  Program p;
  p.with(34, "MILLING_TECHNOLOGY(2.5,.TCP.,$,-1200.,$,$,$,$,$)");
  EXPECT_EQ(p.read().workplan[0].operation.cutting.feed, MmPerMin::of(2.5)) << "of anybody: mm/min";
  const Part part = p.by("clearcut").read();
  EXPECT_EQ(part.workplan[0].operation.cutting.feed, MmPerMin::of(150000));
  EXPECT_EQ(part.workplan[0].operation.cutting.spindle_rpm, 72000);
  EXPECT_EQ(part.workplan[0].operation.entry_angle, Radians::of(0.05));
  EXPECT_THAT(all_diagnostics(part), Not(HasSubstr("read as")));
}

TEST(StepNc, OnlyALeftHandCutterTurningPositiveRunsCounterClockwise) {
  Program p;
  p.with(34, "MILLING_TECHNOLOGY(0.01,.TCP.,$,100.,$,$,$,$,$)");
  EXPECT_TRUE(p.read().workplan[0].operation.cutting.spindle_clockwise)
      << "a right-hand mill, whatever the sign";
  p.with(32, "ENDMILL(#33,3,.LEFT.,$,$)");
  EXPECT_FALSE(p.read().workplan[0].operation.cutting.spindle_clockwise);
}

TEST(StepNc, LeftHandCuttersRunCounterClockwiseWhereNoSpindleSpeedIsStated) {
  Program p;
  p.with(32, "ENDMILL(#33,3,.LEFT.,$,$)").with(34, "MILLING_TECHNOLOGY(0.01,.TCP.,2.,$,$,$,$,$,$)");
  EXPECT_FALSE(p.read().workplan[0].operation.cutting.spindle_clockwise) << "by its cutting speed";
  p.with(34, "MILLING_TECHNOLOGY(0.01,.TCP.,$,$,$,$,$,$,$)");
  EXPECT_FALSE(p.read().workplan[0].operation.cutting.spindle_clockwise) << "by the planner's default";
  p.with(30, "BOTTOM_AND_SIDE_ROUGH_MILLING($,$,'OP',$,$,#31,$,#35,$,$,$,$,2.,$,$,$)");
  EXPECT_FALSE(p.read().workplan[0].operation.cutting.spindle_clockwise) << "without technology";
  p.with(34, "MILLING_TECHNOLOGY(0.01,.TCP.,$,-100.,$,$,$,$,$)");
  p.with(30, "BOTTOM_AND_SIDE_ROUGH_MILLING($,$,'OP',$,$,#31,#34,#35,$,$,$,$,2.,$,$,$)");
  EXPECT_THAT(all_diagnostics(p.read()), HasSubstr("it would turn backwards"));
}

TEST(StepNc, RetractsAlongARampAreNamedAsNotUsed) {
  Program p;
  p.with(30, "BOTTOM_AND_SIDE_ROUGH_MILLING($,$,'OP',$,$,#31,#34,#35,$,$,#91,$,2.,$,$,$)");
  EXPECT_THAT(all_diagnostics(p.with(91, "PLUNGE_RAMP($,45.)").read()),
              HasSubstr("the cutter is lifted straight up: #91 PLUNGE_RAMP($,45)"));
  EXPECT_THAT(all_diagnostics(p.with(91, "PLUNGE_TOOLAXIS($)").read()),
              ::testing::Not(HasSubstr("lifted straight up")));
}

TEST(StepNc, WoodruffMillsAreDiscsThatMakeUndercuts) {
  Program p;
  EXPECT_THAT(p.with(32, "WOODRUFF_KEYSEAT_MILL(#33,3,.RIGHT.,$,$,2.)").error(),
              HasSubstr("makes the undercut of a slot with a TEE_PROFILE alone"));
}

TEST(StepNc, OtherHandsOfCutAreNamed) {
  Program p;
  EXPECT_THAT(all_diagnostics(p.with(32, "ENDMILL(#33,3,.NEUTRAL.,$,$)").read()),
              HasSubstr("not followed: hand_of_cut .NEUTRAL."));
}

TEST(StepNc, CuttersThatDifferInTheirHandAreTwoTools) {
  Program p;
  p.with(2, "WORKPLAN('MAIN',(#10,#11),$,#4,$)").with(11, "MACHINING_WORKINGSTEP('WS',#7,#20,#91,$)");
  p.with(91, "BOTTOM_AND_SIDE_ROUGH_MILLING($,$,'OP',$,$,#94,#34,#35,$,$,$,$,2.,$,$,$)");
  p.with(94, "MILLING_CUTTING_TOOL('T1',#97,(),$,$,$)").with(97, "ENDMILL(#33,3,.LEFT.,$,$)");
  p.with(31, "MILLING_CUTTING_TOOL('T1',#32,(),$,$,$)").with(32, "ENDMILL(#33,3,.RIGHT.,$,$)");
  const Part part = p.read();
  ASSERT_EQ(part.workplan.size(), 2U);
  EXPECT_NE(tool_of(part, part.workplan[0]).number, tool_of(part, part.workplan[1]).number);
}

TEST(StepNc, TaperedEndMillsAreReadWithTheirTaper) {
  Program p;
  EXPECT_EQ(p.with(32, "TAPERED_ENDMILL(#33,3,.RIGHT.,$,$,$)").read().tools[0].kind, ToolKind::kEndMill);
  p.with(32, "TAPERED_ENDMILL(#33,3,.RIGHT.,$,$,0.0873)");
  EXPECT_THAT(p.error(), HasSubstr("tip is rounded"));
  const Part part = p.with(33, "MILLING_TOOL_DIMENSION(10.,$,$,25.,0.,$,$)").read();
  EXPECT_EQ(part.tools[0].kind, ToolKind::kTapered);
  EXPECT_EQ(part.tools[0].diameter, 10) << "of the tip";
  EXPECT_NEAR(part.tools[0].tip_angle.value_or(Radians{}).radians(), 2 * 0.0873, 1e-12);
  const Part in_degrees = p.with(32, "TAPERED_ENDMILL(#33,3,.RIGHT.,$,$,10.)").read();
  EXPECT_NEAR(in_degrees.tools[0].tip_angle.value_or(Radians{}).degrees(), 20, 1e-9);
  EXPECT_THAT(p.with(32, "TAPERED_ENDMILL(#33,3,.RIGHT.,$,$,50.)").error(), HasSubstr("0.1 to 45 degrees"));
  p.with(32, "TAPERED_ENDMILL(#33,3,.RIGHT.,$,$,0.0873)")
      .with(33, "MILLING_TOOL_DIMENSION(10.,$,$,$,0.,$,$)");
  EXPECT_THAT(p.error(), HasSubstr("length of its cutting edges"));
}

TEST(StepNc, ToolsAreReadOnceAndNumbered) {
  Program p;
  p.with(2, "WORKPLAN('MAIN',(#10,#11,#12),$,#4,$)");
  for (const int k : {1, 2}) {
    p.with(10 + k, "MACHINING_WORKINGSTEP('WS',#7,#20,#" + std::to_string(90 + k) + ",$)");
    p.with(90 + k, "BOTTOM_AND_SIDE_ROUGH_MILLING($,$,'OP',$,$,#" + std::to_string(94 + k) +
                       ",#34,#35,$,$,$,$,2.,$,$,$)");
    p.with(94 + k, "MILLING_CUTTING_TOOL('ball nose',#97,(),$,$,$)");
  }
  p.with(97, "BALL_ENDMILL(#33,2,$,$,$)");
  const Part part = p.read();
  ASSERT_EQ(part.tools.size(), 2U);
  EXPECT_EQ(part.tools[1].kind, ToolKind::kBallEndMill);
  EXPECT_EQ(part.tools[1].corner_radius, 5);
  EXPECT_EQ(part.tools[1].number, 1);
  EXPECT_EQ(part.workplan[1].operation.tool, 1);
  EXPECT_EQ(part.workplan[2].operation.tool, 1);
}

TEST(StepNc, WhatCannotBeMachinedIsSkippedAndTheRestStays) {
  Program p;
  p.with(2, "WORKPLAN('MAIN',(#11,#10,#12,#13),$,#4,$)");
  p.with(11, "MACHINING_WORKINGSTEP('TAP IT',#7,#20,#90,$)")
      .with(90, "TAPPING($,$,'TAP',$,$,#31,#34,#35,$,$,$,$,$,$,.T.)");
  p.with(12, "MACHINING_WORKINGSTEP('NO FEATURE',#7,#99,#30,$)");
  p.with(13, "MACHINING_WORKINGSTEP('CHAMFER IT',#7,#98,#30,$)")
      .with(98, "CHAMFER('C',#3,(),#20,#20,0.7,#62)");
  const Part part = p.read();
  ASSERT_EQ(part.workplan.size(), 1U);
  EXPECT_EQ(part.workplan[0].name, "WS1");
  EXPECT_EQ(count_of(part, Severity::kSkipped), 3) << all_diagnostics(part);
  EXPECT_THAT(all_diagnostics(part),
              HasSubstr("'TAP IT' is left out: line 41: #90 TAPPING: tapping needs a TAP"));
  EXPECT_THAT(all_diagnostics(part), HasSubstr("refers to #99, which is not in the file"));
  EXPECT_THAT(all_diagnostics(part), HasSubstr("CHAMFER: no closed edge lies between"));
}

TEST(StepNc, MissingEssentialsNameEntityAndLine) {
  EXPECT_EQ(Program().with(33, "MILLING_TOOL_DIMENSION($,$,$,25.,0.5,$,$)").error(),
            "t.p21:29: #33 MILLING_TOOL_DIMENSION: no diameter (argument 1); give one");
  EXPECT_EQ(Program().feature("CLOSED_POCKET('POCKET',#3,(#30),#21,#23,(),$,#26,$,$,$)").error(),
            "t.p21:16: #20 CLOSED_POCKET: no feature boundary (argument 11); give one");
  EXPECT_EQ(Program().feature("CLOSED_POCKET('POCKET',#3,(#30),#21,$,(),$,#26,$,$,#27)").error(),
            "t.p21:16: #20 CLOSED_POCKET: no depth (argument 5); give one");
  EXPECT_THAT(Program().with(25, "CARTESIAN_POINT('',(0.,0.,5.))").error(),
              HasSubstr("#20 CLOSED_POCKET: its depth plane (z 5) is not below its top (z 0)"));
}

TEST(StepNc, MissingNonEssentialsGetDefaultsAndOneNoteForAll) {
  Program p;
  p.with(30, "BOTTOM_AND_SIDE_MILLING($,$,'OP',$,$,#31,$,$,$,$,$,$,$,$,$,$)")
      .with(33, "MILLING_TOOL_DIMENSION(10.,$,$,$,$,$,$)");
  p.with(2, "WORKPLAN('MAIN',(#10,#11),$,$,$)").with(11, "MACHINING_WORKINGSTEP('WS2',$,#20,#90,$)");
  p.with(90, "BOTTOM_AND_SIDE_MILLING($,$,'OP2',$,$,#31,$,$,$,$,$,$,$,$,$,$)");
  const Part part = p.read();
  EXPECT_EQ(part.workplan.size(), 2U);
  const std::string notes = all_diagnostics(part);
  EXPECT_THAT(notes, HasSubstr("#30 BOTTOM_AND_SIDE_MILLING, #90 BOTTOM_AND_SIDE_MILLING: no cutting depth; "
                               "the planner's default is used"));
  EXPECT_THAT(notes, HasSubstr("no technology"));
  EXPECT_THAT(notes,
              HasSubstr("#33 MILLING_TOOL_DIMENSION: no edge radius; the cutter is taken as flat-ended"));
  EXPECT_THAT(notes, HasSubstr("tools as read: T5 endmill 10 mm, 3 teeth"));
  EXPECT_LE(part.diagnostics.items().size(), 6U) << notes;
}

TEST(StepNc, WhereFeedsAreMissingAMaterialThatIsNotRecognisedIsNamed) {
  Program p;
  p.with(3, "WORKPIECE('WP',#91,$,$,$,#5,())").with(91, "MATERIAL('X1','Unobtainium',())");
  EXPECT_THAT(all_diagnostics(p.read()), ::testing::Not(HasSubstr("--material")));
  p.with(34, "MILLING_TECHNOLOGY($,.TCP.,$,-100.,$,$,$,$,$)");
  EXPECT_THAT(all_diagnostics(p.read()), HasSubstr("none of the materials of --material is recognised in"));
  EXPECT_FALSE(p.read().material);
}

TEST(StepNc, TheMaterialCountsWhereAFeedOrASpeedIsMissing) {
  Program p;
  p.with(3, "WORKPIECE('WP',#91,$,$,$,#5,())").with(91, "MATERIAL('6061','Aluminium',())");
  EXPECT_FALSE(p.read().material) << "all is stated";
  EXPECT_THAT(all_diagnostics(p.read()), HasSubstr("not used, an annotation: WORKPIECE: its_material"));
  for (const char* technology : {"$", "#92"}) {
    p.with(92, "MILLING_TECHNOLOGY($,.TCP.,$,-100.,$,$,$,$,$,$)");
    p.with(30, std::string("BOTTOM_AND_SIDE_MILLING($,$,'OP',$,$,#31,") + technology + ",$,$,$,$,$,$,$,$,$)");
    const Part part = p.read();
    EXPECT_EQ(part.material, "aluminium");
    const std::string notes = all_diagnostics(part);
    EXPECT_THAT(notes,
                HasSubstr("no feed or no speed is stated for #30; without --material they are those for "
                          "aluminium, by #91 MATERIAL('6061','Aluminium',()) (line "));
    EXPECT_THAT(notes, ::testing::Not(HasSubstr("an annotation: WORKPIECE: its_material")));
  }
  p.with(91, "MATERIAL('EN 10083','42CrMo4',())");
  EXPECT_EQ(p.read().material, "alloy-steel");
}

TEST(StepNc, OtherSchemasAreRefusedByName) {
  EXPECT_THAT(Program().schema("INTEGRATED_CNC_SCHEMA").error(), HasSubstr("AP238"));
  EXPECT_THAT(Program().schema("AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }").error(),
              HasSubstr("a STEP solid"));
}

TEST(StepNc, TiltedSetUpsAndFeaturesAreRefusedByName) {
  Program p;
  p.with(84, "DIRECTION('',(1.,0.,0.))").with(85, "AXIS2_PLACEMENT_3D('',#22,#84,$)");
  EXPECT_THAT(Program(p).with(4, "SETUP('S',#85,#7,(#9))").error(),
              HasSubstr("#4 SETUP: the set-up is tilted"));
  p.with(86, "DIRECTION('',(1.,0.,1.))").with(87, "AXIS2_PLACEMENT_3D('',#22,#86,$)");
  EXPECT_THAT(Program(p).with(9, "WORKPIECE_SETUP(#3,#87,$,$,())").error(),
              HasSubstr("#9 WORKPIECE_SETUP: the workpiece is tilted"));
  EXPECT_THAT(Program(p).feature("CLOSED_POCKET('POCKET',#3,(#30),#85,#23,(),$,#26,$,$,#27)").error(),
              HasSubstr("#20 CLOSED_POCKET: its placement is tilted"));
}

TEST(StepNc, DepthsThatWouldEndBelowTheStockAreReadAsAbsolute) {
  Program p;  // two pockets, one in the other, with absolute depths
  p.with(2, "WORKPLAN('MAIN',(#10,#11),$,#4,$)").with(11, "MACHINING_WORKINGSTEP('WS2',#7,#70,#30,$)");
  p.with(70, "CLOSED_POCKET('INNER',#3,(#30),#71,#73,(),$,#26,$,$,#76)")
      .with(71, "AXIS2_PLACEMENT_3D('',#72,$,$)");
  p.with(72, "CARTESIAN_POINT('',(0.,0.,-9.))")
      .with(73, "PLANE('',#74)")
      .with(74, "AXIS2_PLACEMENT_3D('',#75,$,$)");
  p.with(75, "CARTESIAN_POINT('',(0.,0.,-15.))")
      .with(76, "CIRCULAR_CLOSED_PROFILE(#28,#77)")
      .with(77, "TOLERANCED_LENGTH_MEASURE(16.,$)");
  const Part part = p.read();
  EXPECT_EQ(part.features[0].floor_z, -5);
  EXPECT_EQ(part.features[1].floor_z, -15);
  EXPECT_EQ(part.features[1].top_z, -5) << "what the first pocket left, not the placement's -9";
  EXPECT_THAT(all_diagnostics(part), HasSubstr("the depths of the whole file are taken as absolute z"));
  EXPECT_EQ(count_of(part, Severity::kWarning), 1);
}

TEST(StepNc, NoStockButAFaceShowsHowFarItReaches) {
  Program p;
  p.with(3, "WORKPIECE('WP',$,$,$,$,$,())").feature("PLANAR_FACE('FACE',#3,(#30),#21,#23,$,$,#27,())");
  const Part part = p.read();
  ASSERT_TRUE(part.stock);
  expect_box({Region::from_valid_loops(part.features[0].target[0].outer(), {})}, 20, 80, 30, 50);
  EXPECT_EQ(part.stock->z_top, 0);
  EXPECT_EQ(part.stock->z_bottom, -5);
  EXPECT_TRUE(contains(part.features[0].allowed, {0, 0}));
}

TEST(StepNc, NoStockAndNoFaceIsSolidAround) {
  const Part part = Program().with(3, "WORKPIECE('WP',$,$,$,$,$,())").read();
  EXPECT_FALSE(part.stock);
  EXPECT_THAT(Program()
                  .with(3, "WORKPIECE('WP',$,$,$,$,$,())")
                  .feature("PLANAR_FACE('FACE',#3,(#30),#21,#23,$,$,$,())")
                  .error(),
              HasSubstr("need the size of the stock"));
}

TEST(StepNc, SharedReferencesDoNotMultiply) {
  // Each composite curve uses the next one twice: 2^16 copies of the innermost.
  Program p;
  p.with(27, "GENERAL_CLOSED_PROFILE($,#100)");
  for (int k = 0; k < 40; ++k)
    p.with(100 + k,
           "COMPOSITE_CURVE('',(#" + std::to_string(101 + k) + ",#" + std::to_string(101 + k) + "),.F.)");
  EXPECT_THAT(p.error(), HasSubstr("nested more than 16 deep"));
}

}  // namespace
}  // namespace clearcut::read::stepnc
