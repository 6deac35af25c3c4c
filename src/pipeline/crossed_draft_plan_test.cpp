// A pocket with leaning walls that an upright one crosses, against heights of its own.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/random.h"
#include "pipeline/check.h"
#include "pipeline/run.h"
#include "pipeline/test_drawings.h"
#include "read/job/read_part.h"

namespace clearcut::pipeline {
namespace {

/// mm, from (x, y).
struct Rectangle {
  double x = 0, y = 0, width = 0, height = 0;

  /// How far p lies inside; below 0 outside.
  double inside(Vec2 p) const { return std::min({p.x - x, x + width - p.x, p.y - y, y + height - p.y}); }
  std::string text() const {
    return fmt::format("[[{},{}],[{},{}],[{},{}],[{},{}]]", x, y, x + width, y, x + width, y + height, x,
                       y + height);
  }
};

struct CrossedPockets {
  Rectangle leaning, upright;
  double lean = 0, leaning_depth = 0, upright_depth = 0;

  double height(Vec2 p) const {
    double height = 0;
    if (const double in = leaning.inside(p); in > 0) height = -std::min(leaning_depth, in / std::tan(lean));
    return upright.inside(p) > 0 ? std::min(height, -upright_depth) : height;
  }
  Part part() const {
    return read::read_part_text(
        fmt::format(R"({{"units": "mm", "pockets": [{{"name": "U", "top": 0, "depth": {}, "outer": {}}},
                        {{"name": "L", "top": 0, "depth": {}, "slope_rad": {}, "outer": {}}}]}})",
                    upright_depth, upright.text(), leaning_depth, lean, leaning.text()),
        "crossed.json", {});
  }
};

CrossedPockets random_pockets(Random& random) {
  const auto tenths = [&](double low, double high) {
    return std::round(random.between(low, high) * 10) / 10;
  };
  CrossedPockets pockets;
  pockets.leaning = {0, 0, tenths(14, 20), tenths(14, 20)};
  pockets.upright = {tenths(-5, 5), tenths(5, 10), tenths(9, 14), tenths(9, 14)};
  pockets.lean = random.between(0.05, 0.4);
  pockets.leaning_depth = tenths(2, 4);
  pockets.upright_depth = tenths(1, 4);
  return pockets;
}

/// mm; lowest tip of a flat cutter that comes over p, give or take `spare` mm of its radius.
double tip_over(Vec2 p, const Toolpath& toolpath, double radius) {
  double lowest = 0;
  for (const Section& section : toolpath.sections) {
    for (const Move& move : section.moves) {
      const double off =
          move.path.from == move.path.to ? distance(move.path.from, p) : distance(move.path, p);
      if (!is_rapid(move.kind) && off < radius) lowest = std::min(lowest, std::max(move.z_from, move.z_to));
    }
  }
  return lowest;
}

TEST(CrossedDraft, PlansAreNoGougesAndWrongOnesAre) {
  Random random(44);
  constexpr double kRadius = 2, kSpare = 0.01, kGrid = 0.4;
  for (int i = 0; i < 4; ++i) {
    const CrossedPockets pockets = random_pockets(random);
    PlanOptions options = with({"endmill:4"});
    options.strategy = i % 2 ? "zigzag" : "contour";
    options.accept = {"out-of-reach"};
    const Part part = pockets.part();
    const PlanResult plan = plan_part(part, options);
    EXPECT_FALSE(has(plan.findings, FaultKind::kGouge)) << i << faults_of(plan.findings) << plan.program;
    for (double x = -6; x < 26; x += kGrid) {
      for (double y = -2; y < 26; y += kGrid) {
        const Vec2 p{x, y};
        double lowest = 0;  // of the part, about there
        for (const Vec2 aside :
             {Vec2{}, Vec2{kSpare, 0}, Vec2{-kSpare, 0}, Vec2{0, kSpare}, Vec2{0, -kSpare}})
          lowest = std::min(lowest, pockets.height(p + aside));
        EXPECT_GT(tip_over(p, plan.toolpath, kRadius - kSpare), lowest - 0.02) << i << " " << x << " " << y;
      }
    }
    // Of a part in which less is to be cut the same program is a gouge, also where both pockets are one.
    for (const bool leans_more : {false, true}) {
      CrossedPockets less = pockets;
      if (leans_more)
        less.lean += 0.03;
      else
        less.upright.width -= 0.1;
      const auto checked = check_program(less.part(), plan.program, "less", options, Dialect::kLinuxCnc);
      EXPECT_TRUE(has(checked.findings, FaultKind::kGouge)) << i << leans_more;
    }
  }
}

/// A move of 200 mm along a wall is looked at in pieces: only those beside the crossing need the test of every place.
TEST(CrossedDraft, LongMovesAlongWallsBesideTheCrossingAreNoGouges) {
  CrossedPockets pockets;
  pockets.leaning = {0, 0, 20, 30};
  pockets.upright = {-100, 8, 220, 14};
  pockets.lean = 0.4;
  pockets.leaning_depth = pockets.upright_depth = 4;
  PlanOptions options = with({"endmill:6"});
  options.strategy = "contour";
  options.accept = {"out-of-reach"};
  const PlanResult plan = plan_part(pockets.part(), options);
  EXPECT_FALSE(has(plan.findings, FaultKind::kGouge)) << faults_of(plan.findings);
  CrossedPockets less = pockets;
  less.upright.height -= 0.1;
  const auto checked = check_program(less.part(), plan.program, "less", options, Dialect::kLinuxCnc);
  EXPECT_TRUE(has(checked.findings, FaultKind::kGouge));
}

/// How far the rounded end comes below the part over p at most, mm; its corner is `round` wide.
double gouge_over(Vec2 p, const CrossedPockets& pockets, const Toolpath& toolpath, double radius,
                  double round) {
  double deepest = 0;
  for (const Section& section : toolpath.sections) {
    for (const Move& move : section.moves) {
      const double off =
          move.path.from == move.path.to ? distance(move.path.from, p) : distance(move.path, p);
      if (is_rapid(move.kind) || off >= radius) continue;
      const double in = std::max(0.0, off - (radius - round));
      const double over = round - std::sqrt(round * round - in * in);
      deepest = std::max(deepest, pockets.height(p) - std::max(move.z_from, move.z_to) - over);
    }
  }
  return deepest;
}

TEST(CrossedDraft, RoundedEndsTouchWallsThatTheyCannotKeepOff) {
  constexpr double kRadius = 2, kRound = 1, kGrid = 0.8;
  const CrossedPockets pockets{{0, 0, 14.5, 22.4}, {5.5, -3.7, 15.6, 15.7}, 0.7854, 2.4, 2.8};
  PlanOptions options = with({"bullnose:4:corner=1"});
  options.strategy = "contour";
  options.accept = {"out-of-reach"};
  const PlanResult plan = plan_part(pockets.part(), options);
  EXPECT_EQ(verdict_of(plan.findings), Verdict::kClean) << faults_of(plan.findings);
  for (double x = -6; x < 26; x += kGrid)
    for (double y = -4; y < 28; y += kGrid)
      EXPECT_LT(gouge_over({x, y}, pockets, plan.toolpath, kRadius - 0.01, kRound), 0.02) << x << " " << y;
}

TEST(CrossedDraft, RoundedEndsTouchWallsUnderAPocketThatIsWiderThanThey) {
  const auto planned = [](double beside) {
    const Rectangle wide{-beside, -beside, 24 + 2 * beside, 22 + 2 * beside};
    const std::string text =
        fmt::format(R"({{"units": "mm", "pockets": [{{"name": "P", "top": 0, "depth": 2, "outer": {}}},
                        {{"name": "L", "top": -2, "depth": 3, "slope_rad": 0.6, "outer": {}}}]}})",
                    wide.text(), Rectangle{0, 0, 24, 22}.text());
    PlanOptions options = with({"ball:4"});
    options.strategy = "contour";
    options.accept = {"out-of-reach"};
    return plan_part(read::read_part_text(text, "under.json", {}), options).findings;
  };
  const Findings apart = planned(5);
  EXPECT_EQ(verdict_of(apart), Verdict::kClean) << faults_of(apart);
  // Beside walls that stand above, it keeps off all of them.
  const Findings near = planned(0.2);
  EXPECT_FALSE(has(near, FaultKind::kGouge)) << faults_of(near);
}

TEST(CrossedDraft, WhatIsGainedDeepDownAloneIsCutFromTheTop) {
  const CrossedPockets pockets{{0, 0, 16, 22.3}, {11.8, 5.5, 19.6, 11}, 0.7854, 3.9, 5.2};
  PlanOptions options = with({"endmill:4"});
  options.strategy = "contour";
  options.accept = {"out-of-reach"};
  const PlanResult plan = plan_part(pockets.part(), options);
  EXPECT_EQ(verdict_of(plan.findings), Verdict::kClean) << faults_of(plan.findings);
}

}  // namespace
}  // namespace clearcut::pipeline
