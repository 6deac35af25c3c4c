#include "pipeline/tour/tour.h"

#include <gtest/gtest.h>

#include "base/error.h"

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

}  // namespace
}  // namespace clearcut::pipeline
