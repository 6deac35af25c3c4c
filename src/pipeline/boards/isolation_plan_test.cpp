// Isolated pieces: certified against what stays, and parted or not by formula.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "base/text.h"
#include "pipeline/run.h"
#include "read/job/read_part.h"
#include "resolve/resolve.h"

namespace clearcut::pipeline {
namespace {

PlanResult planned(const std::string& gerber, const std::string& tool) {
  ReadOptions reading;
  reading.depth = 0.1;
  const Part part = read::read_part_text(gerber, "F_Cu.gbr", reading);
  PlanOptions options;
  options.tools = {resolve::parse_tool(tool)};
  return plan_part(part, options);
}

const Condition* condition(const PlanResult& result, const std::string& name) {
  const auto& all = result.findings.conditions;
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Condition& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

/// Two discs with a radius of 1 mm, `gap` mm apart.
std::string two_pads(double gap) {
  return "%FSLAX33Y33*%%MOMM*%%ADD10C,2*%D10*X0Y0D03*X" + trimmed((2 + gap) * 1000, 0) + "D03*M02*";
}

/// A cutter of radius r that touches both discs beside the gap g still cuts through its middle as long as
/// 1 + 2 r < (1 + g / 2)^2.
TEST(Isolation, PadsArePartedByCuttersThatMeetInTheGap) {
  for (const auto& [tool, parts] : {std::pair{"endmill:0.19", true}, std::pair{"endmill:0.205", true},
                                    std::pair{"endmill:0.215", false}, std::pair{"endmill:0.4", false}}) {
    const PlanResult result = planned(two_pads(0.2), tool);
    EXPECT_TRUE(result.findings.faults.empty()) << tool;
    EXPECT_EQ(condition(result, "not-parted") == nullptr, parts) << tool;
  }
  const PlanResult result = planned(two_pads(0.2), "endmill:0.4");
  ASSERT_NE(condition(result, "not-parted"), nullptr);
  EXPECT_THAT(condition(result, "not-parted")->text,
              ::testing::HasSubstr(
                  "the 2 pieces that stay are parted into 1, because gaps are narrower than T1 (0.4 mm); "
                  "a cutter of 0.2 mm parts them all"));
  EXPECT_EQ(verdict_of(result.findings), Verdict::kConditional);
}

/// A piece within a ring of another, and copper between bands that belongs to nobody.
TEST(Isolation, PiecesWithinPiecesCount) {
  const std::string ring =
      "%FSLAX33Y33*%%MOMM*%%ADD10C,10X6*%%ADD11C,2*%%ADD12C,5.5*%D10*X0Y0D03*D11*X0Y0D03*X20000D03*M02*";
  EXPECT_EQ(verdict_of(planned(ring, "endmill:0.5").findings), Verdict::kClean);
  const std::string close = "%FSLAX33Y33*%%MOMM*%%ADD10C,10X6*%%ADD12C,5.5*%D10*X0Y0D03*D12*X0Y0D03*M02*";
  EXPECT_EQ(condition(planned(close, "endmill:0.2"), "not-parted"), nullptr);
  EXPECT_NE(condition(planned(close, "endmill:0.3"), "not-parted"), nullptr);
}

TEST(Isolation, IsFollowedOneWayRound) {
  const PlanResult result = planned(two_pads(3), "endmill:0.2");
  ASSERT_EQ(result.selections.size(), 1U);
  for (const CandidateResult& candidate : result.selections.front().candidates)
    EXPECT_TRUE(candidate.strategy != "zigzag" || candidate.outcome == Outcome::kNotTried);
}

}  // namespace
}  // namespace clearcut::pipeline
