// What no position of the cutter reaches: open where it is much, or most of the feature.
#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "pipeline/run.h"

namespace clearcut {
namespace {

/// Whether the condition "out-of-reach" of a pocket is open; absent where there is none.
std::optional<bool> open_of(const std::vector<Vec2>& outline, double diameter) {
  Feature feature;
  feature.name = "POCKET";
  feature.target = feature.allowed = {Region::from_valid_loops(loop_from_points(outline), {})};
  feature.floor_z = -0.2;
  Part part;
  part.name = part.source_file = "pocket";
  part.features = {feature};
  part.workplan.push_back({});
  PlanOptions options;
  Tool tool;
  tool.diameter = diameter;
  options.tools = {tool};
  for (const Condition& one : pipeline::plan_part(part, options).findings.conditions)
    if (one.name == "out-of-reach") return one.met_by.empty();
  return std::nullopt;
}

TEST(OutOfReach, MostOfASmallPocketIsOpenAndItsCornersAreNot) {
  const std::vector<Vec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_EQ(open_of(square, 0.2), std::nullopt);
  EXPECT_EQ(open_of(square, 0.9), false);
  // A room of 0.16 mm2 with an arm of 0.5 mm2 that is too narrow.
  const std::vector<Vec2> arm{{0, 0},      {0.4, 0},    {0.4, 0.15}, {5.4, 0.15},
                              {5.4, 0.25}, {0.4, 0.25}, {0.4, 0.4},  {0, 0.4}};
  EXPECT_EQ(open_of(arm, 0.3), true);
}

}  // namespace
}  // namespace clearcut
