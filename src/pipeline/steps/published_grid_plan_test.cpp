// Published grids leave rims, and what is cut below them plans on these.
#include <gmock/gmock.h>
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

/// The last column of points of the wide pocket stands at x 45: beyond x 50 all of it stays. The deep pocket has a column at x 51.
Part plates() {
  return drawn(box("POCKET_D4", 0, 0, 57, 43) + box("POCKET_D8", 36, 10, 56, 33));
}

PlanOptions mill() {
  PlanOptions options = with({"endmill:10"});
  options.stepdown = 2;
  return options;
}

PlanResult planned(bool published, const Part& part = plates()) {
  PlanOptions options = mill();
  options.strategy = "tour";
  options.stepover = "1";
  options.published.published_grid = published;
  return plan_part(part, options);
}

/// What stands below a rim is taken in layers, from where the rim stands.
TEST(PublishedGridPlan, NoPassTakesMoreThanItsLayer) {
  const PlanResult result = planned(true);
  EXPECT_EQ(count(result, FaultKind::kTooDeep), 0) << verdict_and_reasons(result.findings);
  EXPECT_LE(result.findings.all.max_axial_mm, 2 + 1e-6);
  EXPECT_GT(count(result, FaultKind::kUncut), 0) << "the rim is the rule's, and is said";
  EXPECT_EQ(count(result, FaultKind::kRapidInMaterial), 0);
}

/// Whoever reads the plan or its program knows which rule leaves the rim, and a second program cuts it in layers.
TEST(PublishedGridPlan, TheRimIsSaidToBeTheRulesAndIsCutByAProgramAfterIt) {
  const PlanResult first = planned(true);
  const auto& said = first.part.diagnostics.items();
  EXPECT_EQ(
      std::count_if(said.begin(), said.end(),
                    [](const Diagnostic& one) {
                      return one.what.find(
                                 "left by the rule of the published grid (Tour eq. 4.8): points 10 mm") !=
                             std::string::npos;
                    }),
      2);
  EXPECT_THAT(first.program, ::testing::HasSubstr("(RIM OF THE PUBLISHED GRID: POCKET_D4"));
  EXPECT_THAT(planned(false).program, ::testing::Not(::testing::HasSubstr("RIM OF")));

  PlanOptions rest = mill();
  rest.earlier = first.toolpath;
  const PlanResult after = plan_part(plates(), rest);
  EXPECT_TRUE(after.findings.faults.empty()) << verdict_and_reasons(after.findings);
  EXPECT_LE(after.findings.all.max_axial_mm, 2 + 1e-6);
}

/// Grids that leave nothing are counted on: the deep pocket begins at the floor of the wide one.
TEST(PublishedGridPlan, OwnGridsBeginAtTheFloorAbove) {
  const PlanResult result = planned(false);
  EXPECT_TRUE(result.findings.faults.empty()) << verdict_and_reasons(result.findings);
  EXPECT_EQ(result.findings.features.back().layers.size(), 2U);
  EXPECT_EQ(planned(true).findings.features.back().layers.size(), 4U);
}

/// A deep pocket over which the grid of the wide one has cut everything has no layers in the air.
TEST(PublishedGridPlan, LayersBelowAClearedAreaBeginAtItsFloor) {
  const PlanResult result =
      planned(true, drawn(box("POCKET_D4", 0, 0, 60, 60) + box("POCKET_D8", 20, 20, 40, 40)));
  EXPECT_EQ(result.findings.features.back().layers.size(), 2U) << verdict_and_reasons(result.findings);
  EXPECT_LE(result.findings.all.max_axial_mm, 2 + 1e-6);
  EXPECT_EQ(count(result, FaultKind::kRapidInMaterial), 0);
}

}  // namespace
}  // namespace clearcut::pipeline
