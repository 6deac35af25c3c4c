#include "pipeline/nesting/tool_runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "base/random.h"

namespace clearcut::pipeline {
namespace {

using Sequences = std::vector<std::vector<int>>;

/// Length of the shortest common supersequence, by recursion over what is left of each.
std::size_t shortest(const Sequences& left, std::map<Sequences, std::size_t>& known) {
  if (std::all_of(left.begin(), left.end(), [](const auto& one) { return one.empty(); })) return 0;
  if (const auto found = known.find(left); found != known.end()) return found->second;
  std::size_t least = 1000;
  for (const auto& one : left) {
    if (one.empty()) continue;
    const int tool = one.front();
    Sequences rest = left;
    for (auto& other : rest)
      if (!other.empty() && other.front() == tool) other.erase(other.begin());
    least = std::min(least, 1 + shortest(rest, known));
  }
  return known[left] = least;
}

/// Each kind gets its own tools in its own order, in as few stays as there can be.
TEST(ToolRuns, KeepTheOrderOfEachKindAndAreTheFewest) {
  Random random(41);
  for (int round = 0; round < 200; ++round) {
    Sequences tools(static_cast<std::size_t>(1 + random.between(0, 3.99)));
    for (auto& one : tools) {
      const int length = static_cast<int>(random.between(1, 6));
      while (static_cast<int>(one.size()) < length) {
        const int tool = 1 + static_cast<int>(random.between(0, 3.99));
        if (one.empty() || one.back() != tool) one.push_back(tool);
      }
    }
    const std::vector<SharedRun> runs = merged_runs(tools);
    Sequences got(tools.size());
    for (const SharedRun& run : runs) {
      EXPECT_FALSE(run.shares.empty());
      for (const SharedRun::Share& share : run.shares) {
        EXPECT_EQ(share.run, got[share.kind].size());
        got[share.kind].push_back(run.tool);
      }
    }
    EXPECT_EQ(got, tools);
    std::map<Sequences, std::size_t> known;
    EXPECT_EQ(runs.size(), shortest(tools, known));
  }
}

/// A kind whose one tool also ends the work of another is made then: its part does not lie loose meanwhile.
TEST(ToolRuns, ComeAsLateAsTheyCan) {
  const std::vector<SharedRun> runs = merged_runs({{1}, {1, 2, 3, 1}});
  ASSERT_EQ(runs.size(), 4U);
  EXPECT_EQ(runs[0].shares.size(), 1U);
  ASSERT_EQ(runs[3].shares.size(), 2U);
  EXPECT_EQ(runs[3].shares[0].kind, 0U);
  EXPECT_EQ(runs[3].shares[1].run, 3U);
}

/// Many kinds of many tools: more states than are followed.
TEST(ToolRuns, OfManyKindsAreFound) {
  Random random(5);
  Sequences tools(12);
  std::size_t all = 0;
  for (auto& one : tools) {
    for (int tool = 1; tool <= 9; ++tool)
      if (random.unit() < 0.6) one.push_back(random.unit() < 0.2 ? tool + 1 : tool);
    one.erase(std::unique(one.begin(), one.end()), one.end());
    all += one.size();
  }
  std::size_t got = 0;
  const std::vector<SharedRun> runs = merged_runs(tools);
  for (const SharedRun& run : runs) got += run.shares.size();
  EXPECT_EQ(got, all);
  EXPECT_LT(runs.size(), 20U);
  EXPECT_TRUE(merged_runs({{}, {}}).empty());
}

}  // namespace
}  // namespace clearcut::pipeline
