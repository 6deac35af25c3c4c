// Constants of the texts as numbers, so that a change of 1 % in one of them shows; scripts/mutants.sh makes such changes.
#include <gtest/gtest.h>

#include <cmath>

#include "order/lattice.h"
#include "order/solve.h"
#include "pipeline/selection/compare.h"
#include "pipeline/tour/engagement_model.h"

namespace clearcut::pipeline {
namespace {

/// CPO-rho eq. 9: T = sum L / V_f + 2 (1 + nd) tau, tau = 0.177 s.
TEST(PublishedConstants, TimeOfEquation9) {
  EXPECT_NEAR(published_time(100, 0), 100.354, 1e-9);
  EXPECT_NEAR(published_time(100, 9), 103.54, 1e-9);
}

/// The same as an objective: a row of four points 1 mm apart at 60 mm/min has no turn.
TEST(PublishedConstants, TimeAsAnObjective) {
  order::Problem row = order::lattice_problem(4, 1);
  row.shape = order::Shape::kOpenPath;
  EXPECT_NEAR(order::solve(row, *order::time_objective(60), {}).objective, 3 + 0.354, 1e-9);
}

/// Tour eq. 4.22 as restated in docs/tour.md.
TEST(PublishedConstants, CostOfEngagement) {
  EXPECT_NEAR(engagement_cost(-0.3), 0.3, 1e-12);
  EXPECT_NEAR(engagement_cost(0.2), std::exp(1.0) - 1, 1e-12);
  EXPECT_NEAR(inverse_engagement_cost(-0.04), 0.5, 1e-12);
}

}  // namespace
}  // namespace clearcut::pipeline
