// Plans keep out of clamps: rapids, links and passes go over or round them; work under a clamp is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

#include "pipeline/test_drawings.h"

namespace clearcut::pipeline {
namespace {

using ::testing::HasSubstr;

/// mm; the deepest that a cutter of `radius` comes into the block, by points along the moves.
double deepest_in(const KeepOut& block, const Toolpath& toolpath, double radius) {
  double deepest = 0;
  for (const Section& section : toolpath.sections) {
    for (const Move& move : section.moves) {
      const int steps = 1 + static_cast<int>(move.path.length() / 0.2);
      for (int i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        const Vec2 p = move.path.at(t);
        if (std::min(move.z_from, move.z_to) >= block.top_z) continue;
        if (!move.is_vertical() && move.z_from + t * (move.z_to - move.z_from) >= block.top_z) continue;
        const double dx = std::max({block.plan.min.x - p.x, p.x - block.plan.max.x, 0.0}),
                     dy = std::max({block.plan.min.y - p.y, p.y - block.plan.max.y, 0.0});
        deepest = std::max(deepest, radius - std::hypot(dx, dy));
      }
    }
  }
  return deepest;
}

TEST(Clamps, BetweenPocketsAreCrossedAbove) {
  PlanOptions options = with({"endmill:6"});
  options.keep_outs = {{{{45, -10}, {55, 60}}, 0, 20}};
  const std::string pockets =
      box("STOCK_D10", 0, 0, 100, 50) + box("POCKET_D3", 5, 5, 35, 45) + box("POCKET_D3", 65, 5, 95, 45);
  const PlanResult result = plan_part(drawn(pockets), options);
  EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << faults_of(result.findings);
  EXPECT_EQ(deepest_in(options.keep_outs[0], result.toolpath, 3), 0);
}

TEST(Clamps, OnWhatIsToBeCutAreRefused) {
  PlanOptions options = with({"endmill:6"});
  options.keep_outs = {{{{-10, 10}, {3, 20}}, 0, 20}};
  const std::string face = box("STOCK_D10", 0, 0, 100, 50) + box("FACE_D1", 0, 0, 100, 50);
  try {
    plan_part(drawn(face), options);
    FAIL() << "planned under a clamp";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("stands on 30 mm2 of it"));
  }
}

/// More of them with CLEARCUT_RANDOM_PARTS, never fewer: some of the first are refused.
TEST(Clamps, BesideRandomFacesAndPocketsAreNotTouched) {
  const char* const asked = std::getenv("CLEARCUT_RANDOM_PARTS");
  const int count = std::max(10, asked != nullptr ? std::atoi(asked) : 0);
  int planned = 0;
  for (int round = 0; round < count; ++round) {
    std::mt19937 random(static_cast<unsigned>(round));
    std::uniform_real_distribution<double> along(0, 80), wide(4, 15), over(1, 14), high(0.5, 25);
    PlanOptions options = with({round % 2 == 0 ? "endmill:6" : "endmill:5:length=15:shank=10"});
    options.strategy = round % 3 == 0 ? "contour" : round % 3 == 1 ? "zigzag" : "adaptive";
    const double x = along(random), y = along(random) / 2;
    options.keep_outs = {{{{x, -10}, {x + wide(random), over(random) - 4}}, 0, high(random)},
                         {{{-10, y}, {over(random), y + wide(random)}}, 0, high(random)}};
    const std::string part =
        box("STOCK_D12", 0, 0, 100, 60) + box("FACE_D1", 15, 0, 85, 60) +
        outline("POCKET_D4", {{{25, 15}}, {{75, 10}}, {{80, 50}}, {{50, 30}}, {{20, 45}}});
    try {
      const PlanResult result = plan_part(drawn(part), options);
      ++planned;
      EXPECT_NE(verdict_of(result.findings), Verdict::kFaulty) << round << "\n" << faults_of(result.findings);
      for (const KeepOut& block : options.keep_outs)
        EXPECT_LT(deepest_in(block, result.toolpath, options.tools[0].radius()), 0.01) << round;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("stands on")) << round;
    }
  }
  EXPECT_GT(planned, count / 4);
}

}  // namespace
}  // namespace clearcut::pipeline
