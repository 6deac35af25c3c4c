// Stock on walls: what earlier steps leave stands over later features, and is cut in layers like all else.
#include <gtest/gtest.h>

#include "pipeline/run.h"
#include "studies/fishhead.h"
#include "support/plans.h"

namespace clearcut {
namespace {

using test_support::expect_clean;

Part fishhead_with(double corner_radius) {
  Part part = studies::fishhead(false, {});
  if (corner_radius <= 0) return part;
  for (Tool& tool : part.tools) {
    if (tool.kind != ToolKind::kEndMill) continue;
    tool.kind = ToolKind::kBullNoseEndMill;
    tool.corner_radius = corner_radius;
  }
  return part;
}

/// No fault means, among others, that no cut is deeper than the stepdown.
void expect_clean_fishhead(double corner_radius, const resolve::PlanOptions& options) {
  expect_clean(pipeline::plan_part(fishhead_with(corner_radius), options),
               "corners " + std::to_string(corner_radius));
}

resolve::PlanOptions leaving(double stock) {
  resolve::PlanOptions options;
  options.allowance = stock;
  return options;
}

resolve::PlanOptions finishing(const std::string& what, double stock) {
  resolve::PlanOptions options;
  options.shop.finish = what;
  options.shop.finish_stock = stock;
  return options;
}

TEST(SideStock, FishheadIsCleanWhateverItsWallsKeep) {
  for (const double stock : {0.1, 0.3, 0.5, 1.0}) expect_clean_fishhead(0, leaving(stock));
  for (const double stock : {0.3, 1.0}) expect_clean_fishhead(1, leaving(stock));
}

TEST(SideStock, FishheadIsCleanOnceItsStockIsFinished) {
  expect_clean_fishhead(0, finishing("all", 0.5));
  expect_clean_fishhead(0, finishing("walls", 1));
  expect_clean_fishhead(1, finishing("all", 1));
}

TEST(SideStock, LeaningWallsAreCleanOnceTheirStockIsFinished) {
  for (const char* what : {"all", "walls", "floor"}) {
    const auto result = pipeline::plan_part(studies::fishhead(true, {}), finishing(what, 0.4));
    expect_clean(result, what);
    for (const FeatureFindings& feature : result.findings.features) {
      const double height = feature.scallop ? feature.scallop->height_mm : 0.5;
      EXPECT_NEAR(height, 0.5, 1e-4) << what;
    }
  }
}

}  // namespace
}  // namespace clearcut
