// Drafted walls and pockets in layers: what is checked of programs written by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "verify/test_findings.h"
#include "verify/test_program.h"
#include "verify/verify.h"

namespace clearcut::verify {
namespace {

using testing::cut_square_rings;
using testing::fault_of;
using testing::has;
using testing::kRings;
using testing::pocket_part;
using testing::rectangle;
using testing::report_of;
using testing::square_part;
using testing::square_program;
using testing::Writer;

/// A slot through the whole stock, 10 mm wide at the top, its walls 1 mm nearer at the floor.
Part drafted_slot() {
  Part part = pocket_part(rectangle(0, 15, 60, 25), 6, -4);
  part.stock = Stock{{{0, 0}, {60, 40}}, -20, 0};
  const Region around = rectangle(-1000, -1000, 1060, 1040)[0];
  Feature& slot = part.features[0];
  slot.kind = FeatureKind::kSlot;
  slot.wall_slope = Radians::of(std::atan(0.25));
  part.workplan[0].operation.scallop = 1;
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
  const Part part = drafted_slot();
  const Findings right = verify_program(part, slot_program(19, 21), {});
  EXPECT_TRUE(right.all.clean) << report_of(right);
  EXPECT_LE(right.all.unreachable_mm2, 0.1);
  // What leans ends with the stock: beside it a cutter may pass as near as beside an upright side.
  EXPECT_TRUE(verify_program(part, slot_program(19, 21, -3), {}).all.clean);
  EXPECT_NEAR(verify_program(part, slot_program(19, 21, -2.99), {}).all.gouge_mm, 0.01, 1e-9);
  EXPECT_NEAR(verify_program(part, slot_program(18.99, 21), {}).all.gouge_mm, 0.01, 1e-9);
  EXPECT_TRUE(has(verify_program(part, slot_program(19.02, 21), {}), FaultKind::kUncut));
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
  part.workplan[0].operation.scallop = 1.5;
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

/// Two grooves of a pointed 60 degree cutter, 0.3 mm deep, that cross at the zero.
Part crossing_grooves() {
  const double half = 0.3 * std::tan(kPi / 6);
  Part part = pocket_part(rectangle(-10, -half, 10, half), 6, -0.3);
  part.tools[0].kind = ToolKind::kVBit;
  part.tools[0].tip_angle = Radians::of_degrees(60);
  part.features[0].wall_slope = Radians::of_degrees(30);
  Feature across = part.features[0];
  across.name = "ACROSS";
  across.target = across.allowed = rectangle(-half, -10, half, 10);
  part.features.push_back(across);
  part.workplan.push_back(part.workplan[0]);
  part.workplan[1].feature = 1;
  return part;
}

Toolpath crossing_program(double aside, double z = -0.3) {
  Writer writer;
  writer.enter({-9.5, 0}, 0, -0.3).feed({9.5, 0}).leave();
  writer.enter({aside, -9.5}, 0, -0.3).feed({aside, -2}).feed({aside, 2}, z).feed({aside, 9.5}, -0.3);
  return writer.done();
}

TEST(Verify, GroovesThatCrossAreNoWallsToEachOther) {
  const Part part = crossing_grooves();
  const Findings right = verify_program(part, crossing_program(0), {});
  EXPECT_FALSE(has(right, FaultKind::kGouge)) << report_of(right);
  const Findings aside = verify_program(part, crossing_program(0.05), {});
  ASSERT_TRUE(has(aside, FaultKind::kGouge));
  EXPECT_NEAR(aside.all.gouge_mm, 0.05 / std::tan(kPi / 6), 1e-9);  // below the slope of the groove
  const Findings deep = verify_program(part, crossing_program(0, -0.4), {});
  ASSERT_TRUE(has(deep, FaultKind::kGouge));
  EXPECT_GT(deep.all.gouge_mm, 0.05);
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

/// Two mills at heights of their own: what the wider one leaves in the corners is left to the layers of the narrower one.
TEST(Verify, CornersOfLeaningWallsCountAtTheHeightsOfTheCutterThatReachesThem) {
  Part part = square_part();
  part.features[0].wall_slope = Radians::of_degrees(30);
  part.features[0].floor_z = -4;
  part.workplan[0].operation.scallop = 0.55;
  part.tools.push_back(part.tools[0]);
  part.tools[1].diameter = 3;
  part.tools[1].number = 2;
  part.tools[0].number = 1;
  part.workplan.push_back(part.workplan[0]);
  part.workplan[1].operation.tool = 1;
  part.workplan[1].operation.rest = true;
  const auto program = [](const std::vector<double>& narrow) {
    Writer writer;
    double top = 0;
    for (const double z : {-0.7, -1.6, -2.5, -3.3, -4.0}) {
      cut_square_rings(writer, {25, 25}, {2, 6.5, 11, 15, 18, 22 + z * std::tan(kPi / 6)}, top, z);
      top = z;
    }
    writer.leave().tool_change(2);
    top = 0;
    for (const double z : narrow) {
      cut_square_rings(writer, {25, 25}, {23.5 + z * std::tan(kPi / 6)}, top, z);
      top = z;
    }
    Toolpath done = writer.done();
    for (int i = 0; i < 2; ++i) done.sections[static_cast<std::size_t>(i)].workingstep = i;
    return done;
  };
  const Findings right = verify_program(part, program({-1, -2, -3, -4}), {});
  EXPECT_FALSE(has(right, FaultKind::kUncut)) << report_of(right);
  // A layer of the narrow one is missing: the corners then have steps of 2 sin 30.
  const Findings coarse = verify_program(part, program({-1, -3, -4}), {});
  EXPECT_TRUE(has(coarse, FaultKind::kUncut)) << report_of(coarse);
}

/// The level turn at the end of a helix, and a level block of a ramp by rounding, are no layers.
TEST(Verify, ALevelMoveOfAnEntryIsNoLayerOfALeaningWall) {
  Part part = square_part();
  part.features[0].wall_slope = Radians::of_degrees(30);
  part.features[0].floor_z = -2;
  part.workplan[0].operation.scallop = 0.55;
  Writer writer;
  double top = 0;
  for (const double z : {-1.0, -2.0}) {
    if (z == -2) writer.enter({20, 20}, -1, -1.4).feed({24, 20}).leave();
    cut_square_rings(writer, {25, 25}, {2, 6.5, 11, 15, 18, 22 + z * std::tan(kPi / 6)}, top, z);
    top = z;
  }
  const Findings found = verify_program(part, writer.done(), {});
  EXPECT_FALSE(has(found, FaultKind::kUncut)) << report_of(found);
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

/// The square pocket with walls of 45 degrees, in layers at these heights; `descends`: each but the first is reached along its last ring.
Toolpath drafted_rings(const std::vector<double>& heights) {
  Writer writer;
  double above = 0;
  for (const double z : heights) {
    const double widest = 22 + z;
    std::vector<double> rings{2, 6.5, 11, 15.5};
    for (const double ring : {18.0, widest - 1, widest})
      if (ring <= widest && ring > rings.back()) rings.push_back(ring);
    testing::cut_square_rings(writer, {25, 25}, rings, above, z);
    writer.leave();
    above = z;
  }
  return writer.done();
}

TEST(Verify, WhatLayersLeaveOnLeaningWallsIsUncut) {
  Part part = square_part();
  part.features[0].wall_slope = Radians::of_degrees(45);
  const std::vector<double> fine{-0.25, -0.5, -0.75, -1, -1.25, -1.5, -1.75, -2};
  const Findings right = verify_program(part, drafted_rings(fine), {});
  EXPECT_TRUE(right.all.clean) << report_of(right);
  ASSERT_TRUE(right.features[0].scallop);
  EXPECT_NEAR(right.features[0].scallop->height_mm, 0.25 * std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(*right.features[0].scallop->asked_mm, 0.2, 1e-12) << "what may stand where nobody asks";
  // One layer is left out.
  const Findings missing =
      verify_program(part, drafted_rings({-0.25, -0.5, -0.75, -1.25, -1.5, -1.75, -2}), {});
  ASSERT_TRUE(has(missing, FaultKind::kUncut)) << report_of(missing);
  EXPECT_NEAR(missing.all.uncut_thickness_mm, 0.5 * std::sqrt(0.5), 1e-9);
  part.workplan[0].operation.scallop = 0.4;
  EXPECT_TRUE(verify_program(part, drafted_rings({-0.5, -1, -1.5, -2}), {}).all.clean);
  part.workplan[0].operation.scallop = 0.3;
  EXPECT_TRUE(has(verify_program(part, drafted_rings({-0.5, -1, -1.5, -2}), {}), FaultKind::kUncut));
}

TEST(Verify, LeaningWallsMayBeCutBetweenLayers) {
  // Roughed in two layers; then square turns go down along the walls, 0.25 mm a turn.
  Part part = square_part();
  part.features[0].wall_slope = Radians::of_degrees(45);
  const auto turns_down = [](double pitch) {
    Writer writer;
    testing::cut_square_rings(writer, {25, 25}, {2, 6.5, 11, 15.5, 18, 20}, 0, -2);
    writer.leave().rapid({3, 3}, 10).rapid({3, 3}, 1).feed({3, 3}, 0);
    double z = 0;
    const auto turn = [&](double drop) {
      for (int corner = 0; corner < 4; ++corner) {
        z -= drop / 4;
        const double half = 22 + z, x = corner == 0 || corner == 1 ? half : -half,
                     y = corner < 1 || corner > 2 ? -half : half;
        writer.feed({25 + x, 25 + y}, z);
      }
    };
    while (z > -2 + 1e-9) turn(std::min(pitch, z + 2));
    turn(0);
    return writer.done();
  };
  const Findings fine = verify_program(part, turns_down(0.2), {});
  EXPECT_FALSE(has(fine, FaultKind::kUncut)) << report_of(fine);
  EXPECT_TRUE(has(verify_program(part, turns_down(0.8), {}), FaultKind::kUncut));
}

TEST(Verify, RoundedEndsLeaveMoreOnLeaningWallsThanFlatOnes) {
  Part part = square_part();
  part.features[0].wall_slope = Radians::of_degrees(45);
  part.workplan[0].operation.scallop = 0.5;
  part.tools[0].corner_radius = 1;
  const Findings rounded = verify_program(part, drafted_rings({-0.5, -1, -1.5, -2}), {});
  ASSERT_TRUE(rounded.features[0].scallop);
  // The rounding passes the wall at 45 degrees at sqrt(2) - 1 of its radius, and goes on to the next layer's.
  EXPECT_GT(rounded.features[0].scallop->height_mm, std::sqrt(2.0) - 1);
}

}  // namespace
}  // namespace clearcut::verify
