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
void expect_clean_fishhead(double corner_radius, const PlanOptions& options) {
  expect_clean(pipeline::plan_part(fishhead_with(corner_radius), options),
               "corners " + std::to_string(corner_radius));
}

PlanOptions leaving(double stock) {
  PlanOptions options;
  options.allowance = stock;
  return options;
}

PlanOptions finishing(const std::string& what, double stock) {
  PlanOptions options;
  options.shop.finish = what;
  options.shop.finish_stock = stock;
  return options;
}

TEST(SideStock, FishheadIsCleanWhateverItsWallsKeep) {
  for (const double stock : {0.1, 0.3, 0.5, 1.0, 1.5, 2.0}) expect_clean_fishhead(0, leaving(stock));
  for (const double stock : {0.3, 1.0}) expect_clean_fishhead(1, leaving(stock));
}

/// A face of a block 100 x 100 mm, milled around a wall.
Feature face_around(const char* name, const std::vector<Vec2>& wall, double floor_z) {
  const auto square = [](double low, double high) {
    return loop_from_points(std::vector<Vec2>{{low, low}, {high, low}, {high, high}, {low, high}});
  };
  Feature feature;
  feature.name = name;
  feature.kind = FeatureKind::kPlanarFace;
  feature.target = {Region::from_valid_loops(square(0, 100), {loop_from_points(wall)})};
  feature.allowed = {Region::from_valid_loops(square(-kOpenReach, kOpenReach), {loop_from_points(wall)})};
  feature.floor_z = floor_z;
  return feature;
}

TEST(SideStock, IsLeftOnWallsThatStandAtLast) {
  // The deeper face takes the tip of the upper one's wall: there the stock is measured from where their walls cross.
  Part part;
  part.name = part.source_file = "wedges";
  part.features = {face_around("upper", {{46, 60}, {20, 60}, {20, 20}, {50, 20}}, -3),
                   face_around("deeper", {{45.99, 59.9}, {42, 20}, {80, 20}, {80, 80}, {52, 80}}, -6)};
  part.features[1].top_z = 0;
  part.stock = Stock{{{0, 0}, {100, 100}}, -20, 0};
  part.tools = {resolve::parse_tool("endmill:10")};
  for (int i = 0; i < 2; ++i) {
    Workingstep step;
    step.feature = i;
    part.workplan.push_back(step);
  }
  for (const char* strategy : {"contour", "zigzag"}) {
    auto options = leaving(2);
    options.strategy = strategy;
    expect_clean(pipeline::plan_part(part, options), strategy);
  }
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
