// Ordering as a whole: optimal on small problems, proven on lattices, true to its promises on all.
#include "order/search/solve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "order/bounds/bounds.h"
#include "order/lattice.h"
#include "order/test_support.h"

namespace clearcut::order {
namespace {

using testing::small_problem;

SolveOptions rounds(long long count, std::uint64_t seed = 1) {
  SolveOptions options;
  options.stop.seconds = 1000;
  options.stop.rounds = count;
  options.seed = seed;
  return options;
}

/// The smallest value over all orders.
double by_all_orders(const Problem& problem, const Objective& objective) {
  const Moves moves(problem);
  Tour tour(problem.points.size());
  std::iota(tour.begin(), tour.end(), 0);
  double best = std::numeric_limits<double>::infinity();
  do {
    if (is_valid(problem, tour)) best = std::min(best, evaluate(objective, moves, tour));
  } while (std::next_permutation(tour.begin(), tour.end()));
  return best;
}

std::vector<ObjectivePtr> all_objectives() {
  return {length_objective(), turns_objective(), angle_objective(), time_objective(600),
          weighted_sum({{1.0, length_objective()}, {5.0, turns_objective()}, {0.05, angle_objective()}})};
}

TEST(Exact, EqualsTheBestOfAllOrders) {
  for (int kind = 0; kind < 5; ++kind) {
    for (int n = 1; n <= 7; ++n) {
      for (const auto& objective : all_objectives()) {
        const Problem problem = small_problem(kind, n, static_cast<std::uint64_t>(kind * 10 + n));
        const Moves moves(problem);
        const auto result = solve_exact(moves, *objective);
        ASSERT_TRUE(result);
        ASSERT_TRUE(is_valid(problem, result->tour)) << kind << " " << n << " " << objective->name();
        EXPECT_NEAR(result->value, by_all_orders(problem, *objective), 1e-9)
            << kind << " " << n << " " << objective->name();
        EXPECT_NEAR(evaluate(*objective, moves, result->tour), result->value, 1e-9);
      }
    }
  }
}

TEST(Solve, SmallProblemsAreProvenOptimal) {
  for (int kind = 0; kind < 5; ++kind) {
    for (int n = 1; n <= 9; ++n) {
      const Problem problem = small_problem(kind, n, static_cast<std::uint64_t>(n));
      const Solution solution = solve(problem, *length_objective(), rounds(1));
      EXPECT_TRUE(is_valid(problem, solution.tour));
      EXPECT_EQ(solution.gap, 0);
      EXPECT_NEAR(solution.length, tour_length(problem, solution.tour), 1e-9);
    }
  }
}

TEST(Solve, MediumProblemsReachTheExactOptimum) {
  // Just below the exact limit the searches must agree with the dynamic program; just above it they run
  // alone.
  for (int kind = 0; kind < 4; ++kind) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      Problem problem = small_problem(kind, 13, seed);
      const Moves moves(problem);
      const auto exact = solve_exact(moves, *length_objective());
      ASSERT_TRUE(exact);
      // A fifteenth and sixteenth point on top of the others change nothing but the size.
      const int n = problem.size();
      for (int i = 0; i < 3; ++i) problem.points.push_back(problem.points[4]);
      if (problem.end == n - 1) std::swap(problem.points[problem.end], problem.points[4]), problem.end = 4;
      const Solution solution = solve(problem, *length_objective(), rounds(1, seed));
      EXPECT_TRUE(is_valid(problem, solution.tour));
      EXPECT_NEAR(solution.length, exact->value, 1e-6) << kind << " " << seed;
      EXPECT_LE(solution.bound, exact->value + 1e-9);
    }
  }
}

TEST(Solve, TheSameSeedGivesTheSameTourOnAnyThreads) {
  const Problem closed = random_problem(300, 4);
  Problem open = random_problem(300, 5);
  open.shape = Shape::kOpenPath;
  for (const Problem& problem : {closed, open}) {
    for (const auto& objective :
         {length_objective(), weighted_sum({{1.0, length_objective()}, {2.0, turns_objective()}})}) {
      SolveOptions options = rounds(1, 7);
      options.threads = 1;
      const Solution one = solve(problem, *objective, options);
      options.threads = 2;
      const Solution two = solve(problem, *objective, options);
      EXPECT_EQ(one.tour, two.tour);
      EXPECT_EQ(one.objective, two.objective);
      EXPECT_EQ(one.bound, two.bound);
      const Solution again = solve(problem, *objective, options);
      EXPECT_EQ(again.tour, two.tour);
    }
  }
}

TEST(Solve, ProgressOnlyImproves) {
  const Problem problem = random_problem(400, 6);
  double last = std::numeric_limits<double>::infinity();
  int calls = 0;
  SolveOptions options = rounds(1);
  options.progress = [&](const Progress& progress) {
    EXPECT_LT(progress.objective, last);
    EXPECT_TRUE(is_valid(problem, progress.tour));
    EXPECT_NEAR(tour_length(problem, progress.tour), progress.objective, 1e-6);
    last = progress.objective;
    ++calls;
  };
  const Solution solution = solve(problem, *length_objective(), options);
  EXPECT_GT(calls, 3);
  EXPECT_EQ(solution.objective, last);
}

TEST(Solve, StopsForTimeGapAndCancel) {
  const Problem problem = random_problem(3000, 8);
  SolveOptions options;
  options.stop.seconds = 0.2;
  EXPECT_TRUE(is_valid(problem, solve(problem, *length_objective(), options).tour));
  std::atomic<bool> cancel{true};
  options.stop.seconds = 1000;
  options.stop.cancel = &cancel;
  const Solution cancelled = solve(problem, *length_objective(), options);
  EXPECT_TRUE(is_valid(problem, cancelled.tour));
  EXPECT_LT(cancelled.seconds, 20);
  options.stop.cancel = nullptr;
  options.stop.gap = 0.10;
  const Solution near = solve(problem, *length_objective(), options);
  EXPECT_LE(near.gap, 0.10);
  EXPECT_EQ(near.rounds, 0);
}

struct LatticeRow {
  int columns, rows;
  double open_length, closed_length;
  int open_turns;
  double open_angle;
  int closed_turns;
};

// The table of lattices with known optima; Tour table 6.3 (18.33 turns, 1636.8 degrees) and 6.6 (97.3 to 99.9
// %).
const LatticeRow kLattices[] = {
    {10, 10, 99, 100, 18, 1620, 20},
    {75, 100, 7499, 7500, 148, 13320, 150},
    {80, 100, 7999, 8000, 158, 14220, 160},
    {100, 100, 9999, 10000, 198, 17820, 200},
};

TEST(Solve, LatticesReachTheirProvenOptima) {
  for (const LatticeRow& row : kLattices) {
    Problem problem = lattice_problem(row.columns, row.rows, 2.0);
    EXPECT_DOUBLE_EQ(solve(problem, *length_objective(), rounds(1)).length, 2 * row.closed_length);
    EXPECT_EQ(solve(problem, *turns_objective(), rounds(1)).bound, row.closed_turns);
    problem.shape = Shape::kOpenPath;
    const Solution length = solve(problem, *length_objective(), rounds(1));
    EXPECT_DOUBLE_EQ(length.length, 2 * row.open_length);
    EXPECT_EQ(length.gap, 0);
    const Solution turns = solve(problem, *turns_objective(), rounds(1));
    EXPECT_EQ(turns.turns, row.open_turns);
    EXPECT_EQ(turns.gap, 0);
    EXPECT_LT(turns.seconds, row.columns == 10 ? 0.52 : 11.23) << "the shortest times of Tour table 6.6";
    const Solution angle = solve(problem, *angle_objective(), rounds(1));
    EXPECT_NEAR(angle.angle_deg, row.open_angle, 1e-6);
    EXPECT_EQ(angle.gap, 0);
    const auto sum =
        weighted_sum({{1.0, length_objective()}, {3.0, turns_objective()}, {0.1, angle_objective()}});
    EXPECT_NEAR(solve(problem, *sum, rounds(1)).objective,
                2 * row.open_length + row.open_turns * (3 + 90 * 0.1), 1e-6);
  }
}

TEST(Solve, DetoursAreRoutedAround) {
  // A wall at x = 5 with a gate at y = 9.5: crossing it below costs the way through the gate.
  Problem problem = lattice_problem(10, 10);
  problem.shape = Shape::kOpenPath;
  const auto points = problem.points;
  problem.detour = [points](int from, int to) -> std::vector<Vec2> {
    const Vec2 a = points[from], b = points[to];
    if ((a.x < 4.5) == (b.x < 4.5)) return {};
    const double y = a.y + (b.y - a.y) * (4.5 - a.x) / (b.x - a.x);
    if (y >= 8.6) return {};
    return {{4.5, 8.6}};
  };
  const Solution solution = solve(problem, *length_objective(), rounds(1));
  EXPECT_TRUE(is_valid(problem, solution.tour));
  EXPECT_NEAR(solution.length, 99, 1e-9);  // two halves joined in the top row
  EXPECT_EQ(solution.gap, 0);
}

void expect_optimum(const Problem& problem, double optimum) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const Solution solution = solve(problem, *length_objective(), rounds(2, seed));
    EXPECT_EQ(solution.length, optimum) << problem.name << " seed " << seed;
    EXPECT_LE(solution.bound, optimum);
    EXPECT_LT(solution.gap, 0.02);
  }
}

TEST(Solve, InstancesReachTheirKnownOptimum) {
  for (const KnownInstance& known : known_instances()) {
    const Problem problem = read_tsplib(known.text, known.name);
    expect_optimum(problem, tour_length(problem, known.tour));
  }
  for (const auto& [file, optimum] : {std::pair{"berlin52.tsp", 7542.0},
                                      {"qa194.tsp", 9352.0},
                                      {"a280.tsp", 2579.0},
                                      {"pcb442.tsp", 50778.0}}) {
    if (const auto text = reference_text(file)) expect_optimum(read_tsplib(*text, file), optimum);
  }
}

/// Three clusters far apart, few enough for complete enumeration.
TEST(Solve, ClustersReachTheOptimumOfTheExactMethod) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    Problem problem;
    for (int i = 0; i < 13; ++i)
      problem.points.push_back(direction_of(2.1 * (i % 3)) * 60 +
                               Vec2{random.between(0, 20), random.between(0, 20)});
    const auto objective = length_objective();
    const auto exact = solve_exact(Moves(problem), *objective);
    ASSERT_TRUE(exact);
    EXPECT_NEAR(solve(problem, *objective, rounds(1, seed)).length, exact->value, 1e-9) << "seed " << seed;
  }
}

}  // namespace
}  // namespace clearcut::order
