// Chamfers through the whole way: drawn, planned, certified, and what wrong programs are called.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/error.h"
#include "pipeline/run.h"
#include "pipeline/test_drawings.h"
#include "read/drawing/layer_rules.h"

namespace clearcut::pipeline {
namespace {

using ::testing::HasSubstr;

/// A pocket with an island in a plate with rounded corners, and a hole.
std::string plate(const std::string& edges) {
  return box("POCKET_D4", 12, 12, 48, 32) + box("POCKET_D4", 26, 18, 34, 26) +
         circle("HOLE_D4", {62, 22}, 4) + rounded_box("PROFILE_D6", 0, 0, 74, 44, 5) + edges;
}

std::string all_edges(const std::string& layer) {
  return box(layer, 12, 12, 48, 32) + box(layer, 26, 18, 34, 26) + circle(layer, {62, 22}, 4) +
         rounded_box(layer, 0, 0, 74, 44, 5);
}

const std::vector<std::string> kTools{"endmill:5", "chamfer:90deg:8:tip=0.4", "vbit:60deg:6"};

TEST(Chamfering, EdgesOfPocketsIslandsHolesAndCutOutsAreBrokenClean) {
  for (const char* bit : {"chamfer:90deg:8:tip=0.4", "vbit:60deg:6"}) {
    const PlanResult result = plan_part(drawn(plate(all_edges("CHAMFER_D0.5"))), with({"endmill:5", bit}));
    EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << bit << "\n" << faults_of(result.findings);
    EXPECT_LE(result.findings.all.gouge_mm, 0.001);
    EXPECT_LT(result.findings.all.uncut_thickness_mm, 0.01);
  }
}

/// The tip of a chamfer mill goes deeper than its chamfer: what smaller mills have to cut in the corners must be gone before.
TEST(Chamfering, ComesAfterWhatIsLeftInThePocket) {
  auto options = with({"endmill:6", "endmill:2", "chamfer:90deg:8"});
  options.shop.rest = true;
  options.stepdown = 0.4;
  const PlanResult result =
      plan_part(drawn(box("POCKET_D2", 0, 0, 30, 20) + box("CHAMFER_D0.4", 0, 0, 30, 20)), options);
  EXPECT_EQ(faults_of(result.findings), "");
  ASSERT_EQ(result.findings.features.size(), 3U);
  EXPECT_EQ(result.findings.features.back().name, "CHAMFER_D0.4");
}

TEST(Chamfering, TwentyMicrometresTooDeepTooWideOrTooShallowIsFaulty) {
  const auto options = with({"endmill:5", "chamfer:90deg:8:tip=0.4"});
  const Part part = drawn(plate(all_edges("CHAMFER_D0.5")));
  const auto checked = [&](const std::string& edges) {
    return check_program(part, plan_part(drawn(plate(edges)), options).program, "other.ngc", options)
        .findings;
  };
  const Findings deep = checked(all_edges("CHAMFER_D0.52"));
  EXPECT_TRUE(has(deep, FaultKind::kGouge)) << faults_of(deep);
  EXPECT_NEAR(deep.all.gouge_mm, 0.02, 0.004);
  EXPECT_TRUE(has(checked(all_edges("CHAMFER_D0.48")), FaultKind::kUncut));
}

/// A tongue of the plate comes into the pocket so near to its left wall that the mill passes it at the tip alone: material stands before its left
/// flank, and the chamfer of its right one need not go as deep as if that were a wall.
TEST(Chamfering, BesideWallsThatTheMillDoesNotReachTheMilledOnesCount) {
  const std::vector<BulgeVertex> tongue{
      {{0, 0}}, {{7.94, -1.014}}, {{7.483, 12.779}}, {{3.97, 7.818}}, {{1.148, 11.806}}};
  const PlanResult result = plan_part(drawn(outline("POCKET_D3", tongue) + outline("CHAMFER_D0.2", tongue)),
                                      with({"endmill:4", "chamfer:90deg:8:tip=0.4"}));
  EXPECT_NE(verdict_of(result.findings), Verdict::kFaulty) << faults_of(result.findings);
  EXPECT_LT(result.findings.all.uncut_thickness_mm, 0.01);
}

/// The words of the chamfer's section, moved down or left out.
TEST(Chamfering, ATipTwentyMicrometresLowerOrAnEdgeLeftOutIsFaulty) {
  const auto options = with({"endmill:5", "chamfer:90deg:8:tip=0.4"});
  const Part part = drawn(box("POCKET_D4", 12, 12, 48, 32) + box("CHAMFER_D0.5", 12, 12, 48, 32));
  const std::string good = plan_part(part, options).program;
  ASSERT_THAT(good, HasSubstr("Z-1 "));
  std::string lower = good;
  const auto change = lower.find("T2 M6");
  ASSERT_NE(change, std::string::npos);
  for (auto at = lower.find("Z-1 ", change); at != std::string::npos; at = lower.find("Z-1 ", at + 5))
    lower.replace(at, 4, "Z-1.02 ");
  const Findings deep = check_program(part, lower, "lower.ngc", options).findings;
  EXPECT_TRUE(has(deep, FaultKind::kGouge)) << faults_of(deep);
  const std::string without = good.substr(0, change) + "M5\nM30\n";
  const Findings left = check_program(part, without, "without.ngc", options).findings;
  EXPECT_TRUE(has(left, FaultKind::kNothingCut)) << faults_of(left);
  std::string half = good;
  half.replace(half.find("X", half.find("Z-1 ", change) + 5), 0, "(END OF THE CUT) M5\nM30\n");
  const Findings partly = check_program(part, half, "half.ngc", options).findings;
  EXPECT_TRUE(has(partly, FaultKind::kUncut)) << faults_of(partly);
}

TEST(Chamfering, ANeighbouringWallKeepsTheConeAway) {
  // A slot 4 mm wide: a cone that goes as far below as it likes would break the other edge, too.
  const std::string slot = box("POCKET_D4", 0, 0, 40, 4);
  const PlanResult both =
      plan_part(drawn(slot + box("CHAMFER_D0.5", 0, 0, 40, 4)), with({"endmill:3", "chamfer:90deg:8"}));
  EXPECT_EQ(verdict_of(both.findings), Verdict::kClean) << faults_of(both.findings);
  // An edge on the floor of a wider pocket, whose wall is 2 mm away.
  const std::string step =
      box("POCKET_D3", -2, -2, 42, 32) + box("DEEP_D8", 0, 0, 40, 30) + box("CHAMFER_D0.5", 0, 0, 40, 30);
  const PlanResult stepped = plan_part(drawn(step), with({"endmill:5", "chamfer:90deg:8"}));
  EXPECT_LE(stepped.findings.all.gouge_mm, 0.001) << faults_of(stepped.findings);
}

TEST(Chamfering, TheEdgesOfTheStockAreBroken) {
  const Part part = drawn(box("STOCK_D10", 0, 0, 60, 40) + box("POCKET_D4", 12, 12, 48, 30) +
                          box("CHAMFER_D1", 0, 0, 60, 40));
  const auto options = with({"endmill:5", "chamfer:90deg:8:tip=0.4"});
  const PlanResult result = plan_part(part, options);
  EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << faults_of(result.findings);
}

TEST(Chamfering, WhatCannotBeBrokenIsRefused) {
  const std::vector<std::string> tools{"endmill:5", "chamfer:90deg:8"};
  const std::string pocket = box("POCKET_D4", 12, 12, 48, 32);
  EXPECT_THAT(refusal(drawn(pocket + box("CHAMFER_D0.5", 15, 15, 40, 30)), tools),
              HasSubstr("no wall stands along"));
  EXPECT_THAT(refusal(drawn(pocket + box("CHAMFER_D0.5", 12, 12, 48, 32)), {"endmill:5", "endmill:3"}),
              HasSubstr("needs a chamfer mill or a V-bit"));
  EXPECT_THAT(refusal(drawn(pocket + box("CHAMFER_D5", 12, 12, 48, 32)), tools), HasSubstr("use less depth"));
  EXPECT_THAT(
      refusal(drawn(pocket + box("POCKET_D4", 49, 12, 60, 32) + box("CHAMFER_D1.5", 12, 12, 48, 32)), tools),
      HasSubstr("meets POCKET_D4"));
  EXPECT_THAT(
      refusal(drawn(pocket + box("POCKET_D4", 28, 16, 29, 28) + box("CHAMFER_D0.6", 28, 16, 29, 28)), tools),
      HasSubstr("nothing of the top"));
}

TEST(Chamfering, AnOptionBreaksTheEdgesOfWhatIsMilledBesides) {
  const std::string pocket = box("POCKET_D4", 12, 12, 48, 32);
  ReadOptions options;
  options.layer_rules = {read::rule_of_option("chamfer_d0.3:POCKET_D4", "--op")};
  const Part part = read::read_part_text(drawing(pocket), "plate.dxf", options);
  ASSERT_EQ(part.features.size(), 2u);
  EXPECT_EQ(part.features[0].kind, FeatureKind::kClosedPocket);
  EXPECT_EQ(part.features[1].kind, FeatureKind::kChamfer);
  EXPECT_NEAR(part.features[1].chamfer->depth, 0.3, 1e-12);
  options.layer_rules = {read::rule_of_option("deburr:1", "--op")};
  const Part broken = read::read_part_text(drawing(pocket), "plate.dxf", options);
  ASSERT_EQ(broken.features.size(), 2u);
  EXPECT_NEAR(broken.features[1].chamfer->depth, 0.2, 1e-12);
  const PlanResult result = plan_part(part, with({"endmill:5", "chamfer:90deg:8"}));
  EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << faults_of(result.findings);
}

/// In a kerf of 2 mm a cone of 120 degrees, 1 mm up, touches the other side wherever it runs.
TEST(Chamfering, WhereTheConeHasNoRoomTheSkipSaysHowMuchItNeeds) {
  const std::string text = box("PROFILE_D4", 0, 0, 40, 30) + box("CHAMFER_D1", 0, 0, 40, 30);
  const PlanResult result = plan_part(drawn(text), with({"endmill:2", "chamfer:120deg:8:tip=0.4"}));
  EXPECT_TRUE(has(result.findings, FaultKind::kNothingCut)) << faults_of(result.findings);
  const auto& said = result.part.diagnostics.items();
  EXPECT_TRUE(std::any_of(said.begin(), said.end(), [](const Diagnostic& one) {
    return one.what.find("it needs 1.932 mm there") != std::string::npos;
  }));
}

/// The tip goes below the chamfer's foot, where a narrower mill of another feature has a stepdown of its own.
TEST(Chamfering, TheStepdownOfTheirOwnToolCounts) {
  const std::string bar = box("PROFILE_D4", 0, 0, 20, 40) + box("CHAMFER_D1", 0, 0, 20, 40);
  EXPECT_EQ(faults_of(plan_part(drawn(bar), with({"endmill:2", "chamfer:90deg:6"})).findings), "");
}

}  // namespace
}  // namespace clearcut::pipeline
