// A strategy added as docs/adding-a-strategy.md says is planned, certified, compared and tried like the others.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "base/error.h"
#include "pipeline/compare.h"
#include "pipeline/run.h"
#include "pipeline/selection/strategies.h"
#include "support/plans.h"
#include "support/random/random_parts.h"
#include "support/rings_strategy.h"

namespace clearcut {
namespace {

/// The table of the software with one row more.
const StrategyTable& with_rings() {
  static const StrategyTable table = [] {
    auto all = pipeline::built_in_strategies().entries();
    all.push_back(test_support::rings::entry());
    return StrategyTable(std::move(all));
  }();
  return table;
}

Part pocket() {
  const Vec2 corners[] = {{0, 0}, {60, 0}, {60, 40}, {25, 40}, {25, 25}, {0, 25}};
  const Regions target{Region::from_valid_loops(loop_from_points(corners), {})};
  return test_support::part_of(target, target, FeatureKind::kClosedPocket, 8);
}

PlanOptions options_with_rings() {
  PlanOptions options;
  options.strategies = &with_rings();
  return options;
}

TEST(NewStrategy, IsPlannedByNameAndCertifiedClean) {
  PlanOptions options = options_with_rings();
  options.strategy = "rings";
  const auto result = pipeline::plan_part(pocket(), options);
  test_support::expect_clean(result, "rings");
  ASSERT_EQ(result.selections.size(), 1U);
  EXPECT_EQ(result.selections[0].kept(), "rings");
}

TEST(NewStrategy, IsARowOfCompare) {
  const auto table = pipeline::compare(pocket(), options_with_rings());
  const auto row = std::find_if(table.rows.begin(), table.rows.end(),
                                [](const auto& cells) { return cells.front().rfind("rings", 0) == 0; });
  ASSERT_NE(row, table.rows.end());
  EXPECT_EQ(row->back(), "yes");
}

TEST(NewStrategy, IsTriedByAuto) {
  const auto result = pipeline::plan_part(pocket(), options_with_rings());
  test_support::expect_clean(result, "auto");
  const auto& all = result.selections.at(0).candidates;
  EXPECT_TRUE(std::any_of(all.begin(), all.end(),
                          [](const CandidateResult& one) { return one.strategy == "rings"; }));
}

TEST(NewStrategy, IsUnknownWithoutItsRow) {
  PlanOptions options;
  options.strategy = "rings";
  try {
    pipeline::plan_part(pocket(), options);
    FAIL() << "planned";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("'rings' is unknown; use one of auto, zigzag"));
  }
}

TEST(NewStrategy, TakesLessThanAHundredLines) {
  int lines = 0;
  for (const char* name : {"rings_strategy.h", "rings_strategy.cpp"}) {
    std::ifstream file(std::string(CLEARCUT_SOURCE_DIR) + "/tests/support/" + name);
    ASSERT_TRUE(file);
    for (std::string line; std::getline(file, line);) ++lines;
  }
  EXPECT_LT(lines, 100);
}

}  // namespace
}  // namespace clearcut
