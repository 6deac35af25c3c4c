// What one set-up leaves to the next, by hand and through whole plans.
#include "pipeline/setups/carried_stock.h"

#include <gtest/gtest.h>

#include "model/results/nothing_to_machine.h"
#include "pipeline/test_drawings.h"
#include "post/post.h"

namespace clearcut::pipeline {
namespace {

/// A block 80 x 60 x 12 with its top at z 0.
const std::string kBlock = box("STOCK_D12", 0, 0, 80, 60);
const std::vector<std::string> kTools{"endmill:6"};

SetupPlace lying(const char* up, double turn, SetupPlace::Row shift) {
  SetupPlace place = *place_with_up(up, turn);
  place.shift = shift;
  return place;
}

/// Turned over about its x axis, the block where it was before.
const SetupPlace kBelow = lying("-Z", 0, {0, 60, -12});

MachinedSetup machined(const std::string& drawn_text, const SetupPlace& place = {}) {
  const PlanResult result = plan_part(drawn(drawn_text), with(kTools));
  EXPECT_TRUE(result.findings.all.clean) << faults_of(result.findings);
  return {result.part, result.toolpath, place};
}

PlanResult planned_on(const CarriedStock& carried, Part part) {
  PlanOptions options = with(kTools);
  part.stock = carried.block;
  options.earlier = carried.sweeps;
  return plan_part(part, options);
}

TEST(SetupPlaces, TurnBlocksAndLines) {
  const Stock block{{{0, 0}, {80, 60}}, -12, 0};
  const Stock over = moved(block, kBelow);
  EXPECT_EQ(over.plan.min, (Vec2{0, 0}));
  EXPECT_EQ(over.plan.max, (Vec2{80, 60}));
  EXPECT_DOUBLE_EQ(over.z_bottom, -12);
  EXPECT_DOUBLE_EQ(over.z_top, 0);
  const Edge arc = Edge::arc({10, 0}, {0, 10}, {0, 0}, Turn::kCounterClockwise);
  const Edge turned = moved(arc, kBelow);
  EXPECT_EQ(turned.from, (Vec2{10, 60}));
  EXPECT_EQ(turned.turn, Turn::kClockwise);
  EXPECT_NEAR(turned.length(), arc.length(), 1e-12);
  // About x, then a half turn about the vertical, is about y.
  EXPECT_EQ(moved(Edge::line({10, 0}, {10, 5}), *place_with_up("-Z", 180)).from, (Vec2{-10, 0}));
  // On its side: what was 12 mm high is 12 mm wide.
  const Stock side = moved(block, *place_with_up("+X", 0));
  EXPECT_DOUBLE_EQ(side.plan.width(), 12);
  EXPECT_DOUBLE_EQ(side.z_top - side.z_bottom, 80);
  EXPECT_FALSE(place_with_up("face3", 0));
  EXPECT_FALSE(keeps_boxes(*place_with_up("+Z", 30)));
}

TEST(SetupPlaces, GoThereAndBack) {
  const SetupPlace a = lying("-Y", 90, {3, -2, 7}), b = lying("+X", 180, {1, 1, 1});
  const Stock block{{{1, 2}, {5, 9}}, -3, 8};
  const Stock there = moved(moved(block, a), between(a, b)), directly = moved(block, b);
  EXPECT_NEAR(there.plan.min.x, directly.plan.min.x, 1e-12);
  EXPECT_NEAR(there.plan.max.y, directly.plan.max.y, 1e-12);
  EXPECT_NEAR(there.z_bottom, directly.z_bottom, 1e-12);
}

TEST(CarriedStock, WhatWentThroughIsNotCutAgainFromBelow) {
  const MachinedSetup first = machined(kBlock + box("POCKET_D12", 10, 10, 40, 30));
  // Seen from below the same hole lies at y 30 to 50.
  const Part below = drawn(kBlock + box("POCKET_D12", 10, 30, 40, 50) + box("POCKET_D4", 50, 10, 70, 30));
  const CarriedStock carried = carried_stock({first}, kBelow, below);
  EXPECT_FALSE(carried.sweeps.sections.empty());
  const PlanResult on_carried = planned_on(carried, below), alone = plan_part(below, with(kTools));
  EXPECT_TRUE(on_carried.findings.all.clean) << faults_of(on_carried.findings);
  EXPECT_EQ(on_carried.toolpath.sections.size(), 1u);
  EXPECT_EQ(alone.toolpath.sections.size(), 2u);
  EXPECT_LT(on_carried.findings.all.feed_mm, alone.findings.all.feed_mm / 2);
}

TEST(CarriedStock, APocketFromTheOtherSideIsAHollowThatCountsAsSolid) {
  const MachinedSetup first = machined(kBlock + box("POCKET_D5", 10, 10, 40, 30));
  const Part below = drawn(kBlock + box("POCKET_D4", 10, 30, 40, 50));
  const CarriedStock carried = carried_stock({first}, kBelow, below);
  EXPECT_TRUE(carried.sweeps.sections.empty());
  const PlanResult on_carried = planned_on(carried, below), alone = plan_part(below, with(kTools));
  EXPECT_EQ(on_carried.program, alone.program);
}

/// A hollow reaches the floor of a facing cut from below: what begins there finds nothing to cut.
TEST(CarriedStock, AHollowCountsForWhatBeginsAtItsCeilingAndNoHigher) {
  const MachinedSetup first = machined(kBlock + box("POCKET_D10", 10, 10, 40, 30));
  const std::string hole = box("POCKET TOP-2 D10", 10, 30, 40, 50), face = box("FACE_D2", 0, 0, 80, 60);
  const Part below = drawn(kBlock + face + hole);
  const PlanResult faced = planned_on(carried_stock({first}, kBelow, below), below);
  EXPECT_TRUE(faced.findings.all.clean) << faults_of(faced.findings);
  EXPECT_EQ(faced.toolpath.sections.size(), 1u);
  // Half a millimetre of material over the hollow: the whole has to be cut.
  const Part higher =
      drawn(kBlock + box("FACE_D1.5", 0, 0, 80, 60) + box("POCKET TOP-1.5 D10.5", 10, 30, 40, 50));
  const PlanResult whole = planned_on(carried_stock({first}, kBelow, higher), higher);
  EXPECT_TRUE(whole.findings.all.clean) << faults_of(whole.findings);
  EXPECT_EQ(whole.toolpath.sections.size(), 2u);
}

/// A face that an earlier set-up has cut away asks for nothing; of a drawing it is a mistake that planning refuses.
TEST(CarriedStock, StepsOfAProgramThatAreCutAwayBeforeAreLeftOutWithANote) {
  Part part = drawn(kBlock + box("FACE_D1", 0, 0, 80, 60) + box("POCKET TOP-1 D5", 10, 10, 40, 30));
  Stock left = *part.stock;
  left.z_top = -1.5;
  EXPECT_EQ(on_block(part, left).workplan.size(), 2u);
  part.workplan[0].source = "#10";
  part.workplan[1].source = "#20";
  const Part rest = on_block(part, left);
  ASSERT_EQ(rest.workplan.size(), 1u);
  ASSERT_EQ(rest.features.size(), 1u);
  EXPECT_EQ(rest.workplan[0].source, "#20");
  EXPECT_DOUBLE_EQ(rest.features[0].top_z, -1.5);
  EXPECT_NE(rest.diagnostics.items().back().what.find("has nothing left to cut"), std::string::npos);
  EXPECT_EQ(on_block(part, *part.stock).workplan.size(), 2u);
  // A face of the whole block begins at its top: one above it is a mistake as before.
  Part above = part;
  above.stock->z_top = -3;
  EXPECT_EQ(on_block(above, left).workplan.size(), 2u);
  left.z_top = -6;
  try {
    on_block(part, left);
    FAIL() << "something is left to cut";
  } catch (const NothingToMachine& nothing) {
    EXPECT_TRUE(nothing.is_done());
  }
}

TEST(CarriedStock, FromTheSameSideEverythingIsCarried) {
  const MachinedSetup first = machined(kBlock + box("POCKET_D5", 10, 10, 40, 30));
  SetupPlace aside;
  aside.shift = {-80, 5, 2};
  const std::string block = box("STOCK TOP2 D12", -80, 5, 0, 65);
  const Part second =
      drawn(block + box("POCKET TOP2 D5", -70, 15, -40, 35) + box("POCKET TOP2 D3", -30, 15, -10, 35));
  const CarriedStock carried = carried_stock({first}, aside, second);
  EXPECT_NEAR(carried.block.z_top, 2, 1e-12);
  const PlanResult result = planned_on(carried, second);
  EXPECT_TRUE(result.findings.all.clean) << faults_of(result.findings);
  EXPECT_EQ(result.toolpath.sections.size(), 1u);
}

TEST(CarriedStock, OnItsSideTheBlockAloneIsCarriedLessWhatWasFacedOff) {
  const MachinedSetup first =
      machined(kBlock + box("FACE_D1", 0, 0, 80, 60) + box("POCKET_D12", 10, 10, 40, 30));
  const SetupPlace side = *place_with_up("+X", 0);
  Part next = drawn(kBlock + box("POCKET_D5", 10, 10, 40, 30));
  next.stock = moved(Stock{{{0, 0}, {80, 60}}, -12, 0}, side);
  const CarriedStock carried = carried_stock({first}, side, next);
  EXPECT_TRUE(carried.sweeps.sections.empty());
  EXPECT_NEAR(carried.block.plan.width(), 11, 1e-9);
  EXPECT_NEAR(carried.block.z_top - carried.block.z_bottom, 80, 1e-9);
  const CarriedStock over = carried_stock({first}, kBelow, next);
  EXPECT_NEAR(over.block.z_bottom, -11, 1e-9) << "the faced side lies below";
  EXPECT_NEAR(over.block.z_top, 0, 1e-9);
}

/// The first rapid at `z` that goes across is let down to `to`.
std::string with_low_rapid(Toolpath path, const Part& part, Vec2 at, double to) {
  Section& section = path.sections.front();
  const Vec2 end = section.moves.back().path.to;
  const double high = section.moves.back().z_to;
  const auto rapid = [&](Vec2 a, Vec2 b, double from, double down) {
    section.moves.push_back({Edge::line(a, b), from, down, MoveKind::kRapid, {}, 0});
  };
  rapid(end, at, high, high);
  rapid(at, at, high, to);
  rapid(at, at, to, high);
  return post::write_program(path, part, {});
}

TEST(CarriedStock, ARapidIntoWhatIsLeftIsAFaultAndThroughWhatIsGoneIsNone) {
  const MachinedSetup first =
      machined(kBlock + box("POCKET_D12", 10, 10, 40, 30) + box("POCKET_D5", 50, 40, 70, 55));
  const Part below = [] {
    Part part = drawn(kBlock + box("POCKET_D12", 10, 30, 40, 50) + box("POCKET_D4", 50, 30, 70, 50));
    return part;
  }();
  const CarriedStock carried = carried_stock({first}, kBelow, below);
  const PlanResult result = planned_on(carried, below);
  ASSERT_TRUE(result.findings.all.clean) << faults_of(result.findings);
  Part part = below;
  part.stock = carried.block;
  PlanOptions options = with(kTools);
  options.earlier = carried.sweeps;
  const auto findings = [&](Vec2 at) {
    const std::string program = with_low_rapid(result.toolpath, result.part, at, -8);
    return check_program(part, program, "rapid", options, Dialect::kLinuxCnc).findings;
  };
  const Findings through = findings({25, 40});
  EXPECT_FALSE(has(through, FaultKind::kRapidInMaterial)) << faults_of(through);
  // Over the pocket of the other side, which lies at y 5 to 20 from here, 7 mm are left.
  EXPECT_TRUE(has(findings({60, 12}), FaultKind::kRapidInMaterial));
  options.earlier.reset();
  EXPECT_TRUE(has(findings({25, 40}), FaultKind::kRapidInMaterial)) << "without what was carried it is solid";
}

/// A block of 12 mm: 7 from above and 6 from below leave no floor where they overlap, over 10 by 40 mm.
TEST(CarriedStock, FloorsThatMeetAreACondition) {
  const std::string above = kBlock + box("POCKET_D7", 10, 10, 40, 50);
  const auto conditions = [&](const std::string& layer, double left, double right) {
    Part next = drawn(kBlock + box(layer, left, 10, right, 50));
    return carried_stock({machined(above)}, kBelow, next).conditions;
  };
  const auto found = conditions("POCKET_D6", 30, 60);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].name, "floors-meet");
  EXPECT_NE(found[0].text.find("1 mm deeper than the block is thick, over 400 mm2"), std::string::npos)
      << found[0].text;
  EXPECT_TRUE(conditions("POCKET_D5", 30, 60).empty()) << "the floors touch";
  EXPECT_TRUE(conditions("POCKET_D6", 45, 70).empty()) << "beside each other";
  EXPECT_TRUE(conditions("POCKET_D12", 30, 60).empty()) << "is meant to go through";
}

/// Until somebody accepts them.
TEST(CarriedStock, FloorsThatMeetKeepAPlanFromBeingClean) {
  Part next = drawn(kBlock + box("POCKET_D6", 30, 10, 60, 50));
  const CarriedStock carried =
      carried_stock({machined(kBlock + box("POCKET_D7", 10, 10, 40, 50))}, kBelow, next);
  next.stock = carried.block;
  PlanOptions options = with(kTools);
  options.earlier = carried.sweeps;
  options.conditions = carried.conditions;
  EXPECT_EQ(verdict_of(plan_part(next, options).findings), Verdict::kConditional);
  options.accept = {"floors-meet"};
  EXPECT_EQ(verdict_of(plan_part(next, options).findings), Verdict::kClean);
}

}  // namespace
}  // namespace clearcut::pipeline
