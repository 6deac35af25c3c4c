// Pockets whose corridors are exactly as wide as the cutter, blocks with arms of any width, rooms that end in a tip, and
// parts many times as wide as the cutter: each strategy clears them.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "pipeline/run.h"
#include "support/random/lattice_parts.h"
#include "support/random/random_parts.h"
#include "support/random/wide_parts.h"

namespace clearcut {
namespace {

constexpr double kDiameter = 10;

/// "" when the plan is certified clean, or the strategy is refused by its name with another proposed; else its first
/// fault.
std::string fault_of(const Part& part, const std::string& strategy) {
  PlanOptions options;
  options.strategy = strategy;
  try {
    const auto result = pipeline::plan_part(part, options);
    return result.findings.faults.empty() ? "" : result.findings.faults.front().text;
  } catch (const InputError& error) {
    const std::string what = error.what();
    const bool by_name = what.find(strategy + " found no passes") != std::string::npos &&
                         what.find("use another --strategy") != std::string::npos;
    return strategy != "auto" && by_name ? "" : what;
  }
}

class LatticeParts : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(All, LatticeParts, testing::Values("contour", "zigzag", "spiral", "auto"),
                         [](const auto& strategy) { return strategy.param; });

TEST_P(LatticeParts, WithCorridorsAsWideAsTheCutterAreCleared) {
  for (int seed = 1; seed <= test_support::random_count(15); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    EXPECT_EQ(fault_of(test_support::exact_fit_pocket(random, kDiameter), GetParam()), "") << "seed " << seed;
  }
}

TEST_P(LatticeParts, AsBlocksWithNarrowArmsAreCleared) {
  for (int seed = 1; seed <= test_support::random_count(15); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    EXPECT_EQ(fault_of(test_support::block_with_arms(random, kDiameter), GetParam()), "") << "seed " << seed;
  }
}

TEST_P(LatticeParts, ThatEndInATipAreCleared) {
  // The first one's last turn of a spiral reached the wall later than the wall was followed once more.
  std::vector<int> seeds{59};
  for (int seed = 1; seed <= test_support::random_count(10); ++seed) seeds.push_back(seed);
  for (const int seed : seeds) {
    Random random(static_cast<std::uint64_t>(seed));
    EXPECT_EQ(fault_of(test_support::room_with_tip(random, kDiameter), GetParam()), "") << "seed " << seed;
  }
}

TEST(Adaptive, LeavesNoIslandsInPartsManyTimesAsWideAsTheCutter) {
  // The first ones had islands where no free way led back round the material.
  std::vector<int> seeds{7, 9, 21, 23, 24};
  for (int seed = 101; seed <= 100 + test_support::random_count(5); ++seed) seeds.push_back(seed);
  for (const int seed : seeds) {
    Random random(static_cast<std::uint64_t>(seed));
    random.unit();
    EXPECT_EQ(fault_of(test_support::wide_part(random, kDiameter), "adaptive"), "") << "seed " << seed;
  }
}

/// Parts of which something else went wrong. Adaptive: residuals between two cuts that no bound could tell from ones too wide,
/// an arc of a narrow end that bulged into its wall; spiral: the way to a loop beyond an island.
TEST(PartsManyTimesAsWide, AreCleanWhereTheyWereNot) {
  constexpr std::pair<std::uint64_t, const char*> kFound[] = {
      {77309, "adaptive"}, {77571, "adaptive"}, {77923, "adaptive"}, {77363, "spiral"}};
  for (const auto& [seed, strategy] : kFound) {
    Random random(seed);
    EXPECT_EQ(fault_of(test_support::wide_part(random, kDiameter), strategy), "") << seed << ' ' << strategy;
  }
}

}  // namespace
}  // namespace clearcut
