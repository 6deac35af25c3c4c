// What a plan says beside its program: conditions that its check has, too, and what cannot be checked.
#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/test_drawings.h"

namespace clearcut::pipeline {
namespace {

/// What an inner cut-out frees is a fault of nobody, but tabs that were asked for and are not there leave the verdict open.
TEST(WhatPlansSay, TabsThatFitNowhereInACutOutAreACondition) {
  resolve::PlanOptions options = with({"endmill:3"});
  options.tabs.count = 2;
  const PlanResult result = plan_part(drawn(box("INSIDE_D5", 0, 0, 8, 8)), options);
  EXPECT_EQ(verdict_of(result.findings), Verdict::kConditional) << faults_of(result.findings);
  EXPECT_TRUE(std::any_of(result.findings.conditions.begin(), result.findings.conditions.end(),
                          [](const Condition& one) { return one.name == "loose-part"; }));
}

TEST(WhatPlansSay, APocketNoDeeperThanWhatMayStayIsSaid) {
  const PlanResult result = plan_part(
      drawn(box("POCKET_D0.004", 0, 0, 30, 20) + box("POCKET_D3", 40, 0, 70, 20)), with({"endmill:3"}));
  EXPECT_TRUE(std::any_of(result.part.diagnostics.items().begin(), result.part.diagnostics.items().end(),
                          [](const Diagnostic& one) {
                            return one.severity == Severity::kWarning &&
                                   one.what.find("0.004 mm deep") != std::string::npos;
                          }));
}

/// Marlin has no word for tools: the plan says so as the check of its program does.
TEST(WhatPlansSay, APlanForMarlinSaysThatItsToolsArePutInByHand) {
  resolve::PlanOptions options = with({"endmill:6", "endmill:3"});
  options.post.dialect = "marlin";
  const Part part = drawn(box("POCKET_D3", 0, 0, 30, 20) + box("POCKET_D3", 40, 0, 45, 20));
  const PlanResult result = plan_part(part, options);
  const CheckResult checked =
      check_program(part, result.program, "x.gcode", options, read::gcode::Dialect::kMarlin);
  const auto is_by_hand = [](const Condition& one) { return one.name == "tool-by-hand"; };
  for (const Findings* findings : {&result.findings, &checked.findings})
    EXPECT_EQ(std::count_if(findings->conditions.begin(), findings->conditions.end(), is_by_hand), 1);
}

/// Rest of what is milled is cut before the profile that frees the part.
TEST(WhatPlansSay, RestStepsComeBeforeWhatFreesThePart) {
  resolve::PlanOptions options = with({"endmill:6", "endmill:3"});
  options.shop.rest = true;
  const PlanResult result =
      plan_part(drawn(box("STOCK_D6", -20, -20, 60, 50) + box("POCKET_D2", 0, 0, 30, 20) +
                      box("PROFILE_D6", -8, -8, 40, 30)),
                options);
  EXPECT_FALSE(has(result.findings, FaultKind::kLoosePart)) << faults_of(result.findings);
}

}  // namespace
}  // namespace clearcut::pipeline
