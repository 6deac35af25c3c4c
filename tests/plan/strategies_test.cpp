// What holds for every strategy that fills an area: real shapes with every cutter and random parts, planned, posted,
// read back and certified.
#include "pipeline/selection/strategies.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "base/error.h"
#include "pipeline/run.h"
#include "read/job/read_part.h"
#include "read/repair/clean.h"
#include "support/random/random_parts.h"
#include "support/shapes.h"

namespace clearcut {
namespace {

PlanOptions options_for(const std::string& strategy) {
  PlanOptions options;
  options.strategy = strategy;
  return options;
}

/// "" when the plan is certified clean, else its worst fault. Where the cutter fits nowhere, or not into one of several
/// regions, that is said and no fault of the strategy.
std::string fault_of(const Part& part, const PlanOptions& options) {
  try {
    for (const auto& fault : pipeline::plan_part(part, options).findings.faults) {
      if (fault.kind != FaultKind::kNothingCut) return fault.text;
    }
  } catch (const InputError&) {
  }
  return "";
}

class EveryStrategy : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Filling, EveryStrategy,
                         testing::Values("zigzag", "spiral", "contour", "tour", "auto"),
                         [](const auto& strategy) { return strategy.param; });

/// The cutters that a shape is cut with: of 4 to 10 mm two that differ from shape to shape, or with CLEARCUT_WHOLE_MATRIX
/// all.
std::vector<double> cutters_for(int shape, const std::string& strategy) {
  std::vector<double> all{4, 5, 6, 7, 8, 9, 10};
  if (std::getenv("CLEARCUT_WHOLE_MATRIX")) return all;
  Random random(static_cast<std::uint64_t>(shape) * 16 + strategy.size());
  const auto first = random.below(all.size()), step = 1 + random.below(all.size() - 1);
  return {all[first], all[(first + step) % all.size()]};
}

TEST_P(EveryStrategy, ClearsEveryShapeWithEveryCutter) {
  const auto shapes = test_support::all_shapes();
  ASSERT_GT(shapes.size(), 10u);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Part part = test_support::part_of(shapes[i]);
    for (const double diameter : cutters_for(static_cast<int>(i), GetParam())) {
      auto options = options_for(GetParam());
      options.tools = {resolve::parse_tool("endmill:" + std::to_string(diameter))};
      options.stepdown = 100;
      EXPECT_EQ(fault_of(part, options), "") << shapes[i].name << " " << diameter;
    }
  }
}

TEST_P(EveryStrategy, ClearsRandomParts) {
  const int count = test_support::random_count(30);
  for (int i = 0; i < count; ++i) {
    Random random(static_cast<std::uint64_t>(i) + 1);
    const double diameter = random.between(2, 10);
    const Part part = test_support::random_part(random, diameter);
    if (part.features.front().target.empty()) continue;
    EXPECT_EQ(fault_of(part, options_for(GetParam())), "") << "seed " << i + 1;
  }
}

TEST(Adaptive, ClearsRandomParts) {
  const int count = test_support::random_count(30);
  for (int i = 0; i < count; ++i) {
    Random random(static_cast<std::uint64_t>(i) + 1);
    const double diameter = random.between(2, 10);
    const Part part = test_support::random_part(random, diameter);
    if (part.features.front().target.empty()) continue;
    EXPECT_EQ(fault_of(part, options_for("adaptive")), "") << "seed " << i + 1;
  }
}

TEST_P(EveryStrategy, WritesTheSameProgramAgain) {
  Random random(5);
  const Part part = test_support::random_part(random, 4);
  const auto first = pipeline::plan_part(part, options_for(GetParam())).program;
  EXPECT_EQ(pipeline::plan_part(part, options_for(GetParam())).program, first);
  auto threaded = options_for(GetParam());
  threaded.threads = 3;
  EXPECT_EQ(pipeline::plan_part(part, threaded).program, first);
}

TEST(Zigzag, KeepsTheDirectionAskedFor) {
  const Regions square{
      Region::from_valid_loops(loop_from_points(std::vector<Vec2>{{0, 0}, {50, 0}, {50, 40}, {0, 40}}), {})};
  for (const double angle : {0.0, 30.0, 90.0, -45.0}) {
    auto options = options_for("zigzag");
    options.angle_deg = angle;
    const auto result =
        pipeline::plan_part(test_support::part_of(square, square, FeatureKind::kClosedPocket, 6), options);
    EXPECT_TRUE(result.findings.all.clean);
    double along = 0, inside = 0;
    for (const auto& move : result.toolpath.sections.front().moves) {
      const Vec2 middle = move.path.at(0.5);
      if (move.kind != MoveKind::kCut || std::abs(middle.x - 25) > 21.9 || std::abs(middle.y - 20) > 16.9)
        continue;
      if (move.path.is_arc()) continue;  // of rounded corners
      inside += move.length();
      const double off = std::remainder(angle_of(move.path.to - move.path.from) - angle * kPi / 180, kPi);
      if (std::abs(off) < 1e-4) along += move.length();
    }
    EXPECT_GT(along, 0.7 * inside) << angle;
  }
}

TEST(Zigzag, LinesAreNoFartherApartThanAskedFor) {
  const Regions square{
      Region::from_valid_loops(loop_from_points(std::vector<Vec2>{{0, 0}, {50, 0}, {50, 40}, {0, 40}}), {})};
  auto options = options_for("zigzag");
  options.angle_deg = 0;
  options.stepover = "0.3";
  const auto result =
      pipeline::plan_part(test_support::part_of(square, square, FeatureKind::kClosedPocket, 6), options);
  std::vector<double> heights;
  for (const auto& move : result.toolpath.sections.front().moves) {
    const Vec2 d = move.path.to - move.path.from;
    if (move.kind == MoveKind::kCut && std::abs(d.y) < 1e-6 && std::abs(d.x) > 10)
      heights.push_back(move.path.to.y);
  }
  std::sort(heights.begin(), heights.end());
  ASSERT_GT(heights.size(), 15u);
  // The outermost are those along the walls.
  for (std::size_t i = 2; i + 1 < heights.size(); ++i) EXPECT_LT(heights[i] - heights[i - 1], 0.3 * 6 + 1e-3);
  options.stepover = "lom";
  EXPECT_THROW(
      pipeline::plan_part(test_support::part_of(square, square, FeatureKind::kClosedPocket, 6), options),
      InputError);
}

Regions rectangle(double width, double height) {
  return {Region::from_valid_loops(
      loop_from_points(std::vector<Vec2>{{0, 0}, {width, 0}, {width, height}, {0, height}}), {})};
}

const CandidateResult* candidate_result(const StrategySelection& selection, const std::string& strategy) {
  const auto found = std::find_if(selection.candidates.begin(), selection.candidates.end(),
                                  [&](const CandidateResult& one) { return one.strategy == strategy; });
  return found == selection.candidates.end() ? nullptr : &*found;
}

/// Corners of a block that no wall bounds are bounded by nothing that the cutter sweeps.
TEST(Tour, ClearsTheCornersOfOpenBlocks) {
  for (const std::uint64_t seed : {59u, 132u, 168u, 224u, 333u, 387u}) {
    Random random(seed);
    const Part part = test_support::random_part(random, random.between(2, 10));
    for (const char* stepover : {"0.7", "0.95"}) {
      auto options = options_for("tour");
      options.stepover = stepover;
      EXPECT_EQ(fault_of(part, options), "") << seed << " " << stepover;
    }
  }
}

/// Between walls that differ from layer to layer only the side of a rounded cutter reaches some of what stands.
TEST(RoundedCutters, CutTheFishheadClean) {
  const Part part = read::read_part(std::string(CLEARCUT_SOURCE_DIR) + "/examples/fishhead.p21", {});
  for (const char* tool : {"bullnose:10:corner=1", "bullnose:8:corner=2"}) {
    auto options = options_for("zigzag");
    options.tools = {resolve::parse_tool(tool)};
    EXPECT_EQ(fault_of(part, options), "") << tool;
  }
}

/// What is left on a floor stands over the features that begin there: their first layer takes it along.
TEST(FloorStock, CountsForTheFeaturesUnderIt) {
  const Part part = read::read_part(std::string(CLEARCUT_SOURCE_DIR) + "/examples/fishhead.p21", {});
  auto options = options_for("zigzag");
  options.shop.finish = "floor";
  options.shop.finish_stock_floor = 0.5;
  EXPECT_EQ(fault_of(part, options), "");
}

TEST(Auto, KeepsTheFastestOfThosePlannedAndListsAll) {
  for (const std::uint64_t seed : {1u, 2u, 4u, 6u}) {
    Random random(seed);
    const Part part = test_support::random_part(random, random.between(3, 8));
    const auto result = pipeline::plan_part(part, options_for("auto"));
    ASSERT_TRUE(result.findings.all.clean) << seed;
    ASSERT_EQ(result.selections.size(), 1u);
    const auto& selection = result.selections.front();
    ASSERT_FALSE(selection.kept().empty());
    const auto* kept = candidate_result(selection, selection.kept());
    EXPECT_NEAR(kept->time_s, result.findings.all.time_s, 0.02 * kept->time_s + 0.1) << seed;
    for (const char* name : {"contour", "zigzag", "spiral", "adaptive", "tour"}) {
      const auto* one = candidate_result(selection, name);
      ASSERT_TRUE(one) << name;
      if (one->time_s > 0) {
        EXPECT_LE(kept->time_s, one->time_s) << seed << " " << name;
      }
      if (one->outcome == Outcome::kCannotWin) {
        EXPECT_GE(one->least_s, kept->time_s) << seed << " " << name;
      }
    }
  }
}

/// In a round pocket two and a half cutters deep a rival of contour is fastest and leaves a post; contour itself comes next.
TEST(Auto, IsNoSlowerThanContourWhereARivalOfItIsNotClean) {
  const Regions disc{Region::from_valid_loops(read::full_circle({0, 0}, 20), {})};
  const Part part = test_support::part_of(disc, disc, FeatureKind::kClosedPocket, 8);
  const auto auto_time = pipeline::plan_part(part, options_for("auto")).findings.all.time_s;
  EXPECT_LE(auto_time, pipeline::plan_part(part, options_for("contour")).findings.all.time_s);
}

/// The bounds by which strategies are left out hold for what those strategies plan.
TEST(Auto, LeavesOutOnlyWhatCannotWin) {
  for (const double width : {30.0, 60.0, 110.0}) {
    const Part part =
        test_support::part_of(rectangle(width, 40), rectangle(width, 40), FeatureKind::kClosedPocket, 6);
    const auto selection = pipeline::plan_part(part, options_for("auto")).selections.front();
    for (const auto& one : selection.candidates) {
      if (one.least_s == 0) continue;
      EXPECT_GE(pipeline::plan_part(part, options_for(one.strategy)).findings.all.time_s, one.least_s)
          << one.strategy;
    }
  }
}

TEST(Auto, UnderAnEngagementLimitOnlyStrategiesThatHoldItCount) {
  auto options = options_for("auto");
  options.engagement_deg = 60;
  options.entry = EntryKind::kHelix;
  const auto result = pipeline::plan_part(
      test_support::part_of(rectangle(50, 40), rectangle(50, 40), FeatureKind::kClosedPocket, 6), options);
  EXPECT_EQ(result.selections.front().kept(), "adaptive");
  EXPECT_EQ(verdict_and_reasons(result.findings), "CLEAN\n");
}

TEST(Auto, KeepsTheDirectionThatIsAskedFor) {
  const Part part =
      test_support::part_of(rectangle(50, 40), rectangle(50, 40), FeatureKind::kClosedPocket, 6);
  const auto candidates = [&](const PlanOptions& options) {
    std::vector<std::string> names;
    const auto selection = pipeline::plan_part(part, options).selections.front();
    for (const auto& one : selection.candidates) names.push_back(one.strategy);
    return names;
  };
  auto options = options_for("auto");
  EXPECT_THAT(candidates(options), testing::Contains("zigzag"));
  options.direction = CutDirection::kClimb;
  EXPECT_THAT(candidates(options), testing::Not(testing::Contains("zigzag")));
  EXPECT_THAT(candidates(options), testing::Contains("contour"));
  options.strategy = "zigzag";
  const auto named = pipeline::plan_part(part, options);
  const auto& said = named.part.diagnostics.items();
  EXPECT_TRUE(std::any_of(said.begin(), said.end(), [](const Diagnostic& one) {
    return one.severity == Severity::kWarning && one.what.find("cuts both ways") != std::string::npos;
  }));
}

TEST(Auto, DoesNotDependOnTheNumberOfThreads) {
  const auto shapes = test_support::own_shapes();
  const auto pocket5 = std::find_if(shapes.begin(), shapes.end(),
                                    [](const auto& shape) { return shape.name == "fishhead_pocket5"; });
  ASSERT_NE(pocket5, shapes.end());
  const Part part = test_support::part_of(*pocket5);
  auto options = options_for("auto");
  options.tools = {resolve::parse_tool("endmill:6")};
  const auto one = pipeline::plan_part(part, options);
  options.threads = 4;
  const auto four = pipeline::plan_part(part, options);
  EXPECT_EQ(one.program, four.program);
  EXPECT_EQ(one.selections.front().kept(), four.selections.front().kept());
}

}  // namespace
}  // namespace clearcut
