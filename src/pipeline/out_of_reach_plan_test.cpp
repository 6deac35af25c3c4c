// What no cutter at hand reaches: said, with the cutter that would, and open in the verdict where it is much.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "pipeline/test_drawings.h"

namespace clearcut::pipeline {
namespace {

using ::testing::HasSubstr;

resolve::PlanOptions by_contour(const std::string& tool) {
  resolve::PlanOptions options = with({tool});
  options.strategy = "contour";
  return options;
}

TEST(OutOfReach, IsSaidWithTheLargestCutterThatReaches) {
  const Part part = drawn(box("POCKET_D2", 0, 0, 40, 30) + box("POCKET_D2", 50, 0, 90, 30));
  const auto result = plan_part(part, by_contour("endmill:10"));
  ASSERT_EQ(result.findings.conditions.size(), 2u);
  EXPECT_THAT(result.program, HasSubstr("(CONDITIONS: 2 X OUT-OF-REACH AT MOST 2 PERCENT OR 1 MM2)"));
  EXPECT_EQ(result.findings.conditions[0].name, "out-of-reach");
  EXPECT_THAT(result.findings.conditions[0].text, HasSubstr("out of the reach of T1 (10 mm)"));
  EXPECT_THAT(result.findings.conditions[0].text,
              HasSubstr("the largest cutter that reaches all but 1 mm2 has 2.1"));
}

TEST(OutOfReach, IsAConditionOfTheVerdictWhereItIsMuch) {
  // A slot of 2 mm beside a square: most of it is too narrow for the cutter.
  const Part part = drawn(outline(
      "POCKET_D2", {{{0, 0}}, {{10, 0}}, {{10, 4}}, {{40, 4}}, {{40, 6}}, {{10, 6}}, {{10, 10}}, {{0, 10}}}));
  resolve::PlanOptions options = by_contour("endmill:4");
  const auto result = plan_part(part, options);
  EXPECT_EQ(verdict_of(result.findings), Verdict::kConditional);
  EXPECT_THAT(result.program, HasSubstr("CONDITIONS: OUT-OF-REACH"));
  options.accept = {"out-of-reach"};
  EXPECT_EQ(verdict_of(plan_part(part, options).findings), Verdict::kClean);
  const Part square = drawn(box("POCKET_D2", 0, 0, 60, 40));
  EXPECT_EQ(verdict_of(plan_part(square, by_contour("endmill:10")).findings), Verdict::kClean);
}

/// A comb of slots whose sides wave: thousands of short edges, none of which a wide cutter comes into.
Part waved_comb() {
  constexpr int kTeeth = 30, kWaves = 40;
  std::vector<Vec2> points{{0, -5}, {3.0 * kTeeth, -5}};
  for (int i = kTeeth - 1; i >= 0; --i) {
    for (int k = 0; k <= kWaves; ++k) points.push_back({3 * i + 2 + 0.1 * (k % 2), k * 0.5});
    for (int k = kWaves; k >= 0; --k) points.push_back({3 * i + 1 + 0.1 * (k % 2), k * 0.5});
  }
  Part part;
  part.name = part.source_file = "comb";
  Feature feature;
  feature.name = "COMB";
  feature.target = feature.allowed = {Region::from_valid_loops(loop_from_points(points), {})};
  feature.floor_z = -1;
  part.features = {feature};
  part.workplan.push_back({});
  return part;
}

TEST(OutOfReach, IsFoundOnOutlinesOfThousandsOfEdges) {
  const Part part = waved_comb();
  resolve::PlanOptions options = by_contour("endmill:4");
  options.strategy = "zigzag";
  const auto result = plan_part(part, options);
  ASSERT_EQ(result.findings.conditions.size(), 1u);
  EXPECT_THAT(result.findings.conditions[0].text,
              HasSubstr("the largest cutter that reaches all but 1 mm2 has 0."));
}

}  // namespace
}  // namespace clearcut::pipeline
