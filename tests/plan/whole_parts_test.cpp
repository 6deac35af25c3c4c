// Random parts of several features at several depths, cut by several cutters in layers: certified clean, and a field of
// heights that knows nothing of the verifier agrees.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "base/error.h"
#include "features/standing.h"
#include "pipeline/run.h"
#include "support/independent/height_field.h"
#include "support/random/random_parts.h"

namespace clearcut {
namespace {

constexpr double kCell = 0.25;

Tool mill(int number, double diameter) {
  Tool tool;
  tool.number = number;
  tool.diameter = diameter;
  return tool;
}

Loop shifted(Loop loop, Vec2 by) {
  for (Edge& edge : loop) {
    edge.from = edge.from + by;
    edge.to = edge.to + by;
    edge.center = edge.center + by;
  }
  return loop;
}

Region shifted(const Region& region, Vec2 by) {
  std::vector<Loop> islands;
  for (const Loop& island : region.islands()) islands.push_back(shifted(island, by));
  return Region::from_valid_loops(shifted(region.outer(), by), std::move(islands));
}

Feature pocket(int index, Random& random) {
  const Vec2 aside{random.between(-45, 45), random.between(-45, 45)};
  Feature feature;
  feature.name = "pocket " + std::to_string(index);
  for (const Region& region : test_support::random_regions(random))
    feature.target.push_back(shifted(region, aside));
  feature.allowed = feature.target;
  feature.floor_z = -random.between(1, 8);
  return feature;
}

/// Pockets that may lie apart, touch, overlap or hold one another, in any order of depth.
Part part_of_pockets(Random& random) {
  Part part;
  part.name = "pockets";
  part.tools = {mill(1, random.between(5, 10)), mill(2, random.between(2, 5))};
  const int count = 2 + static_cast<int>(random.below(3));
  for (int i = 0; i < count; ++i) {
    part.features.push_back(pocket(i, random));
    Workingstep step;
    step.feature = i;
    step.operation.tool = static_cast<int>(random.below(2));
    step.operation.stepdown = random.between(1, 4);
    step.operation.entry = EntryKind::kPlunge;
    part.workplan.push_back(step);
  }
  std::erase_if(part.features, [](const Feature& feature) { return feature.target.empty(); });
  if (part.features.size() != part.workplan.size()) part.workplan.clear();
  part.order_free = random.below(2) == 0;
  return part;
}

/// Plans, posts, certifies and simulates random parts; a cutter that fits nowhere is no fault.
void expect_clean_parts(const PlanOptions& options, int count,
                        const std::function<void(Part&, Random&)>& changed = {}) {
  int cut = 0;
  for (int seed = 1; seed <= count; ++seed) {
    Random random(static_cast<std::uint64_t>(seed) * 1000 + options.strategy.value_or("").size());
    Part part = part_of_pockets(random);
    if (part.workplan.empty()) continue;
    if (changed) changed(part, random);
    try {
      const PlanResult result = pipeline::plan_part(part, options);
      for (const auto& fault : result.findings.faults) {
        if (fault.kind != FaultKind::kNothingCut) ADD_FAILURE() << "seed " << seed << ": " << fault.text;
      }
      const auto found = test_support::simulate(result.part, result.toolpath, kCell);
      EXPECT_EQ(found.text(), "") << "seed " << seed;
      ++cut;
    } catch (const InputError&) {
    }
  }
  EXPECT_GT(cut, count / 2);
}

class WholeParts : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Filling, WholeParts, testing::Values("auto", "zigzag", "contour", "adaptive"),
                         [](const auto& strategy) { return strategy.param; });

TEST_P(WholeParts, AreCleanInAFieldOfHeights) {
  PlanOptions options;
  options.strategy = GetParam();
  expect_clean_parts(options, test_support::random_count(6));
}

TEST(WholePart, IsCleanWithAllCuttersEachOnWhatIsLeft) {
  PlanOptions options;
  options.shop.rest = true;
  expect_clean_parts(options, test_support::random_count(4));
}

TEST(WholePart, IsCleanWithFinishing) {
  PlanOptions options;
  options.shop.finish = "all";
  expect_clean_parts(options, test_support::random_count(4));
}

/// Stock of each step's own on walls and floors; pockets under others begin at their floors.
void leave_stock(Part& part, Random& random) {
  features::stack_tops(part, {});
  for (Workingstep& step : part.workplan) {
    if (random.below(3) > 0) step.operation.allowance_side = random.between(0.1, 1.2);
    if (random.below(3) == 0) step.operation.allowance_floor = random.between(0.1, 0.5);
  }
}

TEST(WholePart, IsCleanWithStockLeftInEveryStep) {
  expect_clean_parts({}, test_support::random_count(8), leave_stock);
}

TEST(WholePart, IsCleanWithStockThatIsFinishedAfterwards) {
  PlanOptions options;
  options.shop.finish = "all";
  options.shop.finish_stock = 0.8;
  options.shop.finish_stock_floor = 0.4;
  const auto stacked = [](Part& part, Random&) { features::stack_tops(part, {}); };
  expect_clean_parts(options, test_support::random_count(4), stacked);
}

TEST(WholePart, IsCleanWithStockLeftByBullNosedCutters) {
  const auto bull_nosed = [](Part& part, Random& random) {
    leave_stock(part, random);
    for (Tool& tool : part.tools) {
      tool.kind = ToolKind::kBullNoseEndMill;
      tool.corner_radius = random.between(0.1, 0.4) * tool.radius();
    }
  };
  expect_clean_parts({}, test_support::random_count(6), bull_nosed);
}

}  // namespace
}  // namespace clearcut
