// Blocks of which something is missing: what is gone is not cut again, and what the part needs has to be there.
#include "pipeline/setups/solid_stock.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/test_drawings.h"
#include "read/common/moved_part.h"
#include "resolve/resolve.h"

namespace clearcut::pipeline {
namespace {

using ::testing::HasSubstr;

const std::string kBlock = box("STOCK_D12", 0, 0, 80, 60);
const std::string kPocket = box("POCKET_D10", 10, 10, 40, 30);

PlanResult planned(const Part& part, const Part& stock, PlanOptions options = with({"endmill:6"})) {
  resolve::number_tools(options.tools);
  options.earlier = missing_of(stock, *part.stock, options.tools);
  return plan_part(part, options);
}

double highest_cut(const PlanResult& result) {
  double highest = -HUGE_VAL;
  for (const Section& section : result.toolpath.sections) {
    for (const Move& move : section.moves)
      if (!is_rapid(move.kind) && !move.is_vertical())
        highest = std::max(highest, std::max(move.z_from, move.z_to));
  }
  return highest;
}

TEST(SolidStock, WhatIsMissingIsNotCutAgain) {
  const Part part = drawn(kBlock + kPocket);
  const PlanResult whole = plan_part(part, with({"endmill:6"}));
  const PlanResult rest = planned(part, drawn(kBlock + box("POCKET_D6", 10, 10, 40, 30)));
  EXPECT_TRUE(rest.findings.all.clean) << faults_of(rest.findings);
  EXPECT_NEAR(highest_cut(whole), -2.5, 0.6);
  EXPECT_LT(highest_cut(rest), -6);
  EXPECT_LT(rest.findings.all.feed_mm, 0.6 * whole.findings.all.feed_mm);
}

/// A window through the block, which the part has, too, in a wider pocket.
TEST(SolidStock, WhatGoesThroughIsGoneBelowTheBlockToo) {
  const std::string window = box("POCKET_D12", 20, 15, 30, 25);
  const Part part = drawn(kBlock + kPocket + window);
  const PlanResult result = planned(part, drawn(kBlock + window));
  EXPECT_TRUE(result.findings.all.clean) << faults_of(result.findings);
  EXPECT_GE(result.findings.all.feed_mm, 100);
  for (const Section& section : result.toolpath.sections)
    EXPECT_FALSE(section.label == "POCKET_D12" && feed_length(section) > 20);
}

TEST(SolidStock, MaterialOfThePartThatTheStockLacksIsAFault) {
  const PlanResult result =
      planned(drawn(kBlock + kPocket), drawn(kBlock + box("POCKET_D3", 50, 10, 70, 30)));
  EXPECT_FALSE(result.findings.all.clean);
  EXPECT_THAT(faults_of(result.findings), HasSubstr("in the stock, which lacks material of the part"));
  const PlanResult deeper =
      planned(drawn(kBlock + kPocket), drawn(kBlock + box("POCKET_D11", 10, 10, 40, 30)));
  EXPECT_THAT(faults_of(deeper.findings), HasSubstr("in the stock, which lacks material of the part"));
}

/// However many features a wrong blank meets, it is one mistake.
TEST(SolidStock, AWrongBlankIsOneFault) {
  std::string pockets, missing;
  for (int i = 0; i < 4; ++i) {
    pockets += box("POCKET_D4", 4.0 + 19 * i, 5, 17.0 + 19 * i, 20);
    missing += box("POCKET_D9", 3.0 + 19 * i, 4, 18.0 + 19 * i, 40);
  }
  const PlanResult result = planned(drawn(kBlock + pockets), drawn(kBlock + missing));
  EXPECT_EQ(result.findings.faults.size(), 1u) << faults_of(result.findings);
}

TEST(SolidStock, LiesAtTheBlockWhereverItsZeroIs) {
  const Part stock = drawn(kBlock + box("POCKET_D6", 10, 10, 40, 30));
  const Part moved = read::with_zero_at(drawn(kBlock + kPocket), {40, 30, -12});
  const PlanResult result = planned(moved, stock);
  EXPECT_TRUE(result.findings.all.clean) << faults_of(result.findings);
  EXPECT_LT(highest_cut(result), 12 - 6);
}

TEST(SolidStock, AFullBlockLacksNothingAndNarrowPlacesCountAsThere) {
  const Part part = drawn(kBlock + kPocket);
  std::vector<Tool> tools{resolve::parse_tool("endmill:6")};
  resolve::number_tools(tools);
  EXPECT_TRUE(
      missing_of(drawn(kBlock + box("POCKET_D2", 10, 10, 15, 30)), *part.stock, tools).sections.empty());
  tools = {resolve::parse_tool("drill:6")};
  resolve::number_tools(tools);
  EXPECT_THROW(missing_of(part, *part.stock, tools), InputError);
}

}  // namespace
}  // namespace clearcut::pipeline
