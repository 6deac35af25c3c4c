#include <gtest/gtest.h>

#include <algorithm>

#include "plan/contour/contour.h"
#include "plan/contour/passes.h"

namespace clearcut::plan::contour {
namespace {

Layer square_layer(double side, double radius) {
  const std::vector<Vec2> corners{{0, 0}, {side, 0}, {side, side}, {0, side}};
  Layer layer;
  layer.z = -1;
  layer.target = layer.allowed = {Region::from_valid_loops(loop_from_points(corners), {})};
  layer.tool_radius = radius;
  return layer;
}

std::size_t rings_of(const Layer& layer) {
  const auto planned = plan_contour(layer, {}, {});
  return static_cast<std::size_t>(std::count_if(planned.passes.begin(), planned.passes.end(),
                                                [](const Pass& pass) { return pass.closed; }));
}

TEST(ShortenPasses, JoinsTheRingsOfAPocketOfUsualSize) {
  EXPECT_LT(rings_of(square_layer(60, 3)), 2U);
}

TEST(ShortenPasses, LeavesRingsAsTheyAreWhereTheSearchWouldTakeTooLong) {
  EXPECT_GT(rings_of(square_layer(300, 1)), 70U);
}

}  // namespace
}  // namespace clearcut::plan::contour
