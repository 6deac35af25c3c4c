// What a plan says beside its program: conditions that its check has, too, and what cannot be checked.
#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/test_drawings.h"

namespace clearcut::pipeline {
namespace {

/// What an inner cut-out frees is a fault of nobody, but tabs that were asked for and are not there leave the verdict open.
TEST(WhatPlansSay, TabsThatFitNowhereInACutOutAreACondition) {
  PlanOptions options = with({"endmill:3"});
  options.tabs.count = 2;
  const PlanResult result = plan_part(drawn(box("INSIDE_D5", 0, 0, 8, 8)), options);
  EXPECT_EQ(verdict_of(result.findings), Verdict::kConditional) << faults_of(result.findings);
  EXPECT_TRUE(std::any_of(result.findings.conditions.begin(), result.findings.conditions.end(),
                          [](const Condition& one) { return one.name == "loose-part"; }));
}

/// Whether a profile goes through is known where the stock is; without it a note says what would follow.
TEST(WhatPlansSay, AProfileThatNothingHoldsIsSaidWithoutAStockToo) {
  const auto notes = [](const std::string& more, const PlanOptions& options) {
    std::string text;
    const PlanResult result = plan_part(drawn(box("PROFILE_D3", 0, 0, 30, 20) + more), options);
    for (const Diagnostic& one : result.part.diagnostics.items())
      if (one.what.find("nothing holds what is cut out") != std::string::npos) text += one.where + "\n";
    return text;
  };
  PlanOptions options = with({"endmill:3"});
  EXPECT_EQ(notes("", options), "PROFILE_D3\n");
  EXPECT_EQ(notes(box("STOCK_D3", -9, -9, 39, 29), options), "") << "the condition says it";
  options.accept = {"loose-part"};
  EXPECT_EQ(notes("", options), "");
  options.accept = {};
  options.tabs.count = 2;
  EXPECT_EQ(notes("", options), "");
  options.tabs = {};
  options.tabs.skin = 0.3;
  EXPECT_EQ(notes("", options), "");
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
  PlanOptions options = with({"endmill:6", "endmill:3"});
  options.post.dialect = "marlin";
  const Part part = drawn(box("POCKET_D3", 0, 0, 30, 20) + box("POCKET_D3", 40, 0, 45, 20));
  const PlanResult result = plan_part(part, options);
  const CheckResult checked = check_program(part, result.program, "x.gcode", options, Dialect::kMarlin);
  const auto is_by_hand = [](const Condition& one) { return one.name == "tool-by-hand"; };
  for (const Findings* findings : {&result.findings, &checked.findings})
    EXPECT_EQ(std::count_if(findings->conditions.begin(), findings->conditions.end(), is_by_hand), 1);
}

/// Rest of what is milled is cut before the profile that frees the part.
TEST(WhatPlansSay, RestStepsComeBeforeWhatFreesThePart) {
  PlanOptions options = with({"endmill:6", "endmill:3"});
  options.shop.rest = true;
  const PlanResult result =
      plan_part(drawn(box("STOCK_D6", -20, -20, 60, 50) + box("POCKET_D2", 0, 0, 30, 20) +
                      box("PROFILE_D6", -8, -8, 40, 30)),
                options);
  EXPECT_FALSE(has(result.findings, FaultKind::kLoosePart)) << faults_of(result.findings);
}

/// A rapid in the material stands in a subprogram: which line of it, and who called it.
TEST(WhatChecksSay, FaultsWithinSubprogramsTellTheCalls) {
  const std::string program =
      "%\nO0001\nG21 G17 G90 G94 G40 G80 G61\nT1 M6\nG54\nS6000 M3\nG0 G43 H1 Z10.\nG0 X10. Y10.\nM98 "
      "P2000\nM30\n"
      "O2000\nG0 Z-3.\nG1 X20. F200.\nG0 Z10.\nM99\n%\n";
  const CheckResult checked = check_program_alone(resolve::parse_stock("0:40,0:30,-10:0"), program,
                                                  "called.nc", with({"endmill:6"}), Dialect::kFanuc);
  const auto found =
      std::find_if(checked.findings.faults.begin(), checked.findings.faults.end(),
                   [](const Fault& fault) { return fault.kind == FaultKind::kRapidInMaterial; });
  ASSERT_NE(found, checked.findings.faults.end()) << faults_of(checked.findings);
  EXPECT_EQ(found->at.line, 12);
  EXPECT_NE(found->text.find("(called.nc:12, O2000 called in called.nc:9)"), std::string::npos)
      << found->text;
}

}  // namespace
}  // namespace clearcut::pipeline
