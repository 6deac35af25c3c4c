// V-carving and engraving through the whole way: drawn, planned, certified, and what wrong programs are called.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/error.h"
#include "base/units.h"
#include "pipeline/test_drawings.h"

namespace clearcut::pipeline {
namespace {

using ::testing::HasSubstr;

std::string line(const std::string& layer, Vec2 a, Vec2 b) {
  const auto point = [](int code, Vec2 p) {
    return std::to_string(code) + "\n" + std::to_string(p.x) + "\n" + std::to_string(code + 10) + "\n" +
           std::to_string(p.y) + "\n";
  };
  return "0\nLINE\n8\n" + layer + "\n" + point(10, a) + point(11, b);
}

/// An L, and a D with its bowl.
std::string letters(double wider = 0) {
  return outline("VCARVE", {{{40 - wider, 12 - wider}},
                            {{44 + wider, 12 - wider}},
                            {{44 + wider, 24 - wider}},
                            {{50 + wider, 24 - wider}},
                            {{50 + wider, 28 + wider}},
                            {{40 - wider, 28 + wider}}}) +
         outline("VCARVE", {{{60, 12}}, {{66, 12}, 1.0}, {{66, 28}}, {{60, 28}}}) +
         outline("VCARVE", {{{63, 15}}, {{65, 15}, 0.9}, {{65, 25}}, {{63, 25}}});
}

TEST(VCarving, LettersAreCarvedClean) {
  const PlanResult result = plan_part(drawn(letters()), with({"vbit:60deg:12"}));
  EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << faults_of(result.findings);
  EXPECT_LT(result.findings.all.uncut_thickness_mm, 0.01);
  EXPECT_LE(result.findings.all.gouge_mm, 0.001);
}

TEST(VCarving, AProgramForLettersTwentyMicrometresWiderIsFaulty) {
  const auto options = with({"vbit:60deg:12"});
  const PlanResult wider = plan_part(drawn(letters(0.02)), options);
  const CheckResult wrong = check_program(drawn(letters()), wider.program, "wider.ngc", options);
  EXPECT_TRUE(has(wrong.findings, FaultKind::kGouge)) << faults_of(wrong.findings);
  // 0.02 mm sideways; at the reflex corner its diagonal, straight down on the floor.
  EXPECT_GE(wrong.findings.all.gouge_mm, 0.0195);
  EXPECT_LE(wrong.findings.all.gouge_mm, 0.02 * std::sqrt(2.0) / std::tan(kPi / 6) + 0.001);
  const PlanResult right = plan_part(drawn(letters()), options);
  const CheckResult narrow = check_program(drawn(letters(0.02)), right.program, "narrow.ngc", options);
  EXPECT_TRUE(has(narrow.findings, FaultKind::kUncut)) << faults_of(narrow.findings);
}

TEST(VCarving, ADepthLimitLeavesAFloorThatAMillClears) {
  const std::string text = box("VCARVE_D1.5", 0, 0, 24, 16);
  const PlanResult result = plan_part(drawn(text), with({"vbit:60deg:6", "endmill:3"}));
  EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << faults_of(result.findings);
  ASSERT_EQ(result.part.workplan.size(), 2u);
  EXPECT_EQ(tool_of(result.part, result.part.workplan[0]).kind, ToolKind::kEndMill);
  EXPECT_NEAR(feature_of(result.part, result.part.workplan[1]).floor_z, -1.5, 1e-9);
  EXPECT_THAT(refusal(drawn(text), {"vbit:60deg:6"}), HasSubstr("the floor between them needs an end mill"));
  EXPECT_THAT(refusal(drawn(text), {"endmill:3"}), HasSubstr("V-carving needs a V-bit"));
}

/// From one arm of the axis to the next the bit crosses the floor, of which the levels above have cut the rim alone.
TEST(VCarving, NoPassTakesMoreThanTheStepdown) {
  const std::string star = outline("VCARVE_D3", {{{0, 0}},
                                                 {{-6.285, 5.498}},
                                                 {{-9.163, 2.208}},
                                                 {{-6.103, -0.469}},
                                                 {{-7.656, -2.245}},
                                                 {{-4.432, -5.066}}}) +
                           circle("VCARVE_D3", {-4.582, 1.104}, 0.874);
  for (const double stepdown : {0.3, 0.5, 1.0}) {
    auto options = with({"vbit:60deg:6", "endmill:1.5"});
    options.stepdown = stepdown;
    EXPECT_EQ(faults_of(plan_part(drawn(star), options).findings), "") << stepdown;
  }
}

/// Dots of letters: the tip goes down in the middle alone, in plunges that are no deeper than a pass.
TEST(VCarving, RoundAreasAreGoneDownIntoByTheStepdown) {
  for (const double stepdown : {0.4, 1.0}) {
    auto options = with({"vbit:60deg:6"});
    options.stepdown = stepdown;
    const PlanResult result = plan_part(drawn(circle("VCARVE", {3, 2}, 1.5)), options);
    EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << stepdown << ": " << faults_of(result.findings);
    EXPECT_EQ(result.findings.all.rapid_in_material, 0);
  }
}

/// Its tip cannot stand in the narrow ends of a floor: they are none of its faults. What it can reach is.
TEST(VCarving, ABitWithAFlatTipIsCleanAndAProgramNotDeepEnoughIsNot) {
  const auto triangle = [](const std::string& layer) {
    return drawn(outline(layer, {{{-1.153, 8.551}}, {{-5.097, 1.363}}, {{-1.25, -4.776}}}));
  };
  const auto options = with({"vbit:60deg:12:tip=0.2", "endmill:1.5"});
  for (const char* layer : {"VCARVE", "VCARVE_D2", "VCARVE_D0.6"}) {
    const PlanResult result = plan_part(triangle(layer), options);
    EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << layer << ": " << faults_of(result.findings);
  }
  const PlanResult shallow = plan_part(triangle("VCARVE_D0.5"), options);
  const CheckResult wrong = check_program(triangle("VCARVE_D0.6"), shallow.program, "shallow.ngc", options);
  EXPECT_TRUE(has(wrong.findings, FaultKind::kUncut)) << faults_of(wrong.findings);
}

/// Beside the rim of what the mill has cleared a flat tip goes on until all that it covers is cleared.
TEST(VCarving, AFlatTipLeavesNothingBesideTheMillsRim) {
  const Part part =
      drawn(outline("VCARVE_D0.6", {{{-10.036, -2.395}}, {{-0.846, -6.095}}, {{2.519, -0.319}}}));
  const PlanResult result = plan_part(part, with({"vbit:30deg:6:tip=0.2", "endmill:1.5"}));
  EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << faults_of(result.findings);
}

/// A cone of 60 degrees goes deeper than the one of 90 that is assumed before a bit is chosen.
TEST(VCarving, StockWithoutAThicknessReachesBelowTheBitsTip) {
  const std::string text =
      box("STOCK", 0, 0, 100, 60) + box("VCARVE", 10, 10, 16, 50) + box("VCARVE", 30, 10, 34, 50);
  const PlanResult result = plan_part(drawn(text), with({"vbit:60deg:12"}));
  EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << faults_of(result.findings);
  EXPECT_LT(result.part.stock->z_bottom, -3 * std::sqrt(3.0));
  const std::string thin = box("STOCK_D4", 0, 0, 100, 60) + box("VCARVE", 10, 10, 16, 50);
  EXPECT_THAT(refusal(drawn(thin), {"vbit:60deg:12"}), HasSubstr("mm below the material"));
}

TEST(VCarving, WithoutTheMillsWorkTheFloorIsLeft) {
  const Part part = drawn(box("VCARVE_D1.5", 0, 0, 24, 16));
  const auto options = with({"vbit:60deg:6", "endmill:3"});
  const PlanResult result = plan_part(part, options);
  // The program from the V-bit on.
  const auto change = result.program.find("T1 M6");
  ASSERT_NE(change, std::string::npos);
  const std::string start = "G21\nG17 G40 G49 G54 G80 G90 G91.1 G94\nG64 P0.0005 Q0\n";
  const CheckResult wrong =
      check_program(part, start + result.program.substr(change), "bit_only.ngc", options);
  EXPECT_TRUE(has(wrong.findings, FaultKind::kUncut)) << faults_of(wrong.findings);
}

TEST(Engraving, LinesAreEngravedWithBitsAndBalls) {
  const std::string text = line("ENGRAVE_D0.4", {5, 4}, {85, 4}) + box("ENGRAVE_D0.4", 10, 10, 40, 30);
  for (const char* tool : {"vbit:60deg:6", "vbit:90deg:6:tip=0.2", "ball:3"}) {
    const PlanResult result = plan_part(drawn(text), with({tool}));
    EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << tool << "\n" << faults_of(result.findings);
  }
}

/// A mill that runs along the line instead of the given tip cuts another groove than is meant.
TEST(Engraving, AMillInsteadOfTheGivenTipIsACondition) {
  const Part part = drawn(outline("ENGRAVE_D0.4", {{{0, 0}}, {{30, 0}}, {{30, 20}}, {{0, 20}}}));
  for (const char* tip : {"ball:2", "vbit:60deg:6"}) {
    const PlanResult planned = plan_part(part, with({"endmill:6"}));
    const CheckResult alone = check_program(part, planned.program, "mill.ngc", with({"endmill:6"}));
    EXPECT_EQ(verdict_of(alone.findings), Verdict::kClean);
    auto options = with({"endmill:6", tip});
    const CheckResult checked = check_program(part, planned.program, "mill.ngc", options);
    EXPECT_EQ(verdict_of(checked.findings), Verdict::kConditional);
    ASSERT_EQ(checked.findings.conditions.size(), 1u);
    EXPECT_EQ(checked.findings.conditions[0].name, "engraved-by-mill");
    options.accept = {"engraved-by-mill"};
    EXPECT_EQ(verdict_of(check_program(part, planned.program, "mill.ngc", options).findings),
              Verdict::kClean);
  }
}

TEST(Engraving, TooDeepBesideTheLineOrNotAllOfItIsFaulty) {
  const auto options = with({"vbit:60deg:6"});
  const Part part = drawn(line("ENGRAVE_D0.4", {5, 4}, {85, 4}));
  const auto checked = [&](const std::string& other) {
    return check_program(part, plan_part(drawn(other), options).program, "other.ngc", options).findings;
  };
  EXPECT_TRUE(has(checked(line("ENGRAVE_D0.42", {5, 4}, {85, 4})), FaultKind::kGouge));
  EXPECT_TRUE(has(checked(line("ENGRAVE_D0.38", {5, 4}, {85, 4})), FaultKind::kUncut));
  EXPECT_TRUE(has(checked(line("ENGRAVE_D0.4", {5, 4.02}, {85, 4.02})), FaultKind::kGouge));
  EXPECT_TRUE(has(checked(line("ENGRAVE_D0.4", {5, 4}, {84.9, 4})), FaultKind::kUncut));
}

TEST(Tools, ConesAreNamedByTheirAngle) {
  const Tool bit = resolve::parse_tool("vbit:60deg:6:tip=0.2");
  EXPECT_EQ(bit.kind, ToolKind::kVBit);
  EXPECT_NEAR(bit.tip_angle->degrees(), 60, 1e-12);
  EXPECT_NEAR(resolve::parse_tool("vbit:0.25in:60deg").diameter, 6.35, 1e-12);
  EXPECT_NEAR(radius_at(bit, 1), 0.1 + std::tan(kPi / 6), 1e-12);
  EXPECT_THROW(resolve::parse_tool("vbit:6"), InputError);
  EXPECT_THROW(resolve::parse_tool("endmill:6:60deg"), InputError);
  EXPECT_THROW(resolve::parse_tool("vbit:60deg:6:tip=7"), InputError);
  const Part pocket = drawn(box("POCKET_D2", 0, 0, 20, 20));
  EXPECT_THAT(refusal(pocket, {"vbit:60deg:6"}), HasSubstr("clears no floors"));
}

}  // namespace
}  // namespace clearcut::pipeline
