// Values of objectives: what a tour costs by hand.
#include "order/objective.h"

#include <gtest/gtest.h>

#include <cmath>

namespace clearcut::order {
namespace {

/// Depends on the whole path and on nothing else.
class FirstPlace final : public Objective {
 public:
  std::string name() const override { return "first place"; }
  std::string unit() const override { return "mm"; }
  bool path_dependent() const override { return true; }
  double path(const Moves& moves, std::span<const int> tour) const override {
    return moves.problem().points.at(static_cast<std::size_t>(tour.front())).y;
  }
  Linear linear() const override { return {.exact = false}; }
};

/// From (0, 13) around an obstacle to (4, 13) and back to (2, 13).
Problem around_an_obstacle() {
  Problem problem;
  problem.points = {{0, 13}, {2, 13}, {4, 13}};
  problem.shape = Shape::kOpenPath;
  problem.detour = [](int from, int to) -> std::vector<Vec2> {
    if (from == 2 && to == 0) return {{3, 14}, {1, 14}};
    if (from == 0 && to == 2) return {{1, 14}, {3, 14}};
    return {};
  };
  return problem;
}

const Tour kAround{0, 2, 1};
const double kLength = 4 + 2 * std::sqrt(2.0);
constexpr double kTurns = 3, kAngle = 45 + 45 + 135;

TEST(Objective, FiguresCountTheTurnsOnTheWay) {
  const Problem problem = around_an_obstacle();
  const TourFigures found = figures(Moves(problem), kAround);
  EXPECT_NEAR(found.length, kLength, 1e-12);
  EXPECT_EQ(found.turns, kTurns);
  EXPECT_NEAR(found.angle_deg, kAngle, 1e-9);
}

/// Each part by its weight, those of edges, of corners, of the whole path and the constant alike.
TEST(Objective, WeightsMultiplyEveryPart) {
  const Problem problem = around_an_obstacle();
  const Moves moves(problem);
  const auto first = std::make_shared<FirstPlace>();
  const auto time = time_objective(1000, 0.177);
  const double seconds = kLength * 60 / 1000 + 2 * (1 + kTurns) * 0.177;
  EXPECT_NEAR(evaluate(*time, moves, kAround), seconds, 1e-12);
  const auto sum = weighted_sum(
      {{2, length_objective()}, {3, turns_objective()}, {5, angle_objective()}, {7, time}, {11, first}});
  const double without_path = 2 * kLength + 3 * kTurns + 5 * kAngle + 7 * seconds;
  EXPECT_NEAR(evaluate(*sum, moves, kAround), without_path + 11 * 13, 1e-9);
  EXPECT_NEAR(sum->path(moves, kAround), 11 * 13, 1e-12);
  const Objective::Linear linear = sum->linear();
  EXPECT_NEAR(linear.length, 2 + 7 * 0.06, 1e-12);
  EXPECT_NEAR(linear.turns, 3 + 7 * 2 * 0.177, 1e-12);
  EXPECT_NEAR(linear.angle, 5, 1e-12);
  EXPECT_NEAR(linear.constant, 7 * 2 * 0.177, 1e-12);
  EXPECT_FALSE(linear.exact);
}

}  // namespace
}  // namespace clearcut::order
