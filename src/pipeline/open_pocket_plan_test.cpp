// Open pockets of several layers: beside their open sides the block stands at its full height.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <optional>
#include <random>
#include <string>
#include <utility>

#include "pipeline/test_drawings.h"
#include "read/job/read_part.h"

namespace clearcut::pipeline {
namespace {

std::string points_of(const std::vector<Vec2>& points) {
  std::string text;
  for (const Vec2 p : points)
    text += (text.empty() ? "[" : ",[") + std::to_string(p.x) + "," + std::to_string(p.y) + "]";
  return "[" + text + "]";
}

/// An open pocket around which the cutter may be anywhere within `beside` mm.
Part open_pocket(const std::vector<Vec2>& corners, double depth, double beside) {
  Box all;
  for (const Vec2 p : corners) all.add(p);
  const Box wide = all.grown(beside);
  const std::string text =
      R"({"name":"open","units":"mm","top":0,"kind":"open_pocket","depth":)" + std::to_string(depth) +
      R"(,"outer":)" + points_of(corners) + R"(,"islands":[],"allowed":[{"outer":)" +
      points_of({wide.min, {wide.max.x, wide.min.y}, wide.max, {wide.min.x, wide.max.y}}) + "}]}";
  return read::read_part_text(text, "open.json", {});
}

const std::vector<Vec2> kEll = {{28, 6}, {28, 0}, {70, 0}, {70, 34}, {13, 34}, {13, 19}, {0, 19}, {0, 6}};

TEST(OpenPockets, LinksOfLowerLayersCrossNothingThatStandsBesideThem) {
  for (const char* strategy : {"contour", "zigzag", "spiral", "adaptive", "tour"}) {
    PlanOptions options = with({"endmill:3"});
    options.strategy = strategy;
    options.stepdown = 1.5;
    const PlanResult result = plan_part(open_pocket(kEll, 3, 100), options);
    EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << strategy << "\n" << faults_of(result.findings);
    for (const Diagnostic& note : result.part.diagnostics.items())
      EXPECT_THAT(note.what, ::testing::Not(::testing::HasSubstr("would meet"))) << strategy;
  }
}

/// mm; lengths of the cuts round a disc in the middle of its block.
double cut_round_a_disc(const char* strategy, std::optional<std::string> stepover, bool& clean) {
  std::vector<Vec2> part;
  for (int i = 0; i < 48; ++i) part.push_back(direction_of(-2 * kPi * i / 48) * 25);
  PlanOptions options = with({"endmill:6"});
  options.strategy = strategy;
  options.stepover = std::move(stepover);
  const std::string text =
      R"({"name":"outside","units":"mm","top":0,"kind":"open_pocket","depth":2,"stock":{"x":[-30,30],"y":[-30,30],"z":[-9,0]},"outer":)" +
      points_of({{-30, -30}, {30, -30}, {30, 30}, {-30, 30}}) + R"(,"islands":[)" + points_of(part) +
      R"(],"allowed":[{"outer":)" + points_of({{-90, -90}, {90, -90}, {90, 90}, {-90, 90}}) +
      R"(,"islands":[)" + points_of(part) + "]}]}";
  const PlanResult result = plan_part(read::read_part_text(text, "outside.json", {}), options);
  clean = verdict_of(result.findings) == Verdict::kClean;
  double length = 0;
  for (const Section& section : result.toolpath.sections) length += feed_length(section);
  return length;
}

/// Contours cut 747 mm when whole rings ran through the air, spirals 595.
TEST(OpenPockets, HardlyAnyCutRoundAPartRunsThroughTheAir) {
  bool clean = false;
  EXPECT_LT(cut_round_a_disc("contour", std::nullopt, clean), 480);
  EXPECT_TRUE(clean);
  EXPECT_LT(cut_round_a_disc("spiral", std::nullopt, clean), 575);
  EXPECT_TRUE(clean);
}

/// Where a stepover is stated, passes that overlap stay, and only those in the air go.
TEST(OpenPockets, AStatedStepoverKeepsItsPasses) {
  bool clean = false;
  const double cut = cut_round_a_disc("contour", "0.3", clean);
  EXPECT_GT(cut, 1000);
  EXPECT_LT(cut, 1200) << "1373 mm with rings in the air";
  EXPECT_TRUE(clean);
}

/// A side that the part touches in its middle alone is open all the same: the cutter comes from there into what narrows towards it.
TEST(OpenPockets, RoundAPartThatTouchesTheirSidesAreClean) {
  std::vector<Vec2> part;
  for (int i = 0; i < 48; ++i) part.push_back(direction_of(-2 * kPi * i / 48) * 30);
  for (const char* strategy : {"contour", "zigzag"}) {
    PlanOptions options = with({"endmill:6"});
    options.strategy = strategy;
    const std::string text =
        R"({"name":"outside","units":"mm","top":0,"kind":"open_pocket","depth":3,"outer":)" +
        points_of({{-30, -30}, {30, -30}, {30, 30}, {-30, 30}}) + R"(,"islands":[)" + points_of(part) +
        R"(],"allowed":[{"outer":)" + points_of({{-90, -90}, {90, -90}, {90, 90}, {-90, 90}}) +
        R"(,"islands":[)" + points_of(part) + "]}]}";
    const PlanResult result = plan_part(read::read_part_text(text, "outside.json", {}), options);
    EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << strategy << "\n" << faults_of(result.findings);
  }
}

/// Stars of random corners; more of them with CLEARCUT_RANDOM_PARTS.
TEST(OpenPockets, RandomOnesAreCleanInSeveralLayers) {
  const char* const asked = std::getenv("CLEARCUT_RANDOM_PARTS");
  const int count = asked != nullptr ? std::atoi(asked) : 12;
  for (int round = 0; round < count; ++round) {
    std::mt19937 random(static_cast<unsigned>(round));
    std::uniform_real_distribution<double> away(12, 40), share(0.1, 0.9), deep(2, 7);
    std::vector<Vec2> corners;
    const int points = 4 + round % 6;
    for (int i = 0; i < points; ++i)
      corners.push_back(direction_of(2 * kPi * (i + share(random)) / points) * away(random));
    PlanOptions options = with({"endmill:4"});
    options.strategy = round % 3 == 0 ? "contour" : round % 3 == 1 ? "zigzag" : "spiral";
    options.stepdown = 2;
    const PlanResult result = plan_part(open_pocket(corners, deep(random), round % 2 == 0 ? 3 : 50), options);
    EXPECT_EQ(result.findings.all.rapid_in_material, 0) << round << "\n" << faults_of(result.findings);
    EXPECT_NE(verdict_of(result.findings), Verdict::kFaulty) << round << "\n" << faults_of(result.findings);
  }
}

}  // namespace
}  // namespace clearcut::pipeline
