// Chamfers, vees, half-round slots and slanted steps: what is read of them, and by which cutters.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/units.h"
#include "model/results/findings.h"
#include "read/stepnc/test_program.h"

namespace clearcut::read::stepnc {
namespace {

using testing::all_diagnostics;
using ::testing::HasSubstr;
using testing::Program;

constexpr const char* kCone = "COUNTERSINK(#83,1,.RIGHT.,$,$,$)";

/// A face over the whole block, 1 mm deep, the pocket below it, and a workingstep on the chamfer #90 with tool #81.
Program with_chamfer(const std::string& chamfer, const std::string& angle = "1.5707963267949") {
  Program p;
  p.with(2, "WORKPLAN('MAIN',(#11,#10,#12),$,#4,$)");
  p.with(11, "MACHINING_WORKINGSTEP('F',#7,#70,#71,$)").with(12, "MACHINING_WORKINGSTEP('C',#7,#90,#91,$)");
  p.with(70, "PLANAR_FACE('FACE',#3,(#71),#72,#74,$,$,$,())").with(72, "AXIS2_PLACEMENT_3D('',#73,$,$)");
  p.with(73, "CARTESIAN_POINT('',(0.,0.,0.))")
      .with(74, "PLANE('',#75)")
      .with(75, "AXIS2_PLACEMENT_3D('',#76,$,$)");
  p.with(76, "CARTESIAN_POINT('',(0.,0.,-1.))");
  p.with(71, "PLANE_ROUGH_MILLING($,$,'F',$,$,#31,#34,#35,$,$,$,$,$,$)");
  p.with(22, "CARTESIAN_POINT('',(0.,0.,-1.))");
  p.with(81, "MILLING_CUTTING_TOOL('T9',#82,(),$,$,$)").with(82, kCone);
  p.with(83, "MILLING_TOOL_DIMENSION(8.," + angle + ",$,10.,$,$,$)");
  p.with(90, chamfer).with(92, "TOLERANCED_LENGTH_MEASURE(0.8,$)");
  return p.with(91, "SIDE_FINISH_MILLING($,$,'C',$,$,#81,#34,#35,$,$,$,$,$,$,$)");
}

TEST(StepNcChamfers, LieWhereTheWallsOfOneFeatureEndInTheFloorOfTheOther) {
  for (const char* sides : {"#70,#20", "#20,#70"}) {
    const Part part =
        with_chamfer("CHAMFER('CHAMFER',#3,(#91)," + std::string(sides) + ",0.785398163397,#92)").read();
    ASSERT_EQ(part.features.size(), 3U) << all_diagnostics(part);
    const Feature& chamfer = part.features[2];
    ASSERT_TRUE(chamfer.chamfer);
    EXPECT_EQ(chamfer.top_z, -1);
    EXPECT_NEAR(chamfer.chamfer->depth, 0.8, 1e-9);
    EXPECT_NEAR(length(chamfer.chamfer->line), 160, 1e-9);
    EXPECT_NEAR(chamfer.wall_slope.degrees(), 45, 1e-6);
    EXPECT_EQ(tool_of(part, part.workplan[2]).kind, ToolKind::kVBit);
  }
}

TEST(StepNcChamfers, LieThereWhereTheWorkpieceIsTurnedOver) {
  Program p = with_chamfer("CHAMFER('CHAMFER',#3,(#91),#70,#20,0.785398163397,#92)");
  p.with(9, "WORKPIECE_SETUP(#3,#93,$,$,())").with(93, "AXIS2_PLACEMENT_3D('',$,#94,#95)");
  p.with(94, "DIRECTION('',(0.,0.,-1.))").with(95, "DIRECTION('',(1.,0.,0.))");
  p.with(72, "AXIS2_PLACEMENT_3D('',#73,#94,#95)").with(73, "CARTESIAN_POINT('',(0.,80.,-20.))");
  p.with(21, "AXIS2_PLACEMENT_3D('',#22,#94,#95)").with(22, "CARTESIAN_POINT('',(0.,80.,-19.))");
  const Part part = p.read();
  ASSERT_EQ(part.features.size(), 3U) << all_diagnostics(part);
  EXPECT_EQ(part.features[2].top_z, 19);
  EXPECT_NEAR(length(part.features[2].chamfer->line), 160, 1e-9);
}

TEST(StepNcChamfers, AreMeasuredOnTheFirstFeature) {
  const std::string angle = std::to_string(kPi / 6);
  // 30 degrees against the face, 0.8 mm wide: its cone has 120 degrees.
  const Part wide = with_chamfer("CHAMFER('CHAMFER',#3,(#91),#70,#20," + angle + ",#92)", "2.0943951").read();
  ASSERT_EQ(wide.features.size(), 3U) << all_diagnostics(wide);
  EXPECT_NEAR(wide.features[2].chamfer->depth, 0.8 * std::tan(kPi / 6), 1e-5);
  // 30 degrees against the wall, 0.8 mm deep: its cone has 60 degrees.
  const Part deep = with_chamfer("CHAMFER('CHAMFER',#3,(#91),#20,#70," + angle + ",#92)", "1.0471975").read();
  ASSERT_EQ(deep.features.size(), 3U) << all_diagnostics(deep);
  EXPECT_NEAR(deep.features[2].chamfer->depth, 0.8, 1e-9);
  const Part said = with_chamfer("CHAMFER('CHAMFER',#3,(#91),#20,#70," + angle + ",#92)").read();
  EXPECT_THAT(all_diagnostics(said),
              HasSubstr("is cut by a cone of 60 degrees between its flanks, and its tool has 90"));
}

TEST(StepNcChamfers, MayLieInAFaceThatIsThereBefore) {
  const std::string chamfer = "CHAMFER('CHAMFER',#3,(#91),#70,#20,0.785398163397,#92)";
  EXPECT_EQ(with_chamfer(chamfer).with(2, "WORKPLAN('MAIN',(#10,#12),$,#4,$)").read().features.size(), 2U);
}

TEST(StepNcChamfers, OfTaperedEndMillsThatDoNothingElseAreChamferMills) {
  Program p = with_chamfer("CHAMFER('CHAMFER',#3,(#91),#70,#20,0.785398163397,#92)");
  p.with(82, "TAPERED_ENDMILL(#83,2,.RIGHT.,$,$,0.785398163397)");
  p.with(83, "MILLING_TOOL_DIMENSION(1.,$,$,4.,0.,$,$)");
  const Part part = p.read();
  ASSERT_EQ(part.features.size(), 3U) << all_diagnostics(part);
  const Tool& tool = tool_of(part, part.workplan[2]);
  EXPECT_EQ(tool.kind, ToolKind::kChamferMill);
  EXPECT_EQ(tool.tip_diameter, 1);
  EXPECT_NEAR(tool.diameter, 9, 1e-6);
}

TEST(StepNcChamfers, ThatCannotBeLeaveTheirWorkingstepOut) {
  const std::string chamfer = "CHAMFER('CHAMFER',#3,(#91),#70,#20,0.785398163397,#92)";
  const auto said = [](const Program& program) { return all_diagnostics(program.read()); };
  EXPECT_THAT(said(with_chamfer(chamfer).with(82, "ENDMILL(#83,1,.RIGHT.,$,$)")),
              HasSubstr("a chamfer is cut by a cone"));
  EXPECT_THAT(said(with_chamfer(chamfer).with(92, "TOLERANCED_LENGTH_MEASURE(4.5,$)")),
              HasSubstr("deeper than the flanks of its tool are high, 4 mm"));
  EXPECT_THAT(said(with_chamfer("CHAMFER('C',#3,(#91),#70,#70,0.785398163397,#92)")),
              HasSubstr("no closed edge lies between"));
  EXPECT_THAT(said(with_chamfer("CHAMFER('C',#3,(#91),#70,#20,1.6,#92)")),
              HasSubstr("not between the two faces"));
  EXPECT_THAT(said(with_chamfer(chamfer).with(12, "MACHINING_WORKINGSTEP('C',#7,#20,#91,$)")),
              HasSubstr("a cone leaves no flat floor"));
}

TEST(StepNcChamfers, OfBossesRunAboutThem) {
  Program p = with_chamfer("CHAMFER('CHAMFER',#3,(#91),#77,#20,0.785398163397,#92)");
  p.feature("CLOSED_POCKET('POCKET',#3,(#30),#21,#23,(#77),$,#26,$,$,#27)");
  p.with(77, "BOSS('BOSS',#3,(),#78,#23,#79,$)").with(78, "AXIS2_PLACEMENT_3D('',#80,$,$)");
  p.with(80, "CARTESIAN_POINT('',(50.,40.,0.))").with(79, "CIRCULAR_CLOSED_PROFILE($,#93)");
  const Part part = p.with(93, "TOLERANCED_LENGTH_MEASURE(6.,$)").read();
  ASSERT_EQ(part.features.size(), 3U) << all_diagnostics(part);
  EXPECT_FALSE(part.features[2].chamfer->air_inside);
  EXPECT_NEAR(length(part.features[2].chamfer->line), 6 * kPi, 1e-6);
}

/// A slot of 60 mm along x at y 40, by the tool #31.
Program slot(const std::string& section, const std::string& end, const std::string& body,
             const std::string& size) {
  Program p;
  p.feature("SLOT('SLOT',#3,(#30),#21,#23,#70,#73,(#74,#74))").with(22, "CARTESIAN_POINT('',(20.,40.,0.))");
  p.with(70, "LINEAR_PATH($,#71,#72)").with(71, "TOLERANCED_LENGTH_MEASURE(60.,$)");
  p.with(72, "DIRECTION('',(1.,0.,0.))").with(73, section).with(74, end);
  p.with(75, "TOLERANCED_LENGTH_MEASURE(10.,$)");
  return p.with(32, body).with(33, size);
}

TEST(StepNcVees, AreCutByAConeOfTheirAngle) {
  const std::string vee = "VEE_PROFILE($,$,1.5707963,0.7853981)", end = "RADIUSED_SLOT_END_TYPE()";
  const std::string cone = "COUNTERSINK(#33,1,.RIGHT.,$,$,$)",
                    size = "MILLING_TOOL_DIMENSION(12.,1.5707963,$,10.,$,$,$)";
  const Part part = slot(vee, end, cone, size).read();
  ASSERT_EQ(part.features.size(), 1U);
  EXPECT_EQ(part.features[0].kind, FeatureKind::kEngraving);
  EXPECT_EQ(part.features[0].floor_z, -5);
  EXPECT_NEAR(length(part.features[0].profile->line), 60, 1e-9);
  EXPECT_THAT(slot(vee, end, "ENDMILL(#33,2,.RIGHT.,$,$)", size).error(),
              HasSubstr("a vee is cut by a cone"));
  EXPECT_THAT(slot(vee, end, cone, "MILLING_TOOL_DIMENSION(8.,1.5707963,$,10.,$,$,$)").error(),
              HasSubstr("deeper than the flanks of its tool are high, 4 mm"));
  EXPECT_THAT(slot(vee, end, cone, "MILLING_TOOL_DIMENSION(12.,2.,$,10.,$,$,$)").error(),
              HasSubstr("give another"));
  EXPECT_THAT(slot(vee, "FLAT_SLOT_END_TYPE($,$)", cone, size).error(), HasSubstr("its end is flat"));
  EXPECT_THAT(slot("VEE_PROFILE($,#75,1.5707963,$)", end, cone, size).error(), HasSubstr("a rounded point"));
  EXPECT_THAT(slot("VEE_PROFILE($,$,1.5707963,0.5)", end, cone, size).error(),
              HasSubstr("do not lean alike"));
}

TEST(StepNcCountersinks, WhoseTaperIsNotThatOfTheirToolAreNotFollowed) {
  const auto sunk = [](const std::string& narrow) {
    Program p;
    p.with(30, "COUNTER_SINKING($,$,'SINK',$,$,#31,#34,#35,$,$,$,$,$,$)");
    p.with(32, "COUNTERSINK(#33,1,.RIGHT.,$,$,$)")
        .with(33, "MILLING_TOOL_DIMENSION(20.,1.5707963,$,$,$,$,$)");
    p.feature("ROUND_HOLE('SINK',#3,(#30),#28,#23,#62,#70,#71)").with(71, "THROUGH_BOTTOM_CONDITION()");
    p.with(70, "DIAMETER_TAPER(#72)").with(72, "TOLERANCED_LENGTH_MEASURE(" + narrow + ",$)");
    p.with(25, "CARTESIAN_POINT('',(0.,0.,-2.))");
    return all_diagnostics(p.with(62, "TOLERANCED_LENGTH_MEASURE(16.,$)").read());
  };
  EXPECT_EQ(sunk("12.").find("leans by"), std::string::npos) << sunk("12.");
  EXPECT_THAT(sunk("14."), HasSubstr("the taper of SINK leans by 26.565 degrees"));
}

TEST(StepNcVees, LeanAlikeWhereNoTiltIsStatedInDegreesToo) {
  Program p = slot("VEE_PROFILE($,$,60.,$)", "RADIUSED_SLOT_END_TYPE()", "COUNTERSINK(#33,1,.RIGHT.,$,$,$)",
                   "MILLING_TOOL_DIMENSION(12.,60.,$,20.,$,$,$)");
  p.with(900, "(GLOBAL_UNIT_ASSIGNED_CONTEXT((#901))REPRESENTATION_CONTEXT('',''))");
  p.with(901, "(CONVERSION_BASED_UNIT('DEGREE',#902)NAMED_UNIT(*)PLANE_ANGLE_UNIT())");
  p.with(902, "PLANE_ANGLE_MEASURE_WITH_UNIT(PLANE_ANGLE_MEASURE(0.0174532925),#903)");
  const Part part = p.with(903, "(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))").read();
  ASSERT_EQ(part.features.size(), 1U) << all_diagnostics(part);
  EXPECT_EQ(part.features[0].floor_z, -5);
}

TEST(StepNcRoundedSlots, AreCutByABallOfTheirWidth) {
  const std::string round = "ROUNDED_U_PROFILE($,#75)", end = "RADIUSED_SLOT_END_TYPE()";
  const std::string ball = "BALL_ENDMILL(#33,2,.RIGHT.,$,$)",
                    size = "MILLING_TOOL_DIMENSION(10.,$,$,20.,5.,$,$)";
  const Part part = slot(round, end, ball, size).read();
  ASSERT_EQ(part.features.size(), 1U);
  EXPECT_EQ(part.features[0].kind, FeatureKind::kEngraving);
  EXPECT_EQ(part.features[0].floor_z, -5);
  EXPECT_THAT(all_diagnostics(part), ::testing::Not(HasSubstr("needs a ball")));
  EXPECT_THAT(
      slot(round, end, "ENDMILL(#33,2,.RIGHT.,$,$)", "MILLING_TOOL_DIMENSION(10.,$,$,20.,0.,$,$)").error(),
      HasSubstr("no deeper than its half-round section"));
  // Deeper ones are milled down to where the half-round begins; that the rest is left is a fault, until a ball makes it.
  Program deep = slot(round, end, "ENDMILL(#33,2,.RIGHT.,$,$)", "MILLING_TOOL_DIMENSION(10.,$,$,20.,0.,$,$)");
  deep.with(25, "CARTESIAN_POINT('',(0.,0.,-9.))");
  EXPECT_THAT(all_diagnostics(deep.read()), HasSubstr("needs a ball as wide as the slot"));
  deep.with(2, "WORKPLAN('MAIN',(#10,#11),$,#4,$)").with(11, "MACHINING_WORKINGSTEP('B',#7,#20,#80,$)");
  deep.with(80, "BOTTOM_AND_SIDE_FINISH_MILLING($,$,'B',$,$,#81,#34,#35,$,$,$,$,$,$,$,$)");
  deep.with(81, "MILLING_CUTTING_TOOL('T9',#82,(),$,$,$)").with(82, "BALL_ENDMILL(#83,2,.RIGHT.,$,$)");
  const Part both = deep.with(83, "MILLING_TOOL_DIMENSION(10.,$,$,20.,5.,$,$)").read();
  ASSERT_EQ(both.features.size(), 2U) << all_diagnostics(both);
  EXPECT_EQ(both.features[0].floor_z, -4);
  EXPECT_EQ(both.features[1].floor_z, -9);
}

TEST(StepNcSteps, WhoseWallsLeanAreDrafted) {
  const auto leaning = [](const std::string& profile) {
    Program p = testing::step(60, "0.,1.,0.");
    return p.feature("STEP('STEP',#3,(#30),#21,#23,#70,#74,())").with(74, profile);
  };
  EXPECT_NEAR(leaning("VEE_PROFILE($,$,2.0943951,2.0943951)").read().features[0].wall_slope.degrees(), 30,
              1e-4);
  EXPECT_EQ(leaning("VEE_PROFILE($,$,1.5707963,1.5707963)").read().features[0].wall_slope.degrees(), 0);
  EXPECT_THAT(leaning("VEE_PROFILE($,$,2.0943951,1.5707963)").error(), HasSubstr("its floor is not level"));
  EXPECT_THAT(leaning("VEE_PROFILE($,$,1.2,1.2)").error(), HasSubstr("overhang"));
}

}  // namespace
}  // namespace clearcut::read::stepnc
