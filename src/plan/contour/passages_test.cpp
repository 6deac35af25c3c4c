// Passages of the published methods: CPO-kappa figure 10.
#include <gtest/gtest.h>

#include <cmath>

#include "plan/contour/published_rings.h"

namespace clearcut::plan::contour {
namespace {

/// The triangle of the figure: edge 79.9861 mm, R = 5 mm, step 7.01 mm.
LayerPasses planned(Passage passage, bool outside_in) {
  constexpr double kEdge = 79.9861;
  const Vec2 corners[] = {{0, 0}, {kEdge, 0}, {kEdge / 2, kEdge * std::sqrt(3.0) / 2}};
  Layer layer;
  layer.z = -1;
  layer.tool_radius = 5;
  layer.allowed = layer.target = {Region::from_valid_loops(loop_from_points(corners), {})};
  ContourOptions options;
  options.step = parse_step_rule("7.01mm");
  options.residuals = ResidualRule::kNone;
  options.passage = passage;
  options.outside_in = outside_in;
  return plan_contour(layer, options, {});
}

class TriangleOfTheFigure : public ::testing::TestWithParam<bool> {};

TEST_P(TriangleOfTheFigure, IsOneWayOfThePrintedLength) {
  const auto result = planned(Passage::kBisector, GetParam());
  ASSERT_EQ(result.passes.size(), 1u);
  const Pass& pass = result.passes.front();
  EXPECT_FALSE(pass.closed);
  EXPECT_FALSE(pass.reversible);
  EXPECT_NEAR(length(pass.path), 373.4802, 5e-5);
  int passages = 0;
  for (const Edge& edge : pass.path) passages += std::abs(edge.length() - 14.02) < 1e-6;
  EXPECT_EQ(passages, 2);
  for (std::size_t i = 1; i < pass.path.size(); ++i)
    EXPECT_NEAR(distance(pass.path[i - 1].to, pass.path[i].from), 0, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(CpoKappa, TriangleOfTheFigure, ::testing::Bool());

TEST(Passages, RingsStayWholeWhereTheShortestWayIsAskedFor) {
  for (const Pass& pass : planned(Passage::kShortest, true).passes) EXPECT_TRUE(pass.closed);
}

TEST(Passages, WaysKeepTheSideOfTheWall) {
  // Climb milling: the wall on the right, so the pocket is gone round counter-clockwise, whatever the order.
  for (const bool outside_in : {false, true}) {
    double twice_area = 0;
    const LayerPasses layer = planned(Passage::kBisector, outside_in);
    for (const Edge& edge : layer.passes.front().path) twice_area += cross(edge.from, edge.to);
    EXPECT_GT(twice_area, 0) << outside_in;
  }
}

}  // namespace
}  // namespace clearcut::plan::contour
