// Relief in inside corners: what has square corners fits, and nothing else is cut.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "pipeline/test_drawings.h"

namespace clearcut::pipeline {
namespace {

using ::testing::HasSubstr;

/// mm. What the relief is wider than the cutter, and a program's digits.
constexpr double kWider = 0.022;

PlanResult planned(const std::string& entities, const std::string& dogbones,
                   const std::string& tool = "endmill:6") {
  PlanOptions options = with({tool});
  options.shop.dogbones = dogbones;
  options.accept = {"out-of-reach"};
  return plan_part(drawn(entities), options);
}

/// mm; how near the tip's axis comes to p while it cuts at depth z.
double nearest(const Toolpath& toolpath, Vec2 p, double z) {
  double least = HUGE_VAL;
  for (const Section& section : toolpath.sections) {
    for (const Move& move : section.moves) {
      if (is_rapid(move.kind) || std::max(move.z_from, move.z_to) > z + 0.001) continue;
      if (move.path.box().distance_to(p) > least) continue;
      const int count = 1 + static_cast<int>(move.path.length() / 0.002);
      for (int i = 0; i <= count; ++i)
        least = std::min(least, norm(move.path.at(static_cast<double>(i) / count) - p));
    }
  }
  return least;
}

std::string told(const PlanResult& result) {
  std::string text;
  for (const Diagnostic& one : result.part.diagnostics.items()) text += one.where + ": " + one.what + "\n";
  return text;
}

TEST(Dogbones, TheCutterReachesEveryCornerOfAPocketAlongItsBisector) {
  const PlanResult result = planned(box("POCKET_D3", 0, 0, 40, 30), "corner");
  EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << faults_of(result.findings);
  for (const Vec2 corner : {Vec2{0, 0}, {40, 0}, {40, 30}, {0, 30}}) {
    const Vec2 inwards = unit(Vec2{20, 15} - corner);
    const double bisector = std::sqrt(0.5);
    const Vec2 bone =
        corner + Vec2{std::copysign(bisector, inwards.x), std::copysign(bisector, inwards.y)} * 3;
    EXPECT_LE(nearest(result.toolpath, bone, -3), kWider);
    EXPECT_LE(nearest(result.toolpath, corner, -3), 3.0005) << "the corner itself is cut";
    EXPECT_GE(nearest(result.toolpath, corner, -3), 3 - kWider);
  }
  EXPECT_THAT(told(result), HasSubstr("4 dogbones for a cutter of 6 mm at "));
  EXPECT_FALSE(has(result.findings, FaultKind::kGouge));
}

TEST(Dogbones, TBonesLieBeyondTheShorterWall) {
  const PlanResult result = planned(box("POCKET_D3", 0, 0, 40, 30), "t-bone");
  EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << faults_of(result.findings);
  for (const Vec2 bone : {Vec2{0, 3}, {40, 3}, {40, 27}, {0, 27}})
    EXPECT_LE(nearest(result.toolpath, bone, -3), kWider);
  EXPECT_THAT(told(result), HasSubstr("4 T-bones"));
}

TEST(Dogbones, ProfilesHaveThemWhereTheirCornersAreInside) {
  const PlanResult inside = planned(box("INSIDE_D4", 0, 0, 40, 30), "corner");
  EXPECT_EQ(verdict_of(inside.findings), Verdict::kClean) << faults_of(inside.findings);
  EXPECT_LE(nearest(inside.toolpath, {0, 0}, -4), 3.0005);
  // An L: of its six corners one is inside the cutter's side.
  const PlanResult outside = planned(
      outline("PROFILE_D4", {{{0, 0}}, {{60, 0}}, {{60, 20}}, {{20, 20}}, {{20, 50}}, {{0, 50}}}), "corner");
  EXPECT_EQ(verdict_of(outside.findings), Verdict::kClean) << faults_of(outside.findings);
  EXPECT_THAT(told(outside), HasSubstr("1 dogbones for a cutter of 6 mm at 20,20"));
  EXPECT_LE(nearest(outside.toolpath, {20, 20}, -4), 3.0005);
}

TEST(Dogbones, AreNotCutThroughWallsAndThatIsSaid) {
  const PlanResult thin =
      planned(box("POCKET_D3", 0, 0, 40, 30) + box("POCKET_D3", 40.5, 0, 80, 30), "corner");
  EXPECT_THAT(told(thin), HasSubstr("inside corners have no dogbone"));
  EXPECT_EQ(verdict_of(thin.findings), Verdict::kClean) << faults_of(thin.findings);
}

/// Both pockets end at one wall: beyond it the lower one's bones have all of their depth to cut.
TEST(Dogbones, OfAPocketUnderAnotherAreCutFromTheTopBeyondIt) {
  PlanOptions options = with({"endmill:6", "endmill:3"});
  options.shop.dogbones = "corner";
  options.shop.rest = true;
  options.accept = {"out-of-reach"};
  const PlanResult result =
      plan_part(drawn(box("POCKET_D1", 0, 0, 40, 30) + box("POCKET_D2", 10, 0, 24, 20)), options);
  EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << faults_of(result.findings);
  EXPECT_LE(nearest(result.toolpath, {10, 0}, -2), 1.5005);
}

TEST(Dogbones, WithoutThemTheCornersStay) {
  PlanOptions options = with({"endmill:6"});
  const PlanResult plain = plan_part(drawn(box("POCKET_D3", 0, 0, 40, 30)), options);
  EXPECT_GT(nearest(plain.toolpath, {0, 0}, -3), 4.2);
}

/// Each corner that a note counts is cut, whatever its angle.
TEST(Dogbones, OfRandomOutlinesAreClean) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(0, 1);
  int relieved = 0;
  for (int round = 0; round < 150; ++round) {
    std::vector<BulgeVertex> corners;
    const int count = 3 + round % 8;
    for (int i = 0; i < count; ++i)
      corners.push_back(
          {direction_of(2 * kPi * (i + 0.5 * share(random)) / count) * (15 + 20 * share(random))});
    const char* layers[] = {"POCKET_D3", "INSIDE_D3", "PROFILE_D3"};
    const std::string tool = "endmill:" + std::to_string(2 + round % 3);
    const PlanResult result =
        planned(outline(layers[round % 3], corners), round % 2 == 0 ? "corner" : "t-bone", tool);
    EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << round << " " << layers[round % 3] << "\n"
                                                            << told(result) << faults_of(result.findings);
    int cut = 0;
    for (const BulgeVertex& corner : corners)
      cut += nearest(result.toolpath, corner.point, -3) <= (2 + round % 3) / 2.0 + 0.0005 ? 1 : 0;
    for (const Diagnostic& one : result.part.diagnostics.items()) {
      if (one.what.find("bones for a cutter") == std::string::npos) continue;
      EXPECT_GE(cut, std::stoi(one.what)) << round << " " << told(result);
      relieved += std::stoi(one.what);
    }
  }
  EXPECT_GT(relieved, 200);
}

}  // namespace
}  // namespace clearcut::pipeline
