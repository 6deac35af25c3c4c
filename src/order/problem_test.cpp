#include "order/problem.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "order/lattice.h"
#include "order/length/neighbours.h"
#include "order/moves.h"
#include "order/objective.h"
#include "order/test_support.h"

namespace clearcut::order {
namespace {

TEST(Problem, RoundedDistancesFollowTsplib) {
  Problem problem;
  problem.points = {{0, 0}, {1, 1}, {0.5, 0}};
  problem.metric = Metric::kRoundedEuc2d;
  EXPECT_EQ(straight_distance(problem, 0, 1), 1);  // 1.414
  EXPECT_EQ(straight_distance(problem, 0, 2), 1);  // 0.5 rounds up
  problem.metric = Metric::kEuclidean;
  EXPECT_DOUBLE_EQ(straight_distance(problem, 0, 1), std::sqrt(2.0));
}

TEST(Problem, IllegalMovesCostTheirDetour) {
  Problem problem;
  problem.points = {{0, 0}, {2, 0}, {4, 0}};
  problem.detour = [](int from, int to) -> std::vector<Vec2> {
    if (from == 2 && to == 0) return {{3, 1}, {1, 1}};
    if (from == 0 && to == 2) return {{1, 1}, {3, 1}};
    return {};
  };
  EXPECT_DOUBLE_EQ(move_length(problem, 0, 1), 2);
  EXPECT_DOUBLE_EQ(move_length(problem, 0, 2), 2 + 2 * std::sqrt(2.0));
  const Moves moves(problem);
  const MoveShape there = moves.shape(0, 2), back = moves.shape(2, 0);
  EXPECT_FALSE(there.straight);
  EXPECT_EQ(there.inner_turns, 2);
  EXPECT_NEAR(there.inner_angle, 90, 1e-9);
  EXPECT_EQ(there.leaves, (Vec2{1, 1}));
  EXPECT_EQ(there.arrives, (Vec2{1, -1}));
  EXPECT_EQ(back.leaves, (Vec2{-1, 1}));
  EXPECT_EQ(back.arrives, (Vec2{-1, -1}));
  EXPECT_DOUBLE_EQ(back.length, there.length);
  // Each of the turns on the way costs a stop and a start (CPO-rho eq. 9).
  const auto time = time_objective(1000, 0.177);
  EXPECT_DOUBLE_EQ(time->edge(moves, 0, 2), there.length * 60 / 1000 + 2 * 2 * 0.177);
  EXPECT_DOUBLE_EQ(time->edge(moves, 0, 1), 2.0 * 60 / 1000);
}

TEST(Problem, ContradictionsAreRefusedWithAReason) {
  const auto refused = [](auto change) {
    Problem problem = random_problem(5, 1);
    problem.shape = Shape::kOpenPath;
    change(problem);
    EXPECT_THROW(check(problem), InputError);
  };
  refused([](Problem& p) { p.points.clear(); });
  refused([](Problem& p) { p.points[2].x = std::nan(""); });
  refused([](Problem& p) { p.points[2].y = 1e300; });
  refused([](Problem& p) { p.start = 5; });
  refused([](Problem& p) { p.end = -2; });
  refused([](Problem& p) { p.start = p.end = 1; });
  refused([](Problem& p) { p.shape = Shape::kClosedTour, p.start = 1; });
  refused([](Problem& p) { p.precedence = {{0, 1}, {1, 2}, {2, 0}}; });
  refused([](Problem& p) { p.precedence = {{0, 9}}; });
  refused([](Problem& p) { p.start = 3, p.precedence = {{0, 3}}; });
  Problem good = random_problem(5, 1);
  EXPECT_NO_THROW(check(good));
}

TEST(Problem, CanonicalFormsOfTheSameWalkAreEqual) {
  const Problem problem = random_problem(7, 3);
  const Tour tour{3, 1, 0, 4, 6, 2, 5};
  for (int shift = 0; shift < 7; ++shift) {
    Tour turned = tour;
    std::rotate(turned.begin(), turned.begin() + shift, turned.end());
    EXPECT_EQ(canonical(problem, turned), canonical(problem, tour));
    std::reverse(turned.begin(), turned.end());
    EXPECT_EQ(canonical(problem, turned), canonical(problem, tour));
  }
}

TEST(TurnAngle, EqualsTheMinorArcOfTheText) {
  // Tour eq. 4.18 and 4.19: difference of two atan2, brought into -pi..pi.
  Random random(5);
  const double pi = std::acos(-1.0);
  for (int i = 0; i < 2000; ++i) {
    const Vec2 in{random.between(-1, 1), random.between(-1, 1)},
        out{random.between(-1, 1), random.between(-1, 1)};
    double theta = std::atan2(out.y, out.x) - std::atan2(in.y, in.x);
    if (theta > pi) theta -= 2 * pi;
    if (theta < -pi) theta += 2 * pi;
    EXPECT_NEAR(turn_angle(in, out), std::abs(theta) * 180 / pi, 1e-9);
    EXPECT_EQ(is_turn(in, out), turn_angle(in, out) > kTurnThresholdDegrees);
  }
  EXPECT_NEAR(turn_angle({1, 0}, {-1, 0}), 180, 1e-12);
  EXPECT_EQ(turn_angle({0, 0}, {-1, 0}), 0);
  EXPECT_TRUE(is_turn({1, 0}, {-1, 0}));
  EXPECT_TRUE(is_turn({1, 0}, {0, 1}));
  EXPECT_FALSE(is_turn({1, 0}, {2, 0}));
  const auto turned_by = [&](double degrees) {
    return Vec2{std::cos(degrees * pi / 180), std::sin(degrees * pi / 180)};
  };
  EXPECT_FALSE(is_turn({1, 0}, turned_by(0.0995)));
  EXPECT_TRUE(is_turn({1, 0}, turned_by(0.1005))) << "from 0.1 degrees on";
}

TEST(Neighbours, AreTheNearestByBruteForce) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    Problem problem = random_problem(300, seed);
    // Clusters, duplicates and ties.
    for (int i = 0; i < 100; ++i) problem.points[i] = {std::round(problem.points[i].x / 20), 1};
    const Neighbours near = nearest_neighbours(problem.points, 9);
    ASSERT_EQ(near.size(), 300);
    for (int v = 0; v < 300; ++v) {
      std::vector<std::pair<double, int>> all;
      for (int w = 0; w < 300; ++w) {
        if (w != v) all.push_back({norm_squared(problem.points[w] - problem.points[v]), w});
      }
      std::sort(all.begin(), all.end());
      for (int i = 0; i < 9; ++i) EXPECT_EQ(near.of(v)[i], all[i].second);
    }
  }
}

TEST(Neighbours, QuadrantListsReachOutOfClusters) {
  Problem problem;
  for (int i = 0; i < 20; ++i) problem.points.push_back({i * 0.01, (i % 3) * 0.01});
  problem.points.push_back({-100, -100});
  const Neighbours near = quadrant_neighbours(problem.points, 2, 8);
  const auto row = near.of(0);  // the corner of the cluster: nothing else lies to the lower left of it
  EXPECT_NE(std::find(row.begin(), row.end(), 20), row.end());
  for (int v = 0; v < near.size(); ++v) {
    std::vector<int> sorted(near.of(v).begin(), near.of(v).end());
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(std::adjacent_find(sorted.begin(), sorted.end()), sorted.end());
    EXPECT_EQ(std::count(sorted.begin(), sorted.end(), v), 0);
  }
}

TEST(Neighbours, FewPointsGiveShortLists) {
  EXPECT_EQ(nearest_neighbours(random_problem(3, 1).points, 24).count(), 2);
  EXPECT_EQ(nearest_neighbours(random_problem(1, 1).points, 24).count(), 0);
  EXPECT_EQ(quadrant_neighbours(random_problem(2, 1).points, 2, 24).count(), 1);
}

TEST(Lattice, SizesAreReadAndRecognised) {
  const auto size = parse_lattice("100x75");
  ASSERT_TRUE(size);
  EXPECT_EQ(size->columns, 100);
  EXPECT_EQ(size->rows, 75);
  for (const char* bad :
       {"", "x", "10x", "x10", "0x5", "10x-3", "10x10x10", "a280.tsp", "99999x2", "3.5x2"}) {
    EXPECT_FALSE(parse_lattice(bad)) << bad;
  }
  for (const char* meant : {"10x", "x10", "0x5", "99999x2", "100x75"})
    EXPECT_TRUE(is_like_lattice(meant)) << meant;
  for (const char* other : {"", "x", "10x10x10", "a280.tsp", "3.5x2", "./3x0"})
    EXPECT_FALSE(is_like_lattice(other)) << other;
  const auto lattice = Lattice::recognise(lattice_problem(7, 4, 2.5).points);
  ASSERT_TRUE(lattice);
  EXPECT_EQ(lattice->columns(), 7);
  EXPECT_EQ(lattice->rows(), 4);
  EXPECT_DOUBLE_EQ(lattice->pitch(), 2.5);
  EXPECT_TRUE(lattice->full());
  EXPECT_FALSE(Lattice::recognise(random_problem(50, 1).points));
}

TEST(Lattice, SweepsVisitEveryPointOnce) {
  for (const auto& [columns, rows] : {std::pair{5, 4}, {4, 5}, {5, 5}, {1, 6}, {6, 1}, {2, 2}, {3, 9}}) {
    Problem problem = lattice_problem(columns, rows);
    for (const bool holes : {false, true}) {
      if (holes && problem.size() > 8) problem.points.erase(problem.points.begin() + problem.size() / 2);
      const auto lattice = Lattice::recognise(problem.points);
      ASSERT_TRUE(lattice);
      for (const bool closed : {false, true}) {
        const auto tours = sweeps(*lattice, closed);
        ASSERT_FALSE(tours.empty());
        for (const Tour& tour : tours) EXPECT_TRUE(is_valid(problem, tour)) << columns << "x" << rows;
      }
    }
  }
}

}  // namespace
}  // namespace clearcut::order
