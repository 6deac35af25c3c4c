// T-slots through the whole way: drawn, planned, certified, and what wrong programs are called.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "pipeline/check.h"
#include "pipeline/run.h"
#include "pipeline/test_drawings.h"

namespace clearcut::pipeline {
namespace {

using ::testing::HasSubstr;

const std::vector<std::string> kTools{"endmill:12:length=30", "tslot:20:length=8:shank=10"};

std::string line(const std::string& layer, Vec2 from, Vec2 to) {
  return "0\nLINE\n8\n" + layer + "\n10\n" + std::to_string(from.x) + "\n20\n" + std::to_string(from.y) +
         "\n11\n" + std::to_string(to.x) + "\n21\n" + std::to_string(to.y) + "\n";
}

const std::string kPlate = box("STOCK_D20", 0, 0, 100, 60);

Part open_slot() {
  return drawn(kPlate + line("TSLOT_D12", {0, 30}, {100, 30}));
}

/// The slot for the neck, and the undercut, as a person would write them.
const std::string kNeck =
    "T1 M6\nG43 H1\nM3 S2650\nG0 Z10\nX-8 Y30\nG1 Z-6 F300\nX108 F800\nG0 Z10\nX-8\nG1 Z-12 F300\nX108 "
    "F800\nG0 Z10\n";
const std::string kDiscDown = "M5\nT2 M6\nG43 H2\nM3 S1590\nG0 Z10\nX-12 Y30\n";
const std::string kDisc = kDiscDown + "G1 Z-12 F300\nX112 F400\nG0 Z10\n";

std::string program(const std::string& body) {
  return "G21 G90 G17 G40 G49 G80 G94 G54 G61\n" + body + "M5\nM30\n";
}

Findings checked(const Part& part, const std::string& body, const std::vector<std::string>& tools = kTools) {
  return check_program(part, program(body), "hand.ngc", with(tools)).findings;
}

TEST(TSlots, AnOpenSlotIsMilledForTheNeckThenUndercutFromOutsideToOutside) {
  const PlanResult result = plan_part(open_slot(), with(kTools));
  EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << faults_of(result.findings);
  EXPECT_LE(result.findings.all.gouge_mm, 0.001);
  const auto change = result.program.find("T2 M6");
  ASSERT_NE(change, std::string::npos);
  EXPECT_LT(result.program.find("T1 M6"), change);
  EXPECT_THAT(result.program.substr(change), HasSubstr("X-12 Y30\nZ1\nG1 Z-12 F300\nX112 F1000\nG0 Z10\n"));
}

/// The slot above the undercut is milled whatever engraves: no line that a ball at hand was meant for.
TEST(TSlots, ABallAtHandEngravesNoNeck) {
  std::vector<std::string> tools = kTools;
  tools.emplace_back("ball:6");
  const PlanResult planned = plan_part(open_slot(), with(tools));
  const CheckResult read = check_program(open_slot(), planned.program, "slot.ngc", with(tools));
  EXPECT_EQ(verdict_of(planned.findings), Verdict::kClean) << faults_of(planned.findings);
  EXPECT_EQ(verdict_of(read.findings), Verdict::kClean) << faults_of(read.findings);
  EXPECT_TRUE(read.findings.conditions.empty());
}

TEST(TSlots, TheDiscGoesDownInAPocketThatIsFinished) {
  const Part part =
      drawn(kPlate + circle("POCKET_D12", {30, 30}, 10.2) + line("TSLOT_D12", {30, 30}, {100, 30}));
  auto options = with({"endmill:12:length=30", "tslot:20:length=8:shank=10"});
  options.shop.finish = "all";
  const PlanResult result = plan_part(part, options);
  EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << faults_of(result.findings);
}

TEST(TSlots, AProgramWrittenByHandIsClean) {
  const Findings once = checked(open_slot(), kNeck + kDisc);
  EXPECT_EQ(verdict_of(once), Verdict::kClean) << faults_of(once);
  const Findings back = checked(open_slot(), kNeck + kDiscDown + "G1 Z-12 F300\nX112 F400\nX-12\nG0 Z10\n");
  EXPECT_EQ(verdict_of(back), Verdict::kClean) << faults_of(back);
}

TEST(TSlots, ADiscTwentyMicrometresTooLowTooHighOrAsideIsFaulty) {
  const Findings low = checked(open_slot(), kNeck + kDiscDown + "G1 Z-12.02 F300\nX112 F400\nG0 Z10\n");
  EXPECT_TRUE(has(low, FaultKind::kGouge)) << faults_of(low);
  EXPECT_NEAR(low.all.gouge_mm, 0.02, 1e-6);
  const Findings high = checked(open_slot(), kNeck + kDiscDown + "G1 Z-11.98 F300\nX112 F400\nG0 Z10\n");
  EXPECT_NEAR(high.all.gouge_mm, 0.018, 1e-6);
  EXPECT_THAT(faults_of(high), HasSubstr("goes 0.018 mm into what stands over the undercut of TSLOT_D12"));
  const Findings aside =
      checked(open_slot(),
              kNeck + "M5\nT2 M6\nG43 H2\nM3 S1590\nG0 Z10\nX-12 Y30.02\nG1 Z-12 F300\nX112 F400\nG0 Z10\n");
  EXPECT_TRUE(has(aside, FaultKind::kGouge)) << faults_of(aside);
  EXPECT_TRUE(has(aside, FaultKind::kUncut)) << faults_of(aside);
}

TEST(TSlots, ADiscThatRisesSinksOrRunsInARapidUnderWhatStandsIsFaulty) {
  const Findings lifted =
      checked(open_slot(), kNeck + kDiscDown + "G1 Z-12 F300\nX50 F400\nZ-11.9\nZ-12\nX112\nG0 Z10\n");
  EXPECT_THAT(faults_of(lifted), HasSubstr("goes 0.098 mm into what stands over the undercut"));
  const Findings retracted =
      checked(open_slot(), kNeck + kDiscDown + "G1 Z-12 F300\nX50 F400\nG0 Z10\nX112\n");
  EXPECT_TRUE(has(retracted, FaultKind::kGouge)) << faults_of(retracted);
  EXPECT_TRUE(has(retracted, FaultKind::kRapidInMaterial)) << faults_of(retracted);
  const Findings plunged = checked(
      open_slot(),
      kNeck + "M5\nT2 M6\nG43 H2\nM3 S1590\nG0 Z10\nX50 Y30\nG1 Z-12 F300\nX112 F400\nX-12\nG0 Z10\n");
  EXPECT_TRUE(has(plunged, FaultKind::kGouge)) << faults_of(plunged);
  EXPECT_TRUE(has(plunged, FaultKind::kPlungeTooFast)) << faults_of(plunged);
  const Findings rapid = checked(open_slot(), kNeck + kDiscDown + "G1 Z-12 F300\nX112 F400\nG0 X-12\nZ10\n");
  EXPECT_TRUE(has(rapid, FaultKind::kRapidInMaterial)) << faults_of(rapid);
}

TEST(TSlots, WithoutTheSlotForTheNeckBeforeItItIsFaulty) {
  const Findings without = checked(open_slot(), kDisc);
  EXPECT_THAT(faults_of(without), HasSubstr("The neck above the disc runs into material"));
  EXPECT_THAT(faults_of(without), HasSubstr("TSLOT_D12_neck: nothing is cut"));
  const Findings after = checked(open_slot(), kDisc + kNeck);
  EXPECT_TRUE(has(after, FaultKind::kHolder)) << faults_of(after);
  // The neck of 10 mm passes between walls 11 mm apart, where 12 mm are asked for: the disc cleared the floor below them alone.
  std::vector<std::string> tools = kTools;
  tools.push_back("endmill:10.1:length=30");
  std::string narrow = kNeck;
  narrow.replace(narrow.find("T1 M6\nG43 H1"), 12, "T3 M6\nG43 H3");
  const Findings left = checked(open_slot(), narrow + kDisc, tools);
  EXPECT_THAT(faults_of(left), HasSubstr("TSLOT_D12_neck: ")) << faults_of(left);
}

TEST(TSlots, ALowerDiscLeavesTheUndercutTooLow) {
  std::vector<std::string> tools = kTools;
  tools.push_back("tslot:20:length=7:shank=10");
  // The first is called, too, and cuts nothing: what the part asks for is the undercut of its disc.
  std::string disc = kDisc;
  disc.replace(disc.find("T2 M6\nG43 H2"), 12, "T3 M6\nG43 H3");
  disc = kDiscDown + "G1 Z5 F300\nG0 Z10\n" + disc;
  const Findings left = checked(open_slot(), kNeck + disc, tools);
  EXPECT_THAT(faults_of(left), HasSubstr("uncut: TSLOT_D12: ")) << faults_of(left);
  // A narrower one leaves its sides.
  tools.back() = "tslot:19:length=8:shank=10";
  EXPECT_TRUE(has(checked(open_slot(), kNeck + disc, tools), FaultKind::kUncut));
}

TEST(TSlots, WhatEndsInTheMaterialIsLeftTheWayItWasEntered) {
  const Part part = drawn(kPlate + line("TSLOT_D12", {60, 30}, {0, 30}));
  const PlanResult result = plan_part(part, with(kTools));
  EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << faults_of(result.findings);
  const auto change = result.program.find("T2 M6");
  EXPECT_THAT(result.program.substr(change),
              HasSubstr("X-12 Y30\nZ1\nG1 Z-12 F300\nX60 F1000\nX-12\nG0 Z10\n"));
  const std::string neck =
      "T1 M6\nG43 H1\nM3 S2650\nG0 Z10\nX-8 Y30\nG1 Z-6 F300\nX60 F800\nX-8\nG1 Z-12 F300\nX60 F800\nX-8\nG0 "
      "Z10\n";
  const Findings right = checked(part, neck + kDiscDown + "G1 Z-12 F300\nX60 F400\nX-12\nG0 Z10\n");
  EXPECT_EQ(verdict_of(right), Verdict::kClean) << faults_of(right);
  const Findings far = checked(part, neck + kDiscDown + "G1 Z-12 F300\nX60.02 F400\nX-12\nG0 Z10\n");
  EXPECT_TRUE(has(far, FaultKind::kGouge)) << faults_of(far);
  const Findings up = checked(part, neck + kDiscDown + "G1 Z-12 F300\nX60 F400\nG0 Z10\n");
  EXPECT_TRUE(has(up, FaultKind::kGouge)) << faults_of(up);
}

TEST(TSlots, AHoleWideEnoughAtAnEndLetsTheDiscDown) {
  const std::string slot = line("TSLOT_D12", {25, 30}, {75, 30});
  const PlanResult result =
      plan_part(drawn(kPlate + circle("POCKET_D12", {25, 30}, 10.5) + slot), with(kTools));
  EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << faults_of(result.findings);
  EXPECT_THAT(refusal(drawn(kPlate + circle("POCKET_D12", {25, 30}, 10) + slot), kTools),
              HasSubstr("in a pocket or hole at least 20.2 mm wide and down to z -12"));
  EXPECT_THAT(refusal(drawn(kPlate + circle("POCKET_D11", {25, 30}, 10.5) + slot), kTools),
              HasSubstr("at neither end of its line"));
}

TEST(TSlots, WhatIsMissingIsSaidInOneLine) {
  EXPECT_THAT(refusal(open_slot(), {"endmill:12:length=30"}),
              HasSubstr("it is a T-slot and needs a T-slot cutter"));
  EXPECT_THAT(
      refusal(open_slot(), {"tslot:20:length=8:shank=10"}),
      HasSubstr(
          "give an end mill with a flat end of 10.2 mm or more, under 20 mm, whose flutes reach 12 mm, for "
          "example --tool endmill:11:length=12"));
  EXPECT_THAT(refusal(open_slot(), {"endmill:12:length=10", "tslot:20:length=8:shank=10"}),
              HasSubstr("whose flutes reach 12 mm"));
  EXPECT_THAT(refusal(drawn(kPlate + line("TSLOT_D8", {0, 30}, {100, 30})), kTools),
              HasSubstr("nothing would stand over it"));
  EXPECT_THAT(refusal(drawn(kPlate + box("TSLOT_D12", 20, 20, 80, 40)), kTools),
              HasSubstr("runs along an open line"));
}

/// The disc fits between floor and roof as exactly as the digits of any control say; stock is left nowhere.
TEST(TSlots, DigitsOfInchesAndStockToLeaveChangeNoUndercut) {
  for (const double depth : {9.0, 10.0, 11.0, 12.0, 13.0, 13.3, 14.7}) {
    auto options = with(kTools);
    options.post.inch = true;
    options.post.decimals = 4;
    options.allowance = 0.2;
    const Part part = drawn(kPlate + line("TSLOT_D" + std::to_string(depth), {0, 30}, {100, 30}));
    const PlanResult result = plan_part(part, options);
    EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << depth << faults_of(result.findings);
  }
}

/// Where they cross the disc of the higher one runs over the roof of the lower one, in what it takes away itself.
TEST(TSlots, SlotsOfDifferentDepthsMayCross) {
  const Part part =
      drawn(kPlate + line("TSLOT_D12", {0, 30}, {100, 30}) + line("TSLOT_D14", {50, 0}, {50, 60}));
  const std::string program = plan_part(part, with(kTools)).program;
  const auto with_disc_at = [&](const std::string& from, const std::string& to) {
    std::string changed = program;
    std::size_t at = changed.find("T2 M6");
    while ((at = changed.find(from, at)) != std::string::npos) {
      // Whole words alone: "Z-12.9" is another height.
      const std::size_t end = at + from.size();
      const bool is_word = end == changed.size() || changed[end] == ' ' || changed[end] == '\n';
      if (is_word) changed.replace(at, from.size(), to);
      at += is_word ? to.size() : from.size();
    }
    return check_program(part, changed, "other.ngc", with(kTools)).findings;
  };
  const Findings right = with_disc_at("Z-12", "Z-12.0");
  EXPECT_EQ(verdict_of(right), Verdict::kClean) << faults_of(right);
  // At the height of the other one each goes into the part, but for where they cross.
  EXPECT_TRUE(has(with_disc_at("Z-14", "Z-12.0"), FaultKind::kGouge));
  EXPECT_TRUE(has(with_disc_at("Z-12", "Z-14"), FaultKind::kGouge));
}

/// To a part without an undercut the same program is as wrong as it was.
TEST(TSlots, WhereNoUndercutIsAskedForADiscUnderWhatStandsIsAGouge) {
  const Part plain = drawn(kPlate + line("ENGRAVE_D12", {0, 30}, {100, 30}));
  const Findings findings = checked(plain, kNeck + kDisc);
  EXPECT_TRUE(has(findings, FaultKind::kGouge)) << faults_of(findings);
  EXPECT_NEAR(findings.all.gouge_mm, 4, 0.1);
}

}  // namespace
}  // namespace clearcut::pipeline
