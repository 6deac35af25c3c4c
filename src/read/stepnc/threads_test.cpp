// Threads: what a tap makes in a drilled hole, and what is said where that cannot be.
#include "read/stepnc/test_program.h"

namespace clearcut::read::stepnc::testing {
namespace {

/// A hole of 5 mm, 16 mm deep, drilled by T1, then a thread M6 x 1, 10 mm deep, tapped by T2.
Program tapped() {
  Program p;
  p.with(2, "WORKPLAN('MAIN',(#10,#11),$,#4,$)");
  p.with(20, "ROUND_HOLE('HOLE',#3,(#30),#21,#23,#40,$,#41)").with(25, "CARTESIAN_POINT('',(0.,0.,-16.))");
  p.with(40, "TOLERANCED_LENGTH_MEASURE(5.,$)").with(41, "FLAT_HOLE_BOTTOM()");
  p.with(22, "CARTESIAN_POINT('',(30.,40.,0.))");
  p.with(30, "DRILLING($,$,'DRILL',$,$,#31,#34,#35,$,$,$,$,$,$)").with(32, "TWIST_DRILL(#33,2,.RIGHT.,$,$)");
  p.with(33, "MILLING_TOOL_DIMENSION(5.,$,$,40.,$,$,$)").with(31, "MILLING_CUTTING_TOOL('T1',#32,(),$,$,$)");
  p.with(11, "MACHINING_WORKINGSTEP('WS2',#7,#50,#51,$)");
  p.with(50, "CATALOGUE_THREAD('THREAD',#3,(#51),#21,#53,#54,(#20),.T.,$,#55,#56,6.,#57,#58,$)");
  p.with(53, "PLANE('',#59)")
      .with(59, "AXIS2_PLACEMENT_3D('',#64,$,$)")
      .with(64, "CARTESIAN_POINT('',(0.,0.,-10.))");
  p.with(54, "PARTIAL_AREA_DEFINITION(10.,#21,$)").with(55, "DESCRIPTIVE_PARAMETER('fit class','6H')");
  p.with(56, "DESCRIPTIVE_PARAMETER('form','METRIC')").with(57, "NUMERIC_PARAMETER('pitch',1.,'MM')");
  p.with(58, "DESCRIPTIVE_PARAMETER('hand','RIGHT')");
  p.with(51, "TAPPING($,$,'TAP',$,$,#65,#66,#35,$,$,$,$,$,$,.F.)");
  p.with(65, "MILLING_CUTTING_TOOL('T2',#67,(),$,$,$)").with(67, "TAP(#68,3,.RIGHT.,$,$)");
  p.with(68, "MILLING_TOOL_DIMENSION(6.,$,$,25.,$,$,$)");
  return p.with(66, "MILLING_TECHNOLOGY(0.0083333333,.TCP.,$,-8.3333333,$,$,$,$,$)");
}

TEST(StepNcThreads, AThreadIsTappedInItsHole) {
  const Part part = tapped().read();
  ASSERT_EQ(part.workplan.size(), 2U) << all_diagnostics(part);
  const Feature& thread = feature_of(part, part.workplan[1]);
  ASSERT_TRUE(thread.hole.has_value());
  EXPECT_EQ(thread.hole->kind, HoleKind::kTapped);
  EXPECT_EQ(thread.hole->thread->pitch, 1);
  EXPECT_EQ(thread.hole->center, (Vec2{30, 40}));
  EXPECT_EQ(thread.hole->full_z, -10);
  const Tool& tap = tool_of(part, part.workplan[1]);
  EXPECT_EQ(tap.kind, ToolKind::kTap);
  EXPECT_EQ(tap.pitch, 1);
  EXPECT_EQ(all_diagnostics(part).find("no operation makes the hole"), std::string::npos);
}

TEST(StepNcThreads, WithoutAThreadThePitchFollowsFromFeedAndSpeed) {
  Program p = tapped();
  p.with(11, "MACHINING_WORKINGSTEP('WS2',#7,#20,#51,$)");
  p.with(51, "TAPPING($,$,'TAP',$,$,#65,#66,#35,$,10.,$,$,$,$,.F.)");
  const Part part = p.read();
  ASSERT_EQ(part.workplan.size(), 2U) << all_diagnostics(part);
  EXPECT_EQ(feature_of(part, part.workplan[1]).hole->thread->pitch, 1);
  EXPECT_NE(all_diagnostics(part).find("the thread follows from feed and speed: M6x1"), std::string::npos);
}

TEST(StepNcThreads, TheHandOfTheTapIsThatOfTheThread) {
  Program p = tapped();
  const std::string left_tap = "TAP(#68,3,.LEFT.,$,$)", left = "DESCRIPTIVE_PARAMETER('hand','left')";
  EXPECT_NE(all_diagnostics(p.with(67, left_tap).read()).find("its tap is left-handed"), std::string::npos);
  const Part both = p.with(58, left).read();
  ASSERT_EQ(both.workplan.size(), 2U) << all_diagnostics(both);
  EXPECT_TRUE(tool_of(both, both.workplan[1]).left_hand);
  p.with(67, "TAP(#68,3,.RIGHT.,$,$)");
  EXPECT_NE(all_diagnostics(p.read()).find("its tap is right-handed (hand_of_cut), and the thread left"),
            std::string::npos);
  EXPECT_EQ(p.with(67, "TAP(#68,3,$,$,$)").read().workplan.size(), 2U);
}

TEST(StepNcThreads, HandsThatAreNeitherLeftNorRightAreNamed) {
  Program p = tapped();
  p.with(58, "DESCRIPTIVE_PARAMETER('hand','OTHER')");
  EXPECT_NE(all_diagnostics(p.read()).find("its thread_hand 'OTHER' is neither LEFT nor RIGHT"),
            std::string::npos);
}

TEST(StepNcThreads, ALeftHandedTapCutsTheThreadOfItsFeedLeftHanded) {
  Program p = tapped();
  p.with(11, "MACHINING_WORKINGSTEP('WS2',#7,#20,#51,$)").with(67, "TAP(#68,3,.LEFT.,$,$)");
  p.with(51, "TAPPING($,$,'TAP',$,$,#65,#66,#35,$,10.,$,$,$,$,.F.)");
  const Part part = p.read();
  ASSERT_EQ(part.workplan.size(), 2U) << all_diagnostics(part);
  EXPECT_TRUE(tool_of(part, part.workplan[1]).left_hand);
  EXPECT_NE(all_diagnostics(part).find("M6x1LH"), std::string::npos);
}

TEST(StepNcThreads, ACoreThatIsTooShallowForTheLeadIsNamed) {
  Program p = tapped();
  p.with(25, "CARTESIAN_POINT('',(0.,0.,-12.))");
  const std::string all = all_diagnostics(p.read());
  EXPECT_NE(all.find("comes a hole of 4.92 to 5.1"), std::string::npos) << all;
  EXPECT_NE(all.find("down to 13 mm below its top"), std::string::npos) << all;
}

TEST(StepNcThreads, WhatNoTapMakesIsNamed) {
  Program p = tapped();
  p.with(68, "MILLING_TOOL_DIMENSION(8.,$,$,25.,$,$,$)");
  EXPECT_NE(all_diagnostics(p.read()).find("the tap has 8 mm and the thread 6 mm"), std::string::npos);
  p = tapped();
  p.with(51, "THREAD_DRILLING($,$,'TAP',$,$,#65,#66,#35,$,$,$,$,$,$,.F.)");
  EXPECT_NE(all_diagnostics(p.read()).find("give DRILLING and TAPPING"), std::string::npos);
  p = tapped();
  p.with(67, "TWIST_DRILL(#68,3,.RIGHT.,$,$)");
  EXPECT_NE(all_diagnostics(p.read()).find("tapping needs a TAP"), std::string::npos);
  p = tapped();
  p.with(56, "DESCRIPTIVE_PARAMETER('form','TRAPEZOIDAL')");
  EXPECT_NE(all_diagnostics(p.read()).find("threads of 60 degrees are cut"), std::string::npos);
}

}  // namespace
}  // namespace clearcut::read::stepnc::testing
