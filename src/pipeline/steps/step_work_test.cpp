#include "pipeline/steps/step_work.h"

#include <gtest/gtest.h>

#include "model/options/strategy_entry.h"

namespace clearcut::pipeline {
namespace {

/// A step of one layer, a square of `side` mm.
StepWork square_step(double side) {
  StepWork work;
  LayerLeft one;
  const std::vector<Vec2> corners{{0, 0}, {side, 0}, {side, side}, {0, side}};
  one.layer.target = {Region::from_valid_loops(loop_from_points(corners), {})};
  work.layers.push_back(one);
  return work;
}

TEST(WorkShare, IsOfAllWorkByArea) {
  ResolvedPlan plan;
  plan.steps.resize(2);
  const auto shares = work_shares({square_step(30), square_step(10)}, plan);
  EXPECT_EQ(shares, (std::vector<std::uint64_t>{kMostWork * 9 / 10, kLeastWork}));
}

TEST(WorkShare, OfManyStepsIsNoMoreThanOneHasAlone) {
  ResolvedPlan plan;
  plan.steps.resize(5);
  std::uint64_t all = 0;
  for (const std::uint64_t share : work_shares(std::vector<StepWork>(5, square_step(10)), plan)) all += share;
  EXPECT_EQ(all, kMostWork);
}

TEST(WorkShare, IsGreaterForAStrategyAskedForByName) {
  const StrategyEntry named;
  ResolvedPlan plan;
  plan.steps.resize(1);
  plan.steps[0].strategy = &named;
  EXPECT_EQ(work_shares({square_step(10)}, plan), std::vector<std::uint64_t>{kMostWorkAlone});
}

}  // namespace
}  // namespace clearcut::pipeline
