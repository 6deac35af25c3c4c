#include "pipeline/tour/tour.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "pipeline/tour/convergence.h"

namespace clearcut::pipeline {
namespace {

TourOptions asking(const std::string& objective, double time_s = 0.3) {
  TourOptions options;
  options.objective = objective;
  options.time_s = time_s;
  options.threads = 1;
  return options;
}

double value_after(const std::string& objective, double time_s) {
  return solve_tour("6x6", asking(objective, time_s)).solution.objective;
}

TEST(TourEngagement, BothModelsAreObjectivesOnLattices) {
  for (const char* objective : {"engagement", "engagement-inverse", "engagement-exact"}) {
    const auto result = solve_tour("6x6", asking(objective));
    EXPECT_EQ(result.solution.tour.size(), 36u) << objective;
    EXPECT_GT(result.solution.objective, 0) << objective;
    EXPECT_LE(value_after(objective, 0.6), value_after(objective, 1e-3)) << objective;
  }
}

TEST(TourEngagement, ComesNearerToItsTargetThanTheShortestTour) {
  auto options = asking("engagement", 1);
  options.diameter = 3;
  options.engagement_percent = 40;
  const auto nearer = solve_tour("8x6", options);
  options.objective = "100000:length,1:engagement";  // the length decides
  const auto shortest = solve_tour("8x6", options);
  EXPECT_LT(nearer.solution.objective, shortest.solution.objective - 100000 * shortest.solution.length);
}

TEST(TourEngagement, CanBeWeighedAgainstLengthAndTurns) {
  const auto result = solve_tour("6x6", asking("1:length,20:turns,1:engagement"));
  EXPECT_GE(result.solution.objective, 35 + 20 * 10);
  EXPECT_GE(result.solution.objective, result.solution.bound);
}

TEST(TourEngagement, RefusesCuttersTooSmallForTheRasterAndUnknownNames) {
  auto options = asking("engagement");
  options.diameter = 0.001;
  EXPECT_THROW(solve_tour("6x6", options), InputError);
  EXPECT_THROW(solve_tour("6x6", asking("engagment")), InputError);
}

/// What is told while the search goes on is what the result holds: times that rise, values that fall to the tour's own.
TEST(TourConvergence, FallsToTheValueOfTheTour) {
  for (const char* solver : {"modern", "published"}) {
    auto options = asking("1:length,3:turns", 0.5);
    options.solver = solver;
    std::vector<TourSample> told;
    options.improved = [&told](const TourSample& sample) { told.push_back(sample); };
    const auto result = solve_tour("9x7", options);
    ASSERT_EQ(told.size(), result.convergence.size()) << solver;
    ASSERT_FALSE(told.empty()) << solver;
    for (std::size_t i = 1; i < told.size(); ++i) {
      EXPECT_GE(told[i].seconds, told[i - 1].seconds);
      EXPECT_LT(told[i].best, told[i - 1].best);
    }
    EXPECT_NEAR(told.back().best, result.solution.objective, 1e-6) << solver;
    EXPECT_NE(tour_json(result).find("\"convergence\":[["), std::string::npos);
  }
}

/// Of many values the first and the last stay, spread over the whole of the fall.
TEST(TourConvergence, LeavesOutEveryOtherOfTooMany) {
  int told = 0;
  Convergence convergence([&told](const TourSample&) { ++told; });
  for (int i = 0; i < 5000; ++i) {
    convergence.add({0.1 * i, 9000.0 - i});
    convergence.add({0.1 * i, 9000.0 - i});  // no better
  }
  EXPECT_EQ(told, 5000);
  const auto samples = convergence.take();
  EXPECT_LE(samples.size(), Convergence::kMost);
  EXPECT_GT(samples.size(), Convergence::kMost / 2);
  EXPECT_EQ(samples.front().best, 9000);
  EXPECT_EQ(samples.back().best, 4001);
  for (std::size_t i = 1; i < samples.size(); ++i) EXPECT_LE(samples[i - 1].best - samples[i].best, 8);
}

}  // namespace
}  // namespace clearcut::pipeline
