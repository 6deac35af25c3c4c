// Islands, rapids, levels, allowances, open sides: the check on programs written by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "verify/test_findings.h"
#include "verify/test_program.h"
#include "verify/verify.h"

namespace clearcut::verify {
namespace {

using testing::circle_loop;
using testing::cut_square_rings;
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
  const auto checked = [](double y) {
    Writer writer;
    writer.enter({10, 25}, 0, -2).feed({40, 25});
    writer.rapid({10, y}, -2);
    return verify_program(square_part(), writer.done(), {});
  };
  EXPECT_FALSE(has(checked(25), FaultKind::kRapidInMaterial));
  EXPECT_FALSE(has(checked(25.0005), FaultKind::kRapidInMaterial));
  EXPECT_TRUE(has(checked(25.005), FaultKind::kRapidInMaterial));
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

}  // namespace
}  // namespace clearcut::verify
