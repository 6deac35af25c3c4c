// Published grids leave rims, and what is cut below them plans on these.
#include <gtest/gtest.h>

#include <algorithm>

#include "model/results/findings.h"
#include "pipeline/run.h"
#include "pipeline/test_drawings.h"

namespace clearcut::pipeline {
namespace {

double count(const PlanResult& result, FaultKind kind) {
  const auto& faults = result.findings.faults;
  return static_cast<double>(
      std::count_if(faults.begin(), faults.end(), [&](const Fault& fault) { return fault.kind == kind; }));
}

PlanResult planned(bool published) {
  // The last column of points of the wide pocket stands at x 45: beyond x 50 all of it stays. The deep pocket has a column at x 51.
  PlanOptions options = with({"endmill:10"});
  options.strategy = "tour";
  options.stepover = "1";
  options.stepdown = 2;
  options.published.published_grid = published;
  return plan_part(drawn(box("POCKET_D4", 0, 0, 57, 43) + box("POCKET_D8", 36, 10, 56, 33)), options);
}

/// What stands below a rim is taken in layers, from where the rim stands.
TEST(PublishedGridPlan, NoPassTakesMoreThanItsLayer) {
  const PlanResult result = planned(true);
  EXPECT_EQ(count(result, FaultKind::kTooDeep), 0) << verdict_and_reasons(result.findings);
  EXPECT_LE(result.findings.all.max_axial_mm, 2 + 1e-6);
  EXPECT_GT(count(result, FaultKind::kUncut), 0) << "the rim is the rule's, and is said";
  EXPECT_EQ(count(result, FaultKind::kRapidInMaterial), 0);
}

/// Grids that leave nothing are counted on: the deep pocket begins at the floor of the wide one.
TEST(PublishedGridPlan, OwnGridsBeginAtTheFloorAbove) {
  const PlanResult result = planned(false);
  EXPECT_TRUE(result.findings.faults.empty()) << verdict_and_reasons(result.findings);
  EXPECT_EQ(result.findings.features.back().layers.size(), 2U);
  EXPECT_EQ(planned(true).findings.features.back().layers.size(), 4U);
}

}  // namespace
}  // namespace clearcut::pipeline
