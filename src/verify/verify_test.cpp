// The check on programs written by hand: figures, what is left, gouges.
#include "verify/verify.h"

#include <gtest/gtest.h>

#include <cmath>

#include "verify/test_findings.h"
#include "verify/test_program.h"

namespace clearcut::verify {
namespace {

using testing::circle_loop;
using testing::fault_of;
using testing::has;
using testing::island_part;
using testing::island_program;
using testing::kRings;
using testing::pocket_part;
using testing::rectangle;
using testing::report_of;
using testing::square_part;
using testing::square_program;
using testing::Writer;

TEST(Verify, ARightProgramIsClean) {
  const Findings findings = verify_program(square_part(), square_program(kRings), {});
  EXPECT_TRUE(findings.all.clean) << report_of(findings);
  EXPECT_LE(findings.all.uncut_thickness_mm, 0.005);
  EXPECT_EQ(findings.all.uncut_mm2, 0);
  EXPECT_LE(findings.all.gouge_mm, 1e-9);
  ASSERT_EQ(findings.features.size(), 1u);
  EXPECT_TRUE(findings.features[0].figures.clean);
  ASSERT_EQ(findings.features[0].layers.size(), 1u);
  EXPECT_EQ(findings.features[0].layers[0].z, -2);
  // Four corners of (1 - pi/4) R^2.
  EXPECT_NEAR(findings.all.unreachable_mm2, 4 * (1 - kPi / 4) * 9, 0.2);
  EXPECT_NEAR(findings.all.lower_bound_mm, (2500 - 4 * (1 - kPi / 4) * 9 - kPi * 9) / 6, 0.1);
}

TEST(Verify, FiguresAreThoseOfTheMoves) {
  const Findings findings = verify_program(square_part(), square_program(kRings), {});
  double rings = 0, links = 0;
  for (std::size_t i = 0; i < kRings.size(); ++i) {
    rings += 8 * kRings[i];
    if (i > 0) links += std::sqrt(2.0) * (kRings[i] - kRings[i - 1]);
  }
  EXPECT_NEAR(findings.all.feed_mm, rings + links + 3, 1e-9);
  EXPECT_NEAR(findings.all.plunge_mm, 3, 1e-12);
  EXPECT_EQ(findings.all.retracts, 0);
  // Three corners a ring, two turns at each link of 45 and 135 degrees.
  EXPECT_EQ(findings.all.turns, 6 * 3 + 5 * 2);
  EXPECT_NEAR(findings.all.turn_angle_deg, 6 * 270 + 5 * (45 + 135), 1e-6);
  EXPECT_EQ(findings.all.feed_mm, findings.features[0].figures.feed_mm);
  EXPECT_GT(findings.all.time_s, findings.all.time_naive_s);
}

/// A counterbore of 12 mm down to `step`, by a mill of 6, and on its floor a hole of `diameter` down to `floor`, by a drill of 5.
Findings drilled_under_a_counterbore(double diameter, double step, double floor) {
  Part part = pocket_part({Region::from_valid_loops(circle_loop({}, 6), {})}, 6, step);
  Tool drill;
  drill.kind = ToolKind::kDrill;
  drill.number = 2;
  drill.diameter = 5;
  drill.tip_angle = Radians::of_degrees(118);
  part.tools.push_back(drill);
  Feature hole = part.features[0];
  hole.name = "HOLE";
  hole.kind = FeatureKind::kRoundHole;
  hole.hole_diameter = diameter;
  hole.target = hole.allowed = {Region::from_valid_loops(circle_loop({}, diameter / 2), {})};
  hole.top_z = step;
  hole.floor_z = floor;
  part.features.push_back(hole);
  part.workplan.push_back(part.workplan[0]);
  part.workplan.back().name = "HOLE drill";
  part.workplan.back().feature = part.workplan.back().operation.tool = 1;
  Writer writer;
  writer.enter({-3, 0}, 0, step);
  writer.arc({3, 0}, {}, Turn::kCounterClockwise).arc({-3, 0}, {}, Turn::kCounterClockwise);
  writer.leave().tool_change(2).enter({}, step, floor);
  return verify_program(part, writer.done(), {});
}

/// A drill has its full width over its point alone, and what the counterbore clears says nothing of the hole under it.
TEST(Verify, HolesShallowerThanTheirDrillsPointAreNotWideEnough) {
  const double point = 2.5 / std::tan(59 * kPi / 180);
  for (const double floor : {-3.0, -0.6 - point}) {
    const Findings right = drilled_under_a_counterbore(5, -0.6, floor);
    EXPECT_TRUE(right.all.clean) << report_of(right);
    EXPECT_LT(right.all.unreachable_mm2, 0.01);
  }
  EXPECT_TRUE(has(drilled_under_a_counterbore(5, -0.6, -1.8), FaultKind::kUncut));
  EXPECT_TRUE(has(drilled_under_a_counterbore(7, -0.6, -1.8), FaultKind::kUncut));
  EXPECT_TRUE(has(drilled_under_a_counterbore(7, -0.6, -3), FaultKind::kUncut));
}

TEST(Verify, AMissingRingIsNamedWhereItWas) {
  std::vector<double> rings = kRings;
  rings.erase(rings.begin() + 2);  // the one at 11: leaves 9.5 .. 12.5
  const Findings findings = verify_program(square_part(), square_program(rings), {});
  EXPECT_FALSE(findings.all.clean);
  ASSERT_TRUE(has(findings, FaultKind::kUncut)) << report_of(findings);
  const Fault& fault = fault_of(findings, FaultKind::kUncut);
  const double from_center = std::max(std::abs(fault.at.point.x - 25), std::abs(fault.at.point.y - 25));
  EXPECT_GT(from_center, 9.4);
  EXPECT_LT(from_center, 12.6);
  // Four sides of 9.5 .. 12.5 less what the links cut; 3 wide, more in the corners.
  EXPECT_NEAR(findings.all.uncut_thickness_mm, 3 * std::sqrt(2.0), 0.7);
  EXPECT_GT(findings.all.uncut_mm2, 230);
  EXPECT_LT(findings.all.uncut_mm2, 265);
}

TEST(Verify, AMissingWallRingIsNamed) {
  std::vector<double> rings = kRings;
  rings.back() = 21.9;
  const Findings findings = verify_program(square_part(), square_program(rings), {});
  ASSERT_TRUE(has(findings, FaultKind::kUncut)) << report_of(findings);
  EXPECT_GE(findings.all.uncut_thickness_mm, 0.1 * std::sqrt(2.0));
  EXPECT_LE(findings.all.uncut_thickness_mm, 0.2 * std::sqrt(2.0) + 0.02);
}

TEST(Verify, AThinResidualWithinToleranceIsNoFault) {
  std::vector<double> rings = kRings;
  rings.back() = 22 - 0.004;
  const Findings findings = verify_program(square_part(), square_program(rings), {});
  EXPECT_FALSE(has(findings, FaultKind::kUncut)) << report_of(findings);
  EXPECT_GE(findings.all.uncut_thickness_mm, 0.004);
  EXPECT_LE(findings.all.uncut_thickness_mm, 0.01);
}

TEST(Verify, StepoverJustOverTheCuttersWidthLeavesARidge) {
  // Straight passes in an open field of view: a slot of 12.06 mm width in two passes of a 6 mm cutter.
  const auto checked = [](double gap) {
    Part part = pocket_part(rectangle(0, 0, 60, 12 + gap), 6, -2);
    Writer writer;
    writer.enter({3, 3}, 0, -2).feed({57, 3}).feed({57, 9 + gap}).feed({3, 9 + gap}).feed({3, 3});
    return verify_program(part, writer.done(), {});
  };
  EXPECT_TRUE(checked(0).all.clean) << report_of(checked(0));
  EXPECT_TRUE(checked(-0.06).all.clean);
  const Findings wide = checked(0.06);
  ASSERT_TRUE(has(wide, FaultKind::kUncut)) << report_of(wide);
  EXPECT_NEAR(wide.all.uncut_thickness_mm, 0.06, 0.016);
  EXPECT_NEAR(wide.all.uncut_mm2, 48 * 0.06, 0.8);
  EXPECT_NEAR(fault_of(wide, FaultKind::kUncut).at.point.y, 6.03, 0.03);
}

TEST(Verify, AShiftedProgramGougesAndLeaves) {
  const Findings findings = verify_program(square_part(), square_program(kRings, -2, {25.5, 25}), {});
  ASSERT_TRUE(has(findings, FaultKind::kGouge)) << report_of(findings);
  const Fault& fault = fault_of(findings, FaultKind::kGouge);
  EXPECT_NEAR(fault.size, 0.5, 1e-9);
  EXPECT_NEAR(fault.at.point.x, 47.5, 1e-9);
  EXPECT_EQ(fault.at.z, -2);
  EXPECT_GT(fault.at.line, 0);
  EXPECT_NEAR(findings.all.uncut_thickness_mm, 0.5 * std::sqrt(2.0), 0.3);
}

TEST(Verify, AGougeOfFiveMicrometresIsFoundAndHalfAMicrometreIsNot) {
  std::vector<double> rings = kRings;
  rings.back() = 22.005;
  const Findings deep = verify_program(square_part(), square_program(rings), {});
  ASSERT_TRUE(has(deep, FaultKind::kGouge));
  EXPECT_NEAR(deep.all.gouge_mm, 0.005, 1e-9);
  rings.back() = 22.0005;
  const Findings rounding = verify_program(square_part(), square_program(rings), {});
  EXPECT_TRUE(rounding.all.clean) << report_of(rounding);
  EXPECT_NEAR(rounding.all.gouge_mm, 0.0005, 1e-9);
}

TEST(Verify, AFloorCutTooDeepIsAGouge) {
  const Findings findings = verify_program(square_part(), square_program(kRings, -2.01), {});
  ASSERT_TRUE(has(findings, FaultKind::kGouge)) << report_of(findings);
  EXPECT_NEAR(findings.all.gouge_mm, 0.01, 1e-9);
  EXPECT_NE(fault_of(findings, FaultKind::kGouge).text.find("below"), std::string::npos);
}

TEST(Verify, AFloorNotReachedIsNothingCut) {
  const Findings findings = verify_program(square_part(), square_program(kRings, -1.9), {});
  EXPECT_TRUE(has(findings, FaultKind::kNothingCut)) << report_of(findings);
  EXPECT_NEAR(findings.all.uncut_mm2, 2500 - 4 * (1 - kPi / 4) * 9, 2);
  EXPECT_NE(fault_of(findings, FaultKind::kNothingCut)
                .text.find("the deepest feed move there ends at z -1.9, line"),
            std::string::npos)
      << report_of(findings);
}

TEST(Verify, ARunOfFaultsIsNamedByItsLines) {
  const Findings deep = verify_program(square_part(), square_program({2}, -2.01), {});
  const std::string text = fault_of(deep, FaultKind::kGouge).text;
  EXPECT_NE(text.find("6 successive moves do so, lines 3 to 8."), std::string::npos) << text;
  Writer still;
  still.enter({10, 10}, 0, -2).feed({12, 10}, -2, 0).feed({40, 10}, -2, 0);
  const Fault slow = fault_of(verify_program(square_part(), still.done(), {}), FaultKind::kNoFeed);
  EXPECT_EQ(slow.at.line, 4) << "the first, not the longest";
}

TEST(Verify, ACutterThatDoesNotFitIsSaid) {
  const Part part = pocket_part(rectangle(0, 0, 50, 5), 6, -2);
  const Findings findings = verify_program(part, Writer().done(), {});
  ASSERT_TRUE(has(findings, FaultKind::kNothingCut)) << report_of(findings);
  EXPECT_NE(fault_of(findings, FaultKind::kNothingCut).text.find("fits"), std::string::npos);
  EXPECT_EQ(findings.all.uncut_mm2, 0);
}

TEST(Verify, ASlotAsWideAsTheCutterIsCutByOnePass) {
  for (const double width : {6.0, 6.0 - 0.0009, 6.0 + 0.0009}) {
    const Part part = pocket_part(rectangle(0, 0, 50, width), 6, -2);
    Writer writer;
    writer.enter({3, width / 2}, 0, -2).feed({47, width / 2});
    const Findings findings = verify_program(part, writer.done(), {});
    EXPECT_TRUE(findings.all.clean) << width << "\n" << report_of(findings);
    EXPECT_NEAR(findings.all.unreachable_mm2, 2 * 2 * (1 - kPi / 4) * 9, 0.3) << width;
    Writer half;
    half.enter({3, width / 2}, 0, -2).feed({40, width / 2});
    EXPECT_TRUE(has(verify_program(part, half.done(), {}), FaultKind::kUncut)) << width;
  }
}

/// A ring with `teeth` slots that are too narrow for a 6 mm cutter: most of the outline is out of reach.
Region gear(int teeth) {
  Loop outer;
  const double step = 2 * kPi / teeth, slot = step / 2;
  for (int i = 0; i < teeth; ++i) {
    const double a = i * step;
    const Vec2 root = direction_of(a) * 20, tip = direction_of(a) * 32;
    const Vec2 end_tip = direction_of(a + slot) * 32, end_root = direction_of(a + slot) * 20;
    outer.push_back(Edge::line(root, tip));
    outer.push_back(Edge::arc(tip, end_tip, {}, Turn::kCounterClockwise));
    outer.push_back(Edge::line(end_tip, end_root));
    outer.push_back(
        Edge::arc(end_root, direction_of((i + 1) % teeth * step) * 20, {}, Turn::kCounterClockwise));
  }
  return Region::from_valid_loops(outer, {circle_loop({0, 0}, 8)});
}

TEST(Verify, WhatIsOutOfReachIsMeasuredByItsOutline) {
  const int teeth = 40;  // 1.6 mm wide
  const Part part = pocket_part({gear(teeth)}, 6, -2);
  Writer writer;
  writer.enter({11, 0}, 0, -2);
  for (const double r : {11.0, 15.0, 17.0}) {
    writer.feed({r, 0}).arc({-r, 0}, {}, Turn::kCounterClockwise).arc({r, 0}, {}, Turn::kCounterClockwise);
  }
  const Findings findings = verify_program(part, writer.done(), {});
  EXPECT_FALSE(has(findings, FaultKind::kNothingCut)) << report_of(findings);
  const double slots = kPi * (32 * 32 - 20 * 20) / 2;
  EXPECT_NEAR(findings.all.unreachable_mm2, slots, 0.02 * slots);
}

/// Walls that are arcs of 1 to 10 000 m, as arcs fitted to a drawing's straight lines are.
TEST(Verify, NearlyStraightArcsAreCheckedAsLines) {
  for (const double radius : {1e3, 9.8e4, 1e6, 1e7}) {
    for (const double side : {1.0, -1.0}) {
      const double bulge = side * 50 / 4 / radius;
      const BulgeVertex outline[] = {{{0, 0}, bulge}, {{48, 14}, 0}, {{34, 62}, bulge}, {{-14, 48}, bulge}};
      const Part part = pocket_part({Region::from_valid_loops(loop_from_bulges(outline), {})}, 6, -2);
      const auto at = [](double u, double v) { return Vec2{48, 14} * (u / 50) + Vec2{-14, 48} * (v / 50); };
      Writer writer;
      writer.enter(at(25, 25), 0, -2);
      const double bow = std::max(0.0, -side) * 50 * 50 / 8 / radius;
      const auto ring = [&](double left) {
        writer.feed(at(left, left)).feed(at(50 - left, left)).feed(at(50 - left, 50 - left));
        writer.feed(at(left, 50 - left)).feed(at(left, left));
      };
      for (const double left : {22.0, 17.5, 13.0, 8.5, 5.0, 4.0, 3.0 + bow}) ring(left);
      const Findings findings = verify_program(part, writer.done(), {});
      EXPECT_LE(findings.all.uncut_thickness_mm, std::abs(bulge) * 100 + 0.01) << report_of(findings);
      // Bows turn the corners by 50 / radius.
      EXPECT_NEAR(findings.all.unreachable_mm2, 4 * (1 - kPi / 4) * 9, 0.6 + 2000 / radius) << radius;
      if (radius > 1e5) {
        EXPECT_TRUE(findings.all.clean) << radius << report_of(findings);
      }
    }
  }
}

TEST(Verify, TravelFeedAndToolAreChecked) {
  VerifyOptions options;
  options.machine.travel = {{{0, 40}, {0, 50}, {-10, 20}}};
  EXPECT_TRUE(has(verify_program(square_part(), square_program(kRings), options), FaultKind::kOutsideTravel));
  Writer still;
  still.enter({10, 10}, 0, -2).feed({20, 10}, -2, 0);
  EXPECT_TRUE(has(verify_program(square_part(), still.done(), {}), FaultKind::kNoFeed));
  Writer other(7);
  other.enter({10, 10}, 0, -2).feed({20, 10});
  EXPECT_TRUE(has(verify_program(square_part(), other.done(), {}), FaultKind::kWrongTool));
  Writer none(0);
  none.enter({10, 10}, 0, -2).feed({20, 10});
  Part two = square_part();
  two.tools.push_back(two.tools[0]);
  two.tools[1].number = 2;
  const std::string text = fault_of(verify_program(two, none.done(), {}), FaultKind::kWrongTool).text;
  EXPECT_NE(text.find("add a T word"), std::string::npos) << text;
}

TEST(Verify, AnEmptyProgramIsNotClean) {
  const Findings findings = verify_program(square_part(), Toolpath{}, {});
  EXPECT_FALSE(findings.all.clean);
  EXPECT_TRUE(has(findings, FaultKind::kNothingCut));
}

TEST(Verify, ThreadsDoNotChangeTheResult) {
  VerifyOptions one, four;
  four.threads = 4;
  const Findings a = verify_program(island_part(), island_program(15), one),
                 b = verify_program(island_part(), island_program(15), four);
  EXPECT_EQ(a.all.uncut_thickness_mm, b.all.uncut_thickness_mm);
  EXPECT_EQ(a.all.unreachable_mm2, b.all.unreachable_mm2);
  EXPECT_EQ(a.all.engagement.mean_deg, b.all.engagement.mean_deg);
}

TEST(Verify, TheRoundThatEndsAHelixIsPartOfTheEntry) {
  const Vec2 c{25, 25};
  Writer writer;
  writer.rapid(c + Vec2{2, 0}, 10).rapid(c + Vec2{2, 0}, 0.5);
  for (const double z : {0.0, -1.0, -2.0})
    writer.helix(c - Vec2{2, 0}, c, z + 0.5).helix(c + Vec2{2, 0}, c, z);
  writer.helix(c - Vec2{2, 0}, c, -2).helix(c + Vec2{2, 0}, c, -2);
  const Findings round = verify_program(square_part(), writer.done(), {});
  EXPECT_EQ(round.all.engagement.max_deg, 0);
  EXPECT_EQ(round.all.air_cut_mm, 0);
  writer.rapid(c + Vec2{2, 0}, -2).helix(c - Vec2{8, 0}, c - Vec2{3, 0}, -2);
  EXPECT_GT(verify_program(square_part(), writer.done(), {}).all.engagement.max_deg, 60);
}

TEST(Verify, EngagementOfStraightPasses) {
  const Part part = pocket_part(rectangle(0, 0, 200, 50), 10, -2);
  Writer writer;
  writer.enter({20, 20}, 0, -2)
      .feed({180, 20})
      .rapid({180, 20}, 10)
      .rapid({20, 22.6}, 10)
      .rapid({20, 22.6}, 1);
  writer.feed({20, 22.6}, -2).feed({180, 22.6});
  VerifyOptions options;
  options.engagement_limit_deg = 100;
  const Engagement engagement = verify_program(part, writer.done(), options).all.engagement;
  EXPECT_NEAR(engagement.max_deg, 180, 1);
  EXPECT_NEAR(engagement.histogram_mm[6], 160, 3);  // acos(1 - 2.6 / 5) = 61.3 degrees, less at both ends
  EXPECT_NEAR(engagement.histogram_mm[17], 160, 0.5);
  EXPECT_NEAR(engagement.over_limit_mm, 160, 0.5);
  EXPECT_NEAR(engagement.mean_deg, (180 + 61.3) / 2, 1);
  EXPECT_NEAR(engagement.conventional_mm, 160 + 80,
              0.5);  // fresh material on the left; the slot is half of each
  EXPECT_NEAR(engagement.climb_mm, 80, 3);
}

}  // namespace
}  // namespace clearcut::verify
