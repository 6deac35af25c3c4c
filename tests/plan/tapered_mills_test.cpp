// Pockets cut by tapered end mills: what walls they leave, measured by sampling the cones along the moves; and T-slot cutters, which are
// verified and not planned.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "pipeline/run.h"
#include "pipeline/test_drawings.h"
#include "read/job/read_part.h"

namespace clearcut::pipeline {
namespace {

using ::testing::HasSubstr;

/// mm; lowest surface over p of cones with flat tips of 1.5 mm radius that run along the feed moves, in steps of 0.02 mm.
double cone_height(const Toolpath& toolpath, Vec2 p, double slope) {
  double lowest = 0;
  for (const Section& section : toolpath.sections) {
    for (const Move& move : section.moves) {
      if (is_rapid(move.kind)) continue;
      const int steps = move.is_vertical() ? 1 : std::max(1, static_cast<int>(move.path.length() / 0.02));
      for (int i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        const Vec2 at = move.is_vertical() ? move.path.from : move.path.at(t);
        const double z = move.z_from + (move.z_to - move.z_from) * t;
        lowest = std::min(lowest, z + std::max(0.0, distance(at, p) - 1.5) / slope);
      }
    }
  }
  return lowest;
}

PlanOptions accepted(PlanOptions options) {
  options.accept = {"leaning-walls", "out-of-reach"};
  return options;
}

const char* const kTapered = "tapered:3:taper=5deg:length=20";

TEST(TaperedMills, LeaveUprightWallsLeaningAndSayHowMuch) {
  const Part part = drawn(box("POCKET_D6", 0, 0, 30, 20));
  const PlanResult result = plan_part(part, with({kTapered}));
  EXPECT_EQ(verdict_of(result.findings), Verdict::kConditional) << faults_of(result.findings);
  bool said = false;
  for (const Condition& one : result.findings.conditions)
    said = said ||
           (one.name == "leaning-walls" && one.text.find("0.525 mm more than drawn") != std::string::npos);
  EXPECT_TRUE(said) << "6 mm deep, 5 degrees a side";
  const PlanResult clean = plan_part(part, accepted(with({kTapered})));
  EXPECT_EQ(verdict_of(clean.findings), Verdict::kClean) << faults_of(clean.findings);
}

/// From the edge at the top the walls lean inwards by the taper, nowhere more and nowhere less.
TEST(TaperedMills, CutTheWallsThatTheirFlanksMake) {
  const double slope = std::tan(5 * kPi / 180);
  auto options = accepted(with({kTapered}));
  options.stepdown = 2;
  const PlanResult result = plan_part(drawn(box("POCKET_D6", 0, 0, 30, 20)), options);
  ASSERT_EQ(verdict_of(result.findings), Verdict::kClean) << faults_of(result.findings);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> along(4, 16), inside(0.02, 1.5);
  for (int i = 0; i < 60; ++i) {
    const double d = inside(random);
    const double expected = std::max(-6.0, -d / slope);
    EXPECT_NEAR(cone_height(result.toolpath, {d, along(random)}, slope), expected, 0.01 / slope) << d;
    EXPECT_NEAR(cone_height(result.toolpath, {along(random), 20 - d}, slope), expected, 0.01 / slope) << d;
  }
}

Part drafted(double slope_deg) {
  return read::read_part_text(
      "{\"units\": \"mm\", \"pockets\": [{\"outer\": [[0,0],[30,0],[30,20],[0,20]], \"depth\": 6, "
      "\"slope_rad\": " +
          std::to_string(slope_deg * kPi / 180) + "}]}",
      "drafted.json", {});
}

TEST(TaperedMills, CutWallsOfTheirOwnDraftWithoutScallops) {
  const PlanResult tapered = plan_part(drafted(5), with({kTapered}));
  EXPECT_EQ(verdict_of(tapered.findings), Verdict::kClean) << faults_of(tapered.findings);
  ASSERT_TRUE(tapered.findings.features.at(0).scallop);
  EXPECT_LT(tapered.findings.features[0].scallop->height_mm, 1e-4);
  const PlanResult upright = plan_part(drafted(5), with({"endmill:3"}));
  EXPECT_GT(upright.findings.features.at(0).scallop->height_mm, 0.1);
  const PlanResult more = plan_part(drafted(8), with({kTapered}));
  EXPECT_EQ(verdict_of(more.findings), Verdict::kClean) << faults_of(more.findings);
  // Of layers 1.5 mm apart, or a little less where the plan divides the depth.
  const double most = 1.5 * std::cos(8 * kPi / 180) * (std::tan(8 * kPi / 180) - std::tan(5 * kPi / 180));
  EXPECT_LE(more.findings.features.at(0).scallop->height_mm, most + 1e-6);
  EXPECT_GE(more.findings.features.at(0).scallop->height_mm, 0.9 * most);
}

TEST(TaperedMills, GougeWhereAnUprightMillDoesNot) {
  const Part part = drafted(3);
  const PlanResult upright = plan_part(part, with({"endmill:3"}));
  ASSERT_EQ(verdict_of(upright.findings), Verdict::kClean);
  const Part steep = drafted(5);
  const PlanResult own = plan_part(steep, with({"endmill:3"}));
  const auto tapered = with({"tapered:3:taper=6deg:length=20"});
  const Findings wrong = check_program(steep, own.program, "other.ngc", accepted(tapered)).findings;
  EXPECT_EQ(verdict_of(wrong), Verdict::kFaulty) << "planned for walls of 5 degrees, cut with 6";
  EXPECT_TRUE(has(wrong, FaultKind::kGouge));
}

TEST(TaperedMills, AreRefusedWhereTheirFlanksHaveNoPlace) {
  const auto refused = [](const std::string& entities, const std::vector<std::string>& tools) {
    return refusal(drawn(entities), tools);
  };
  EXPECT_THAT(refused(box("PROFILE_D6", 0, 0, 30, 20), {kTapered}),
              HasSubstr("mills pockets only; give an end mill"));
  EXPECT_THAT(refused(box("POCKET_D25", 0, 0, 30, 20), {kTapered}),
              HasSubstr("the flutes of T1 are 20 mm long"));
  for (const char* bad : {"tapered:3", "tapered:3:taper=5deg", "tapered:3:length=20",
                          "tapered:3:taper=60:length=20", "tapered:3:taper=5:length=20:corner=1"})
    EXPECT_THROW(resolve::parse_tool(bad), InputError) << bad;
}

TEST(TaperedMills, GiveWayToUprightOnes) {
  const PlanResult result =
      plan_part(drawn(box("POCKET_D6", 0, 0, 30, 20) + box("PROFILE_D6", -5, -5, 35, 25)),
                with({"tapered:4:taper=5deg:length=20", "endmill:3"}));
  for (const Section& section : result.toolpath.sections) EXPECT_EQ(section.tool_number, 2);
  EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << faults_of(result.findings);
}

/// The rapid goes down beside a wall of stock that the tip clears and the flanks do not.
TEST(TaperedMills, RapidsOfTheirFlanksInMaterialAreFound) {
  const Part part = drawn(box("STOCK_D20", -10, -10, 40, 30) + box("POCKET_D8", 0, 0, 30, 20));
  const std::string program =
      "G21 G90 G17 G54 G94\nT1 M6\nG43 H1\nS8000 M3\nG0 Z10\nG0 X15 Y10\nG1 Z-8 F200\nG1 X16 F400\nG0 Z10\n"
      "G0 X15.5 Y10\nG0 Z-8\nG0 Z10\nM5\nM2\n";
  const auto rapids = [&](const char* tool) {
    auto options = accepted(with({tool}));
    return has(check_program(part, program, "r.ngc", options).findings, FaultKind::kRapidInMaterial);
  };
  EXPECT_FALSE(rapids("endmill:3"));
  EXPECT_FALSE(rapids(kTapered)) << "its own flanks went there before";
  std::string wider = program;
  const std::string down = "G0 X15.5 Y10\nG0 Z-8";
  wider.replace(wider.find(down), down.size(), "T2 M6\nG43 H2\nS8000 M3\n" + down);
  const auto options = accepted(with({"endmill:3", kTapered}));
  EXPECT_TRUE(has(check_program(part, wider, "r.ngc", options).findings, FaultKind::kRapidInMaterial))
      << "an upright mill cleared the tip's way alone";
}

TEST(TSlotCutters, AreRefusedInPlansAndVerifiedInPrograms) {
  const std::string cutter = "tslot:10:length=4:shank=5";
  const Part part = drawn(box("STOCK_D20", -10, -10, 60, 30) + box("POCKET_D4", 0, 0, 50, 20));
  EXPECT_THAT(refusal(part, {cutter}), HasSubstr("cuts undercuts alone, along lines that say so"));
  const PlanResult milled = plan_part(part, with({"endmill:10"}));
  ASSERT_NE(verdict_of(milled.findings), Verdict::kFaulty);
  const auto checked = [&](const std::string& program) {
    auto options = with({cutter});
    options.accept = {"out-of-reach"};
    return check_program(part, program, "t.ngc", options).findings;
  };
  const std::string undercut =
      "G21 G90 G17 G54 G94\nT1 M6\nG43 H1\nS2000 M3\nG0 Z10\nG0 X25 Y10\nG1 Z-4 F100\nG1 Y20 F200\nG1 "
      "Y10\nG0 Z10\nM5\nM2\n";
  EXPECT_TRUE(has(checked(undercut), FaultKind::kGouge)) << "the disc goes under what stays";
  for (const char* bad : {"tslot:10", "tslot:10:length=4", "tslot:10:length=4:shank=12"})
    EXPECT_THROW(resolve::parse_tool(bad), InputError) << bad;
}

}  // namespace
}  // namespace clearcut::pipeline
