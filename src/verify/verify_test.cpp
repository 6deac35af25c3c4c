#include "verify/verify.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "verify/test_program.h"

namespace clearcut::verify {
namespace {

using testing::circle_loop;
using testing::cut_square_rings;
using testing::pocket_part;
using testing::rectangle;
using testing::Writer;

std::string report_of(const Findings& findings) {
  std::string text;
  for (const Fault& fault : findings.faults)
    text += std::string(name_of(fault.kind)) + ": " + fault.text + "\n";
  return text;
}

bool has(const Findings& findings, FaultKind kind) {
  for (const Fault& fault : findings.faults) {
    if (fault.kind == kind) return true;
  }
  return false;
}

const Fault& fault_of(const Findings& findings, FaultKind kind) {
  for (const Fault& fault : findings.faults) {
    if (fault.kind == kind) return fault;
  }
  throw std::runtime_error("no such fault");
}

/// The square pocket 0..50, 2 mm deep, in rings for a 6 mm cutter: half widths of the rings about (25, 25).
const std::vector<double> kRings{2, 6.5, 11, 15.5, 19.5, 22};

Part square_part() {
  return pocket_part(rectangle(0, 0, 50, 50), 6, -2);
}

Toolpath square_program(const std::vector<double>& rings, double z = -2, Vec2 center = {25, 25}) {
  Writer writer;
  cut_square_rings(writer, center, rings, 0, z);
  return writer.done();
}

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

TEST(Verify, AThinFilmWithinToleranceIsNoFault) {
  std::vector<double> rings = kRings;
  rings.back() = 22 - 0.004;
  const Findings findings = verify_program(square_part(), square_program(rings), {});
  EXPECT_FALSE(has(findings, FaultKind::kUncut)) << report_of(findings);
  EXPECT_GE(findings.all.uncut_thickness_mm, 0.004);
  EXPECT_LE(findings.all.uncut_thickness_mm, 0.01);
}

TEST(Verify, StepoverJustOverTheCuttersWidthLeavesARidge) {
  // Straight passes in an open field of view: a slot of 12.06 mm width in two passes of a 6 mm cutter.
  const auto judged = [](double gap) {
    Part part = pocket_part(rectangle(0, 0, 60, 12 + gap), 6, -2);
    Writer writer;
    writer.enter({3, 3}, 0, -2).feed({57, 3}).feed({57, 9 + gap}).feed({3, 9 + gap}).feed({3, 3});
    return verify_program(part, writer.done(), {});
  };
  EXPECT_TRUE(judged(0).all.clean) << report_of(judged(0));
  EXPECT_TRUE(judged(-0.06).all.clean);
  const Findings wide = judged(0.06);
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
TEST(Verify, NearlyStraightArcsAreJudgedAsLines) {
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

/// A slot through the whole stock, 10 mm wide at the top, its walls 1 mm nearer at the floor.
Part leaning_slot() {
  Part part = pocket_part(rectangle(0, 15, 60, 25), 6, -4);
  part.stock = Stock{{{0, 0}, {60, 40}}, -20, 0};
  const Region around = rectangle(-1000, -1000, 1060, 1040)[0];
  Feature& slot = part.features[0];
  slot.kind = FeatureKind::kSlot;
  slot.wall_slope = Radians::of(std::atan(0.25));
  slot.allowed = {Region::from_valid_loops(
      around.outer(), {rectangle(0, 0, 60, 15)[0].outer(), rectangle(0, 25, 60, 40)[0].outer()})};
  return part;
}

Toolpath slot_program(double low, double high, std::optional<double> across = {}) {
  Writer writer;
  writer.enter({-4, low}, 0, -4).feed({64, low}).feed({64, high}).feed({-4, high});
  if (across) writer.feed({*across, high}).feed({*across, 45}).feed({*across, -5});
  return writer.done();
}

TEST(Verify, LeaningWallsEndAtTheSideOfTheStock) {
  const Part part = leaning_slot();
  const Findings right = verify_program(part, slot_program(19, 21), {});
  EXPECT_TRUE(right.all.clean) << report_of(right);
  EXPECT_LE(right.all.unreachable_mm2, 0.1);
  // What leans ends with the stock: beside it a cutter may pass as near as beside an upright side.
  EXPECT_TRUE(verify_program(part, slot_program(19, 21, -3), {}).all.clean);
  EXPECT_NEAR(verify_program(part, slot_program(19, 21, -2.99), {}).all.gouge_mm, 0.01, 1e-9);
  EXPECT_NEAR(verify_program(part, slot_program(18.99, 21), {}).all.gouge_mm, 0.01, 1e-9);
  EXPECT_TRUE(has(verify_program(part, slot_program(19.02, 21), {}), FaultKind::kUncut));
}

TEST(Verify, AHoleOfTheCuttersSizeIsCutByAPlunge) {
  const std::vector<Vec2> turned{{3, -4}, {11, 2}, {5, 10}, {-3, 4}};
  const Regions holes[] = {rectangle(0, 0, 10, 10),
                           {Region::from_valid_loops(circle_loop({5, 5}, 5), {})},
                           {Region::from_valid_loops(circle_loop({5, 5}, 4.9998), {})},
                           {Region::from_valid_loops(loop_from_points(turned), {})}};
  for (const Regions& hole : holes) {
    const Part part = pocket_part(hole, 10, -4);
    const Vec2 center = box(hole).center();
    Writer writer;
    writer.enter(center, 0, -4);
    const Findings findings = verify_program(part, writer.done(), {});
    EXPECT_TRUE(findings.all.clean) << report_of(findings);
    Writer shallow;
    shallow.enter(center, 0, -3.97);
    EXPECT_FALSE(verify_program(part, shallow.done(), {}).all.clean);
    Writer beside;
    beside.enter(center + Vec2{0.0021, 0}, 0, -4);
    EXPECT_TRUE(has(verify_program(part, beside.done(), {}), FaultKind::kGouge));
  }
}

TEST(Verify, AHoleOfTheCuttersSizeAtTheEndOfASlotIsAskedFor) {
  const double h = 2, x = std::sqrt(25 - h * h), sweep = 2 * kPi - 2 * std::asin(h / 5);
  const double x2 = 30 - std::sqrt(64 - h * h), sweep2 = 2 * kPi - 2 * std::asin(h / 8);
  const BulgeVertex outline[] = {
      {{x, h}, std::tan(sweep / 4)}, {{x, -h}, 0}, {{x2, -h}, std::tan(sweep2 / 4)}, {{x2, h}, 0}};
  const Part part = pocket_part({Region::from_valid_loops(loop_from_bulges(outline), {})}, 10, -4);
  const auto program = [&](bool both) {
    Writer writer;
    // The mouth of the slot lets the cutter in a little.
    writer.enter({33, 0}, 0, -4).arc({27, 0}, {30, 0}, Turn::kCounterClockwise);
    writer.feed({x2 + std::sqrt(25 - h * h), 0}).feed({27, 0});
    writer.arc({33, 0}, {30, 0}, Turn::kCounterClockwise);
    if (both) writer.leave().enter({0, 0}, 0, -4);
    return writer.done();
  };
  const Findings whole = verify_program(part, program(true), {});
  EXPECT_TRUE(whole.all.clean) << report_of(whole);
  EXPECT_TRUE(has(verify_program(part, program(false), {}), FaultKind::kUncut));
}

TEST(Verify, ADrilledHoleIsCutByAPlunge) {
  Part part = pocket_part({Region::from_valid_loops(circle_loop({10, 10}, 4), {})}, 8, -5);
  Writer writer;
  writer.enter({10, 10}, 0, -5);
  const Findings findings = verify_program(part, writer.done(), {});
  EXPECT_TRUE(findings.all.clean) << report_of(findings);
  EXPECT_NEAR(findings.all.unreachable_mm2, 0, 0.05);
}

TEST(Verify, ACircularPocketCutInCirclesIsClean) {
  const Vec2 c{30, 30};
  Part part = pocket_part({Region::from_valid_loops(circle_loop(c, 20), {})}, 10, -3);
  Writer writer;
  bool down = false;
  for (const double r : {4.0, 8.0, 12.0, 15.0}) {
    if (!down) writer.enter(c + Vec2{r, 0}, 0, -3);
    down = true;
    writer.feed(c + Vec2{r, 0});
    writer.arc(c - Vec2{r, 0}, c, Turn::kCounterClockwise).arc(c + Vec2{r, 0}, c, Turn::kCounterClockwise);
  }
  const Findings findings = verify_program(part, writer.done(), {});
  EXPECT_TRUE(findings.all.clean) << report_of(findings);
  EXPECT_NEAR(findings.all.unreachable_mm2, 0, 0.2);
  EXPECT_LE(findings.all.uncut_thickness_mm, 0.005);
}

Part island_part() {
  const Regions outer = rectangle(0, 0, 60, 60);
  const Regions outline{Region::from_valid_loops(outer[0].outer(), {circle_loop({30, 30}, 10)})};
  return pocket_part(outline, 10, -2);
}

Toolpath island_program(double ring) {
  Writer writer;
  const Vec2 c{30, 30};
  writer.enter({5, 5}, 0, -2).feed({55, 5}).feed({55, 55}).feed({5, 55}).feed({5, 5});
  writer.feed({9, 9}).feed({51, 9}).feed({51, 51}).feed({9, 51}).feed({9, 9});
  for (const double r : {23.0, 19.0, ring}) {
    writer.feed(c + Vec2{-r, 0});
    writer.arc(c + Vec2{r, 0}, c, Turn::kCounterClockwise).arc(c - Vec2{r, 0}, c, Turn::kCounterClockwise);
  }
  return writer.done();
}

TEST(Verify, AnIslandIsLeftStanding) {
  const Findings findings = verify_program(island_part(), island_program(15), {});
  EXPECT_TRUE(findings.all.clean) << report_of(findings);
}

TEST(Verify, AnIslandCutByFiveMicrometresIsNamed) {
  const Findings findings = verify_program(island_part(), island_program(14.995), {});
  ASSERT_TRUE(has(findings, FaultKind::kGouge));
  EXPECT_NEAR(findings.all.gouge_mm, 0.005, 1e-9);
  EXPECT_NEAR(distance(fault_of(findings, FaultKind::kGouge).at.point, {30, 30}), 14.995, 1e-6);
}

TEST(Verify, AMoveAcrossAnIslandIsNamed) {
  Writer writer;
  writer.enter({5, 30}, 0, -2).feed({55, 30});
  const Findings findings = verify_program(island_part(), writer.done(), {});
  ASSERT_TRUE(has(findings, FaultKind::kGouge));
  EXPECT_GE(findings.all.gouge_mm,
            2 - 1e-9);  // the island is 2 mm high: lifting that much would have spared it
}

TEST(Verify, ARapidThroughStockIsNamed) {
  Writer writer;
  cut_square_rings(writer, {25, 25}, {2, 6.5}, 0, -2);
  writer.rapid({40, 25}, -2);
  const int line = writer.line();
  const Findings findings = verify_program(square_part(), writer.done(), {});
  ASSERT_TRUE(has(findings, FaultKind::kRapidInMaterial));
  EXPECT_EQ(fault_of(findings, FaultKind::kRapidInMaterial).at.line, line);
  EXPECT_EQ(findings.all.rapid_in_material, 2);  // and the way up from where it ended
}

TEST(Verify, ARapidDownIntoStockIsNamed) {
  Writer writer;
  writer.rapid({25, 25}, 10).rapid({25, 25}, -0.5);
  const int line = writer.line();
  writer.feed({25, 25}, -2).feed({30, 25});
  const Findings findings = verify_program(square_part(), writer.done(), {});
  ASSERT_TRUE(has(findings, FaultKind::kRapidInMaterial));
  EXPECT_EQ(fault_of(findings, FaultKind::kRapidInMaterial).at.line, line);
}

TEST(Verify, RapidsInWhatIsClearedAreFine) {
  Writer writer;
  cut_square_rings(writer, {25, 25}, kRings, 0, -2);
  writer.rapid({25, 25}, -2).rapid({25, 25}, 10).rapid({10, 10}, 10).rapid({10, 10}, -2);
  const Findings findings = verify_program(square_part(), writer.done(), {});
  EXPECT_TRUE(findings.all.clean) << report_of(findings);
  EXPECT_EQ(findings.all.rapid_in_material, 0);
}

TEST(Verify, ARapidThatBrushesUncutStockByFiveMicrometresIsNamed) {
  const auto judged = [](double y) {
    Writer writer;
    writer.enter({10, 25}, 0, -2).feed({40, 25});
    writer.rapid({10, y}, -2);
    return verify_program(square_part(), writer.done(), {});
  };
  EXPECT_FALSE(has(judged(25), FaultKind::kRapidInMaterial));
  EXPECT_FALSE(has(judged(25.0005), FaultKind::kRapidInMaterial));
  EXPECT_TRUE(has(judged(25.005), FaultKind::kRapidInMaterial));
}

TEST(Verify, AMissingLevelIsTooDeep) {
  Part part = pocket_part(rectangle(0, 0, 50, 50), 6, -6);
  part.workplan[0].operation.stepdown = 2;
  const auto program = [](const std::vector<double>& levels) {
    Writer writer;
    double top = 0;
    for (const double z : levels) {
      cut_square_rings(writer, {25, 25}, kRings, top, z);
      top = z;
    }
    return writer.done();
  };
  const Findings right = verify_program(part, program({-2, -4, -6}), {});
  EXPECT_TRUE(right.all.clean) << report_of(right);
  EXPECT_NEAR(right.all.max_axial_mm, 2, 1e-6);
  ASSERT_EQ(right.features[0].layers.size(), 3u);
  EXPECT_GT(right.features[0].layers[1].figures.feed_mm, 600);
  const Findings wrong = verify_program(part, program({-2, -6}), {});
  ASSERT_TRUE(has(wrong, FaultKind::kTooDeep)) << report_of(wrong);
  EXPECT_NEAR(fault_of(wrong, FaultKind::kTooDeep).size, 4, 1e-6);
  EXPECT_EQ(fault_of(wrong, FaultKind::kTooDeep).at.z, -6);
}

TEST(Verify, AnAllowanceOnTheWallIsLeft) {
  Part part = square_part();
  part.workplan[0].operation.allowance_side = 0.5;
  std::vector<double> rings = kRings;
  rings.back() = 21.5;
  const Findings findings = verify_program(part, square_program(rings), {});
  EXPECT_TRUE(findings.all.clean) << report_of(findings);
  EXPECT_NEAR(findings.all.unreachable_mm2, 4 * (1 - kPi / 4) * 9, 0.5);
}

TEST(Verify, AStepThatLeavesStockOnTheFloorIsNotAskedForItsCornersThere) {
  Part part = square_part();
  part.workplan.push_back(part.workplan[0]);
  Tool slim = part.tools[0];
  slim.number = 2;
  slim.diameter = 3;
  part.tools.push_back(slim);
  part.workplan[1].operation.tool = 1;
  part.workplan[1].operation.allowance_floor = 0.5;
  const auto program = [](double slim_z) {
    Writer writer;
    cut_square_rings(writer, {25, 25}, kRings, 0, -2);
    writer.leave().tool_change(2);
    cut_square_rings(writer, {25, 25}, {23.5}, 0, slim_z);
    return writer.done();
  };
  // Down to the floor only the wide cutter was sent.
  EXPECT_TRUE(verify_program(part, program(-1.5), {}).all.clean)
      << report_of(verify_program(part, program(-1.5), {}));
  part.workplan[1].operation.allowance_floor = 0;
  EXPECT_TRUE(has(verify_program(part, program(-1.5), {}), FaultKind::kUncut));
}

TEST(Verify, ASlimCutterThatLeavesStockOnWallsIsAskedForNoMore) {
  Part part = square_part();
  Tool slim = part.tools[0];
  slim.number = 2;
  slim.diameter = 3;
  part.tools.push_back(slim);
  part.workplan.push_back(part.workplan[0]);
  part.workplan[1].operation.tool = 1;
  part.workplan[1].operation.allowance_side = 0.4;
  const auto program = [](double ring) {
    Writer writer;
    cut_square_rings(writer, {25, 25}, kRings, 0, -2);
    writer.leave().tool_change(2);
    cut_square_rings(writer, {25, 25}, {ring}, 0, -2);
    return writer.done();
  };
  const Findings right = verify_program(part, program(23.1), {});
  EXPECT_TRUE(right.all.clean) << report_of(right);
  EXPECT_TRUE(has(verify_program(part, program(22.8), {}), FaultKind::kUncut));
}

TEST(Verify, OpenSidesMayBePassedOver) {
  Part part = pocket_part(rectangle(0, 0, 100, 40), 20, -1);
  part.stock = Stock{{{0, 0}, {100, 40}}, -20, 0};
  part.features[0].kind = FeatureKind::kPlanarFace;
  part.features[0].allowed = rectangle(-1000, -1000, 1100, 1040);
  Writer writer;
  writer.rapid({-15, 8}, 10)
      .rapid({-15, 8}, -1)
      .feed({115, 8})
      .feed({115, 24})
      .feed({-15, 24})
      .feed({-15, 36})
      .feed({115, 36});
  const Findings findings = verify_program(part, writer.done(), {});
  EXPECT_TRUE(findings.all.clean) << report_of(findings);
  EXPECT_NEAR(findings.all.unreachable_mm2, 0, 1e-9);
  EXPECT_GT(findings.all.air_cut_mm, 20);
  EXPECT_EQ(findings.features[0].figures.feed_mm, findings.all.feed_mm);
}

TEST(Verify, APocketUnderAPocketOpensItsFloor) {
  Part part = pocket_part(rectangle(0, 0, 50, 50), 6, -2);
  Feature deep = part.features[0];
  deep.name = "DEEP";
  deep.target = deep.allowed = rectangle(0, 0, 20, 50);  // shares three walls with the first
  deep.top_z = -2;
  deep.floor_z = -4;
  part.features.push_back(deep);
  part.workplan.push_back(part.workplan[0]);
  part.workplan[1].feature = 1;
  Writer writer;
  cut_square_rings(writer, {25, 25}, kRings, 0, -2);
  writer.enter({10, 10}, -2, -4)
      .feed({10, 40})
      .feed({7, 43})
      .feed({7, 7})
      .feed({13, 7})
      .feed({13, 43})
      .feed({7, 43});
  writer.feed({3, 47}).feed({3, 3}).feed({17, 3}).feed({17, 47}).feed({3, 47});
  const Findings right = verify_program(part, writer.done(), {});
  EXPECT_TRUE(right.all.clean) << report_of(right);
  ASSERT_EQ(right.features.size(), 2u);
  EXPECT_GT(right.features[1].figures.feed_mm, 200);
  EXPECT_NEAR(right.features[0].figures.feed_mm + right.features[1].figures.feed_mm, right.all.feed_mm, 1e-9);
  writer.enter({16, 25}, -2, -4).feed({17.1, 25});
  const Findings wrong = verify_program(part, writer.done(), {});
  ASSERT_TRUE(has(wrong, FaultKind::kGouge)) << report_of(wrong);
  EXPECT_NEAR(wrong.all.gouge_mm, 0.1, 1e-9);
}

TEST(Verify, LeaningWallsStandNearerBelow) {
  Part part = square_part();
  part.features[0].wall_slope = Radians::of_degrees(45);
  std::vector<double> rings = kRings;
  rings.back() = 20;
  rings[4] = 18;
  const Findings right = verify_program(part, square_program(rings), {});
  EXPECT_TRUE(right.all.clean) << report_of(right);
  rings.back() = 20.1;
  const Findings wrong = verify_program(part, square_program(rings), {});
  ASSERT_TRUE(has(wrong, FaultKind::kGouge));
  EXPECT_NEAR(wrong.all.gouge_mm, 0.1, 1e-9);
}

TEST(Verify, EveryLayerCountsOnLeaningWalls) {
  Part part = square_part();
  part.features[0].wall_slope = Radians::of_degrees(30);
  part.features[0].floor_z = -4;
  part.workplan[0].operation.scallop = 0.55;
  const auto program = [](const std::vector<double>& levels, double skipped) {
    Writer writer;
    double top = 0;
    for (const double z : levels) {
      std::vector<double> rings{2, 6.5, 11, 15};
      if (z != skipped) rings.push_back(22 + z * std::tan(kPi / 6));
      cut_square_rings(writer, {25, 25}, rings, top, z);
      top = z;
    }
    return writer.done();
  };
  const Findings right = verify_program(part, program({-1, -2, -3, -4}, 0), {});
  EXPECT_TRUE(right.all.clean) << report_of(right);
  // A wall ring left out half way down leaves 22 - 1.155 - 15 beside it, though the floor is clear.
  const Findings skipped = verify_program(part, program({-1, -2, -3, -4}, -2), {});
  ASSERT_TRUE(has(skipped, FaultKind::kUncut)) << report_of(skipped);
  EXPECT_EQ(fault_of(skipped, FaultKind::kUncut).at.z, -2);
  EXPECT_GT(skipped.features[0].layers[1].figures.uncut_mm2, 10);
  EXPECT_LE(skipped.features[0].layers[3].figures.uncut_thickness_mm, 0.005);
  // 2 mm between layers leave steps of 2 sin 30.
  const Findings coarse = verify_program(part, program({-1, -3, -4}, 0), {});
  ASSERT_TRUE(has(coarse, FaultKind::kUncut)) << report_of(coarse);
  EXPECT_NEAR(fault_of(coarse, FaultKind::kUncut).size, 1, 1e-9);
}

TEST(Verify, LayersThatLeaveStockMakeNoStepsInLeaningWalls) {
  Part part = square_part();
  part.features[0].wall_slope = Radians::of_degrees(30);
  part.features[0].floor_z = -4;
  part.workplan[0].operation.allowance_side = 0.3;
  part.workplan.push_back(part.workplan[0]);
  part.workplan[1].operation.allowance_side = 0;
  part.workplan[1].operation.scallop = 0.55;
  const auto program = [](const std::vector<double>& finished) {
    Writer writer;
    const auto cut = [&](const std::vector<double>& levels, double stock) {
      double top = 0;
      for (const double z : levels) {
        cut_square_rings(writer, {25, 25}, {2, 6.5, 11, 15, 18, 22 - stock + z * std::tan(kPi / 6)}, top, z);
        top = z;
      }
    };
    cut({-0.8, -1.8, -2.8, -3.8}, 0.3);
    writer.leave().tool_change(1);
    cut(finished, 0);
    Toolpath done = writer.done();
    for (int i = 0; i < 2; ++i) done.sections[static_cast<std::size_t>(i)].workingstep = i;
    return done;
  };
  const Findings right = verify_program(part, program({-1, -2, -3, -4}), {});
  EXPECT_TRUE(right.all.clean) << report_of(right);
  EXPECT_NEAR(right.features[1].scallop->height_mm, 0.5, 1e-9);
  // What roughing did at -1.8 is no step.
  const Findings coarse = verify_program(part, program({-1, -3, -4}), {});
  ASSERT_TRUE(has(coarse, FaultKind::kUncut)) << report_of(coarse);
  EXPECT_NEAR(fault_of(coarse, FaultKind::kUncut).size, 1, 1e-9);
}

TEST(Verify, WhatIsLeftIsSaidLayerByLayer) {
  Part part = pocket_part(rectangle(0, 0, 50, 50), 6, -4);
  std::vector<double> rings = kRings;
  rings.erase(rings.begin() + 2);
  Writer writer;
  cut_square_rings(writer, {25, 25}, rings, 0, -2);
  cut_square_rings(writer, {25, 25}, rings, -2, -4);
  const Findings findings = verify_program(part, writer.done(), {});
  ASSERT_EQ(findings.features[0].layers.size(), 2u);
  const double floor = findings.features[0].layers[1].figures.uncut_mm2;
  EXPECT_GT(floor, 200);
  EXPECT_NEAR(findings.features[0].layers[0].figures.uncut_mm2, floor, 1);
  EXPECT_NEAR(findings.all.uncut_mm2, floor, 1);
}

TEST(Verify, ARoundedCutterLeavesItsFilletAtTheWall) {
  Part part = square_part();
  part.tools[0].corner_radius = 1;
  std::vector<double> rings{1, 4, 7, 10, 13, 16, 19, 22};
  const Findings findings = verify_program(part, square_program(rings), {});
  EXPECT_FALSE(has(findings, FaultKind::kUncut)) << report_of(findings);
  // A band 1 mm wide along the walls is out of the flat end's reach, and more in the corners.
  EXPECT_NEAR(findings.all.unreachable_mm2, 4 * 50 - 4 + 4 * (1 - kPi / 4) * 4, 1);
  part.tools[0].kind = ToolKind::kBallEndMill;
  EXPECT_TRUE(has(verify_program(part, square_program(rings), {}), FaultKind::kNothingCut));
}

TEST(Verify, APlungeByACutterThatMayNotIsNamed) {
  Part part = square_part();
  part.tools[0].center_cutting = false;
  const Findings findings = verify_program(part, square_program(kRings), {});
  ASSERT_TRUE(has(findings, FaultKind::kPlungeTooFast));
  part.tools[0].center_cutting = true;
  EXPECT_FALSE(has(verify_program(part, square_program(kRings), {}), FaultKind::kPlungeTooFast));
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
