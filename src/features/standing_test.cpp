// What earlier steps leave over the target of a later one, stock on walls and floors included.
#include "features/standing.h"

#include <gtest/gtest.h>

namespace clearcut::features {
namespace {

Region rectangle(double x0, double y0, double x1, double y1) {
  const Vec2 corners[] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  return Region::from_valid_loops(loop_from_points(corners), {});
}

Part block() {
  Part part;
  part.stock = Stock{{{0, 0}, {100, 100}}, -50, 0};
  part.tools = {Tool{}, Tool{}};
  part.tools[1].kind = ToolKind::kDrill;
  part.tools[1].diameter = 8;
  return part;
}

Operation& add_step(Part& part, int feature) {
  Workingstep step;
  step.feature = feature;
  part.workplan.push_back(step);
  return part.workplan.back().operation;
}

Operation& add(Part& part, const Region& target, double floor_z) {
  Feature feature;
  feature.target = feature.allowed = {target};
  feature.floor_z = floor_z;
  part.features.push_back(feature);
  return add_step(part, static_cast<int>(part.features.size()) - 1);
}

TEST(Standing, IsWhatALayerHasToRemove) {
  Part part = block();
  add(part, rectangle(10, 10, 50, 90), -5);
  add(part, rectangle(20, 20, 80, 80), -12);
  stack_tops(part, {});
  const Standing second(part, 1, {});
  EXPECT_EQ(second.top(), 0);
  EXPECT_NEAR(area(second.above(-2)), 30 * 60, 1e-3) << "right of x 50 only";
  EXPECT_NEAR(area(second.above(-5)), 30 * 60, 1e-3) << "cut to exactly there";
  EXPECT_NEAR(area(second.above(-7)), 60 * 60, 1e-3) << "below the first floor all of it";
}

/// A pocket in the floor of another one that shares its lower wall.
Part pocket_at_the_wall_of_another(double stock_of_first, double stock_of_second) {
  Part part = block();
  add(part, rectangle(10, 10, 90, 90), -5).allowance_side = stock_of_first;
  add(part, rectangle(30, 10, 70, 50), -12).allowance_side = stock_of_second;
  stack_tops(part, {});
  return part;
}

TEST(Standing, StockOnTheWallOfAnEarlierFeatureStandsOverALaterOne) {
  const Part part = pocket_at_the_wall_of_another(0.5, 0);
  const Standing second(part, 1, {});
  EXPECT_EQ(part.features[1].top_z, -5) << "by design";
  EXPECT_EQ(second.top(), 0);
  EXPECT_NEAR(area(second.above(-3)), 40 * 0.5, 1e-3);
  EXPECT_NEAR(area(second.above(-7)), 40 * 40, 1e-3);
}

TEST(Standing, WhatLiesInTheStocksOfBothIsLeftAlone) {
  const Part part = pocket_at_the_wall_of_another(0.5, 0.5);
  const Standing second(part, 1, {});
  EXPECT_EQ(second.top(), -5);
  EXPECT_TRUE(second.above(-3).empty());
  EXPECT_NEAR(area(second.above(-7)), 40 * 40, 1e-3) << "targets reach up to the walls";
}

TEST(Standing, FinishedWallsAreOutOfTheWay) {
  Part part = pocket_at_the_wall_of_another(0.5, 0);
  Workingstep finishing;
  finishing.operation.kind = OperationKind::kSideFinishing;
  part.workplan.insert(part.workplan.begin() + 1, finishing);
  EXPECT_EQ(Standing(part, 2, {}).top(), -5);
}

TEST(Standing, StockOnAFloorStandsUntilTheFloorIsFinished) {
  Part part = pocket_at_the_wall_of_another(0, 0);
  part.workplan[0].operation.allowance_floor = 0.2;
  EXPECT_NEAR(Standing(part, 1, {}).top(), -4.8, 1e-9);
  Workingstep finishing;
  finishing.operation.kind = OperationKind::kSideFinishing;
  part.workplan.insert(part.workplan.begin() + 1, finishing);
  EXPECT_NEAR(Standing(part, 2, {}).top(), -4.8, 1e-9) << "walls are no floors";
  finishing.operation.kind = OperationKind::kBottomFinishing;
  part.workplan.insert(part.workplan.begin() + 1, finishing);
  EXPECT_EQ(Standing(part, 3, {}).top(), -5);
}

/// A feature that runs out over the edge of the block is cut from the stock that is left on the floor above it.
TEST(Standing, StockOnAFloorStandsOverWhatRunsOutOfTheBlock) {
  Part part = pocket_at_the_wall_of_another(0, 0);
  part.workplan[0].operation.allowance_floor = 0.2;
  const Box above = box(part.features[0].target);
  part.stock = Stock{above, -20, 0};
  Feature& below = part.features[1];
  const Box there = box(below.target);
  below.target = {rectangle(above.min.x - 0.06, there.min.y, there.max.x, there.max.y)};
  EXPECT_NEAR(Standing(part, 1, {}).top(), -4.8, 1e-9);
}

TEST(Standing, ADrillClearsNoPocket) {
  Part part = pocket_at_the_wall_of_another(0, 0);
  part.workplan[0].operation.tool = 1;
  EXPECT_NEAR(area(Standing(part, 1, {}).above(-3)), 40 * 40, 1e-3);
}

}  // namespace
}  // namespace clearcut::features
