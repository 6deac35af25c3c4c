// Threads about bosses: from drawings to certificates, against the formula of the helix, and wrong ones.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/random.h"
#include "pipeline/test_drawings.h"
#include "post/post.h"

namespace clearcut::pipeline {
namespace {

using ::testing::HasSubstr;

constexpr Vec2 kCenter{5, -3};

/// A boss with a thread in a pocket that is open all round, deep enough for the mill.
std::string boss(const std::string& layer, double diameter, double floor = 20) {
  return box("STOCK_D30", -45, -45, 55, 45) + box(fmt::format("POCKET_D{}", floor), -45, -45, 55, 45) +
         circle(layer, kCenter, diameter / 2);
}

void expect_clean(const PlanResult& result) {
  EXPECT_TRUE(result.findings.all.clean) << faults_of(result.findings) << result.program;
}

/// mm; how far the teeth cut beside the surface of the thread, at dense places of a program, without the verifier's formulas.
double worst_beside(const PlanResult& result, const Thread& thread, int mill) {
  double radius = 0, worst = 0, deepest = thread.diameter;
  std::optional<double> first;
  for (const Tool& tool : result.part.tools)
    if (tool.number == mill) radius = tool.radius();
  for (const Section& section : result.toolpath.sections) {
    if (section.tool_number != mill) continue;
    for (const Move& move : section.moves) {
      if (is_rapid(move.kind) || move.is_vertical()) continue;
      for (int i = 0; i <= 200; ++i) {
        const Vec2 p = move.path.at(i / 200.0) - kCenter;
        const double z = move.z_from + (move.z_to - move.z_from) * i / 200, reach = norm(p) - radius;
        if (z > 0 || reach > thread.diameter / 2 - 0.3) continue;
        double turns = z / thread.pitch - (thread.left_hand ? -1 : 1) * std::atan2(p.y, p.x) / (2 * kPi);
        if (!first && reach > root_diameter(thread) / 2 + 0.003) continue;
        if (!first) first = turns;
        turns -= *first;
        worst = std::max(worst, std::abs(turns - std::round(turns)) * thread.pitch);
        deepest = std::min(deepest, reach);
      }
    }
  }
  EXPECT_NEAR(deepest, root_diameter(thread) / 2, 0.003);
  EXPECT_GT(deepest, root_diameter(thread) / 2 - 1e-3);
  return worst;
}

TEST(ExternalThreads, AreMilledAboutTheirBoss) {
  const Part part = drawn(boss("THREAD_M20_EXTERNAL_D12", 20));
  const auto options = with({"endmill:10", "threadmill:10"});
  const PlanResult result = plan_part(part, options);
  expect_clean(result);
  EXPECT_LT(worst_beside(result, *thread_named("M20"), 2), 0.031);
  // Climb milling goes clockwise about a boss, and so down a right-hand thread.
  EXPECT_THAT(result.program, HasSubstr("G2 "));
  EXPECT_THAT(refusal(part, {"endmill:10"}), HasSubstr("give a thread mill"));
}

/// The boss keeps its width for the thread, also where stock is left on walls.
TEST(ExternalThreads, PocketsWithStockOnTheirWallsKeepTheBoss) {
  const Part part = drawn(box("STOCK_D12", -30, -30, 30, 30) + box("POCKET_D8", -15.5, -15.5, 15.5, 15.5) +
                          circle("THREAD_M12_EXTERNAL_D4", {0, 0}, 6));
  auto options = with({"endmill:4", "threadmill:6"});
  options.shop.finish = "walls";
  expect_clean(plan_part(part, options));
}

TEST(ExternalThreads, AreRefusedWhereTheMillHasNoPlace) {
  const std::vector<std::string> tools{"endmill:10", "threadmill:10"};
  EXPECT_THAT(refusal(drawn(boss("THREAD_M20_EXTERNAL_D12", 20, 13)), tools),
              HasSubstr("cleared down to z -15.125"));
  const std::string narrow = box("STOCK_D30", -45, -45, 55, 45) + circle("POCKET_D20", kCenter, 18) +
                             circle("THREAD_M20_EXTERNAL_D12", kCenter, 10);
  EXPECT_THAT(refusal(drawn(narrow), tools), HasSubstr("all round the root of the thread"));
  EXPECT_THAT(refusal(drawn(boss("THREAD_M20_EXTERNAL_D12", 20) + box("FACE_D13", -45, -45, 55, 45)), tools),
              HasSubstr("its whole boss is faced off"));
  EXPECT_THROW(drawn(boss("THREAD_M20_EXTERNAL_D12", 18)), InputError);
  EXPECT_THROW(drawn(boss("THREAD_M20_EXTERNAL_THRU", 20)), InputError);
}

TEST(ExternalThreads, ManyLieOnTheirHelix) {
  Random random(32);
  const char* const kNames[] = {"M8", "M10x1", "M12", "M16x1.5", "M20", "UNC1-2", "UNF3-8", "M24x2"};
  for (int i = 0; i < 30; ++i) {
    Thread thread = *thread_named(kNames[random.below(8)]);
    const bool left = random.below(2) == 1, rows = random.below(2) == 1;
    const std::string name = thread.name;
    thread = *thread_named(name + (left ? "LH" : ""));
    const std::string layer =
        fmt::format("THREAD_{}{}_EXTERNAL_D{:.2f}", name, left ? "_LH" : "", random.between(4, 12));
    SCOPED_TRACE(layer);
    auto options =
        with({"endmill:10",
              fmt::format("threadmill:{:.2f}{}", random.between(5, 14),
                          rows ? fmt::format(":pitch={}:length={}", thread.pitch, 4 * thread.pitch) : "")});
    if (random.below(2) == 1) options.direction = CutDirection::kConventional;
    options.strategy = "zigzag";
    const double drawn_width = thread.diameter - crest_tolerance(thread) * random.between(0, 0.9);
    const PlanResult result = plan_part(drawn(boss(layer, drawn_width)), options);
    expect_clean(result);
    EXPECT_LT(worst_beside(result, thread, 2), 0.01 * thread.pitch + 0.006);
  }
}

/// One mill cuts both threads about one axis; each is checked by its own moves.
TEST(ExternalThreads, AHoleInTheBossIsThreadedToo) {
  for (const char* inside : {"THREAD_M8_D10", "THREAD_M10x1_D8"}) {
    const double diameter =
        thread_named(std::string(inside).substr(7, std::string(inside).find("_D") - 7))->diameter;
    const Part part = drawn(boss("THREAD_M20_EXTERNAL_D12", 20) + circle(inside, kCenter, diameter / 2));
    ASSERT_EQ(part.features.size(), 3u) << inside;
    const PlanResult result =
        plan_part(part, with({"endmill:10", "threadmill:5", diameter > 8 ? "drill:9" : "drill:6.8"}));
    expect_clean(result);
    EXPECT_EQ(result.toolpath.sections.size(), 4u) << inside;
  }
}

TEST(ExternalThreads, WrongOnesAreFound) {
  const Part part = drawn(boss("THREAD_M20x1.5_EXTERNAL_D8", 20));
  const auto options = with({"endmill:10", "threadmill:12"});
  const PlanResult result = plan_part(part, options);
  expect_clean(result);
  const auto verdict = [&](const auto& change) {
    Toolpath wrong = result.toolpath;
    for (Section& section : wrong.sections) {
      if (section.tool_number == 2) change(section);
    }
    const std::string program = post::write_program(wrong, result.part, options.post);
    return check_program(part, program, "wrong", options, Dialect::kLinuxCnc).findings;
  };
  const auto scaled = [](double by) {
    return [by](Section& section) {
      for (Move& move : section.moves) {
        for (Vec2* p : {&move.path.from, &move.path.to, &move.path.center})
          *p = kCenter + (*p - kCenter) * by;
      }
    };
  };
  EXPECT_EQ(faults_of(verdict([](Section&) {})), "");
  EXPECT_TRUE(has(verdict(scaled(1.01)), FaultKind::kUncut));
  EXPECT_TRUE(has(verdict(scaled(0.99)), FaultKind::kGouge));
  EXPECT_TRUE(has(verdict([](Section& section) {
                    for (Move& move : section.moves) {
                      if (move.z_from < 0) move.z_from *= 0.9;
                      if (move.z_to < 0) move.z_to *= 0.9;
                    }
                  }),
                  FaultKind::kThread))
      << "pitch of 1.35";
  EXPECT_TRUE(has(verdict([](Section& section) {
                    for (Move& move : section.moves) {
                      for (Vec2* p : {&move.path.from, &move.path.to, &move.path.center})
                        p->y = 2 * kCenter.y - p->y;
                      if (move.path.is_arc())
                        move.path.turn =
                            move.path.turn == Turn::kClockwise ? Turn::kCounterClockwise : Turn::kClockwise;
                    }
                  }),
                  FaultKind::kThread))
      << "left hand";
  EXPECT_TRUE(has(verdict([](Section& section) { section.moves.resize(1); }), FaultKind::kNothingCut));
}

/// The end mill that clears about the boss must leave it as wide as it was drawn.
TEST(ExternalThreads, AnEndMillMayNotCutTheirCrests) {
  const Part part = drawn(boss("THREAD_M20x1.5_EXTERNAL_D8", 20));
  const auto options = with({"endmill:10", "threadmill:12"});
  const PlanResult result = plan_part(part, options);
  Toolpath wrong = result.toolpath;
  Section& mill = wrong.sections.front();
  ASSERT_EQ(mill.tool_number, 1);
  const Vec2 at = kCenter + Vec2{14.9, 0}, end = mill.moves.back().path.to;
  const double high = mill.moves.back().z_to;
  const MmPerMin feed = MmPerMin::of(500);
  mill.moves.push_back({Edge::line(end, at), high, high, MoveKind::kRapid, {}, 0});
  mill.moves.push_back({Edge::line(at, at), high, -5, MoveKind::kPlunge, feed, 0});
  mill.moves.push_back({Edge::line(at, at), -5, high, MoveKind::kRapid, {}, 0});
  const std::string program = post::write_program(wrong, result.part, options.post);
  EXPECT_TRUE(
      has(check_program(part, program, "wrong", options, Dialect::kLinuxCnc).findings, FaultKind::kGouge));
}

}  // namespace
}  // namespace clearcut::pipeline
