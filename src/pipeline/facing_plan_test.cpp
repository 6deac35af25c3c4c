// Stock that stands over the part: faced off first, and certified.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

#include "pipeline/check.h"
#include "pipeline/test_drawings.h"

namespace clearcut::pipeline {
namespace {

Part with_stock_up_to(double top) {
  Part part = drawn(box("POCKET_D4", 10, 8, 50, 30) + circle("HOLE_D6", {65, 19}, 3));
  part.stock = Stock{{{0, 0}, {75, 40}}, -10, top};
  return part;
}

TEST(Facing, OversizeStockComesOffBeforeAnythingElse) {
  const PlanResult result = plan_part(with_stock_up_to(1.5), with({"endmill:5"}));
  EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << faults_of(result.findings);
  ASSERT_EQ(result.part.workplan.size(), 3u);
  const Feature& face = feature_of(result.part, result.part.workplan.front());
  EXPECT_EQ(face.kind, FeatureKind::kPlanarFace);
  EXPECT_NEAR(face.top_z, 1.5, 1e-12);
  EXPECT_NEAR(face.floor_z, 0, 1e-12);
}

TEST(Facing, TheWidestCutterFacesAndStockThatEndsAtTheTopIsLeftAlone) {
  const PlanResult result = plan_part(with_stock_up_to(0.8), with({"endmill:5", "facemill:40"}));
  EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << faults_of(result.findings);
  EXPECT_EQ(tool_of(result.part, result.part.workplan.front()).kind, ToolKind::kFaceMill);
  EXPECT_EQ(plan_part(with_stock_up_to(0), with({"endmill:5"})).part.workplan.size(), 2u);
}

/// The outline lies on a face that was cut before, the kerf beside the outline reaches beyond this face.
TEST(Facing, ProfilesBeginAtTheHighestMaterialOverTheirKerfs) {
  PlanOptions options = with({"endmill:6"});
  options.stepdown = 1.5;
  const std::string sheet =
      box("STOCK_D12", 0, 0, 100, 70) + box("FACE_D1", 0, 0, 60, 70) + box("PROFILE_D4", 20, 20, 57, 50);
  const PlanResult result = plan_part(drawn(sheet), options);
  EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << faults_of(result.findings);
}

/// What lies beside a face or an isolated piece has walls: what another program cuts of them is a gouge, and their corners are out of
/// reach.
TEST(Facing, WallsBesideAFaceStand) {
  const PlanOptions options = with({"endmill:3"});
  for (const auto& [layer, open] :
       {std::pair("POCKET_D2", "FACE_D3"), std::pair("INSIDE_D2", "FACE_D3"),
        std::pair("POCKET_D5", "FACE_D3"), std::pair("POCKET_D2", "ISOLATE_D3_W4"),
        std::pair("INSIDE_D2", "ISOLATE_D3_W4")}) {
    const std::string face = box(open, 70, 0, 90, 20);
    const Part part = drawn(box(layer, 0, 0, 30, 22) + face);
    const PlanResult result = plan_part(part, options);
    EXPECT_TRUE(result.findings.all.clean) << layer << " " << open << faults_of(result.findings);
    const std::string wider = plan_part(drawn(box(layer, 0, 0, 31, 22) + face), options).program;
    EXPECT_TRUE(has(check_program(part, wider, "wider.ngc", options).findings, FaultKind::kGouge)) << layer;
  }
}

/// Engraved lines beside a deeper face are no deeper than drawn, and stand apart from its cutter.
TEST(Facing, LinesBesideADeeperFaceKeepTheirDepth) {
  const PlanOptions options = with({"endmill:6", "ball:2"});
  const std::string beside = box("FACE_D1", 60, 0, 90, 20);
  const auto gouges = [&](const std::string& asked, const std::string& cut) {
    const std::string program = plan_part(drawn(cut + beside), options).program;
    return has(check_program(drawn(asked + beside), program, "other.ngc", options).findings,
               FaultKind::kGouge);
  };
  const auto lines = [](const std::string& layer) {
    return circle(layer, {20, 10}, 8) + "0\nLINE\n8\n" + layer + "\n10\n0\n20\n0\n11\n30\n21\n-5\n";
  };
  EXPECT_TRUE(gouges(lines("ENGRAVE_D0.5"), lines("ENGRAVE_D0.8")));
  EXPECT_FALSE(gouges(lines("ENGRAVE_D0.5"), lines("ENGRAVE_D0.5")));
}

/// Floors beside a deeper face or isolated piece are kept, too.
TEST(Facing, FloorsBesideADeeperFaceStand) {
  const PlanOptions options = with({"endmill:3", "drill:5"});
  for (const char* open : {"FACE_D3", "ISOLATE_D3_W4"}) {
    const std::string beside = box(open, 70, 0, 90, 20);
    const auto gouges = [&](const std::string& asked, const std::string& cut) {
      const std::string program = plan_part(drawn(cut + beside), options).program;
      return has(check_program(drawn(asked + beside), program, "other.ngc", options).findings,
                 FaultKind::kGouge);
    };
    EXPECT_TRUE(gouges(circle("DRILL_D1", {10, 10}, 2.5), circle("DRILL_D1.3", {10, 10}, 2.5))) << open;
    EXPECT_TRUE(gouges(box("FACE_D1", 0, 0, 30, 20), box("FACE_D1.3", 0, 0, 30, 20))) << open;
    EXPECT_FALSE(gouges(box("FACE_D1", 0, 0, 30, 20), box("FACE_D1", 0, 0, 30, 20))) << open;
  }
}

/// Pockets and cut-outs at random distances and turns beside a face are made as without it.
TEST(Facing, WhatLiesBesideAFaceIsMadeAsWithoutIt) {
  const char* const asked = std::getenv("CLEARCUT_RANDOM_PARTS");
  const int parts = asked ? std::atoi(asked) : 24;
  for (int seed = 0; seed < parts; ++seed) {
    std::mt19937 random(static_cast<unsigned>(seed));
    std::uniform_real_distribution<double> turn(0, kPi), gap(0.3, 12), size(8, 16);
    const double a = turn(random), half = size(random);
    std::vector<BulgeVertex> corners;
    for (int i = 0; i < 4; ++i) corners.push_back({direction_of(a + i * kPi / 2 + (i % 2) * 0.4) * half});
    const double from = half + gap(random);
    const std::string layer = seed % 2 == 0 ? "POCKET_D2" : "INSIDE_D2";
    const PlanOptions options = with({"endmill:3"});
    const Part part = drawn(outline(layer, corners) + box("FACE_D2", from, -20, from + 25, 20));
    const PlanResult result = plan_part(part, options);
    EXPECT_TRUE(result.findings.all.clean) << seed << faults_of(result.findings);
  }
}

class FacesOfRandomOutlines : public ::testing::TestWithParam<int> {};

/// A face on a random outline; dense samples of it know nothing of offsets, strategies or the certificate.
TEST_P(FacesOfRandomOutlines, AreFacedAllOver) {
  for (int round = GetParam(); round < 1000; round += 4) {
    std::mt19937 random(static_cast<unsigned>(round));
    std::uniform_real_distribution<double> away(8, 25), share(0.1, 0.9), place(-26, 26);
    std::vector<BulgeVertex> corners;
    const int count = 3 + round % 9;
    for (int i = 0; i < count; ++i)
      corners.push_back({direction_of(2 * kPi * (i + share(random)) / count) * away(random)});
    PlanOptions options = with({"endmill:8"});
    options.strategy = round % 2 == 0 ? "zigzag" : "contour";
    const Part part = drawn(outline("FACE_D1", corners));
    const PlanResult result = plan_part(part, options);
    EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << round << "\n" << faults_of(result.findings);
    std::vector<Vec2> path;
    for (const Section& section : result.toolpath.sections) {
      for (const Move& move : section.moves) {
        ASSERT_GE(std::min(move.z_from, move.z_to), -1.0005);
        if (is_rapid(move.kind) || std::max(move.z_from, move.z_to) > -0.999) continue;
        const int steps = 1 + static_cast<int>(move.path.length() / 0.1);
        for (int i = 0; i <= steps; ++i) path.push_back(move.path.at(static_cast<double>(i) / steps));
      }
    }
    for (int i = 0; i < 100; ++i) {
      const Vec2 p{place(random), place(random)};
      if (!contains(part.features.front().target, p)) continue;
      double nearest = HUGE_VAL;
      for (const Vec2 q : path) nearest = std::min(nearest, std::hypot(p.x - q.x, p.y - q.y));
      ASSERT_LE(nearest, 4.01) << round << " at " << p.x << " " << p.y;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Quarters, FacesOfRandomOutlines, ::testing::Range(0, 4));

/// Three arcs meet where none of them was drawn as it runs now: what they leave there is a rest as any other.
TEST(Facing, AdaptiveCutsLeaveNoRestWhereJoinedArcsRunBesideWhatTheyWere) {
  auto options = with({"endmill:16", "endmill:4"});
  options.strategy = "adaptive";
  const auto result = plan_part(
      drawn(box("STOCK_D10", -3.66, -3.66, 48.27, 32.73) + box("FACE_D2.5", -3.66, -3.66, 48.27, 32.73)),
      options);
  EXPECT_EQ(faults_of(result.findings), "");
}

}  // namespace
}  // namespace clearcut::pipeline
