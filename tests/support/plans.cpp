#include "support/plans.h"

#include <gtest/gtest.h>

namespace clearcut::test_support {

PlanOptions plan_options_with(const std::vector<std::string>& tools) {
  PlanOptions options;
  for (const auto& tool : tools) options.tools.push_back(resolve::parse_tool(tool));
  return options;
}

PlanOptions with_tool(double diameter) {
  return plan_options_with({"endmill:" + std::to_string(diameter)});
}

void expect_clean(const PlanResult& result, const std::string& what) {
  EXPECT_TRUE(result.findings.all.clean) << what;
  EXPECT_LE(result.findings.all.uncut_thickness_mm, 0.01) << what;
  EXPECT_LE(result.findings.all.gouge_mm, 0.001) << what;
  EXPECT_EQ(result.findings.all.rapid_in_material, 0) << what;
  for (const auto& fault : result.findings.faults) ADD_FAILURE() << what << ": " << fault.text;
  EXPECT_GT(result.findings.all.feed_mm, 0) << what;
}

}  // namespace clearcut::test_support
