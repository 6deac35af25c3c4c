// Ordering as a whole: optimal on small problems, proven on lattices, true to its promises on all.
#include "order/solve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "order/bounds/lattice_bounds.h"
#include "order/bounds/line_cover.h"
#include "order/bounds/run_cover.h"
#include "order/exact.h"
#include "order/lattice.h"
#include "order/test_support.h"

namespace clearcut::order {
namespace {

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

/// Small problems of every kind: closed, open, fixed ends, precedence, duplicates, rounding.
Problem small_problem(int kind, int n, std::uint64_t seed) {
  Problem problem = random_problem(n, seed);
  if (seed % 2 == 0) {
    for (Vec2& p : problem.points) p = {std::round(p.x / 25), std::round(p.y / 25)};
  }
  if (seed % 3 == 0) problem.metric = Metric::kRoundedEuc2d;
  if (kind == 0) return problem;
  problem.shape = Shape::kOpenPath;
  if (kind == 2 && n > 1) problem.start = 1;
  if (kind == 3 && n > 1) problem.start = 0, problem.end = n - 1;
  if (kind == 4 && n > 3) problem.precedence = {{3, 0}, {2, 1}, {0, 1}};
  return problem;
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

/// Subsets of small lattices that a walk of unit steps can cross, with their best number of turns by search.
int fewest_turns_of_unit_steps(const Lattice& lattice) {
  int best = 1 << 20;
  std::vector<char> used(static_cast<std::size_t>(lattice.size()), 0);
  const auto walk = [&](auto&& self, int v, int dx, int dy, int count, int turns) -> void {
    if (turns >= best) return;
    if (count == lattice.size()) {
      best = turns;
      return;
    }
    constexpr int kSteps[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    for (const auto& step : kSteps) {
      const int w = lattice.at(lattice.column_of(v) + step[0], lattice.row_of(v) + step[1]);
      if (w < 0 || used[w]) continue;
      used[w] = 1;
      const bool turn = count > 1 && (step[0] != dx || step[1] != dy);
      self(self, w, step[0], step[1], count + 1, turns + (turn ? 1 : 0));
      used[w] = 0;
    }
  };
  for (int v = 0; v < lattice.size(); ++v) {
    used[v] = 1;
    walk(walk, v, 0, 0, 1, 0);
    used[v] = 0;
  }
  return best;
}

TEST(LatticeBounds, StayBelowTheBestOfUnitSteps) {
  Random random(17);
  int reached = 0, compared = 0;
  for (int trial = 0; trial < 300; ++trial) {
    Problem problem = lattice_problem(2 + trial % 4, 2 + trial / 4 % 3);
    for (std::uint64_t holes = random.below(5); holes > 0 && problem.size() > 4; --holes) {
      problem.points.erase(problem.points.begin() + static_cast<int>(random.below(problem.points.size())));
    }
    const auto lattice = Lattice::recognise(problem.points);
    if (!lattice) continue;
    const int best = fewest_turns_of_unit_steps(*lattice);
    if (best == 1 << 20) continue;  // no such path
    ++compared;
    const int bound = lattice_turns_bound(*lattice, false);
    EXPECT_LE(bound, best);
    EXPECT_LE(lattice_turns_bound_any_moves(*lattice, false), best);
    reached += bound == best;
    if (lattice->full()) {
      EXPECT_EQ(best, 2 * std::min(lattice->columns(), lattice->rows()) - 2);
      EXPECT_EQ(bound, best);
    }
  }
  EXPECT_GT(compared, 100);
  EXPECT_GT(reached, compared / 2);
}

TEST(RunCover, StaysBelowTheBestOfUnitSteps) {
  Random random(19);
  int reached = 0, compared = 0, fuller = 0;
  for (int trial = 0; trial < 200; ++trial) {
    Problem problem = lattice_problem(3 + trial % 4, 2 + trial / 4 % 3);
    for (std::uint64_t holes = random.below(6); holes > 0 && problem.size() > 4; --holes) {
      problem.points.erase(problem.points.begin() + static_cast<int>(random.below(problem.points.size())));
    }
    const auto lattice = Lattice::recognise(problem.points);
    if (!lattice) continue;
    const int best = fewest_turns_of_unit_steps(*lattice);
    if (best == 1 << 20) continue;  // no such path
    ++compared;
    const int bound = run_cover_bound(*lattice, false);
    EXPECT_LE(bound, best);
    reached += bound == best;
    fuller += bound > lattice_turns_bound(*lattice, false);
  }
  EXPECT_GT(compared, 60);
  EXPECT_GT(reached, compared / 4);
  EXPECT_GT(fuller, 0);
}

TEST(RunCover, KnowsThatRegionsAreCutInTheirOwnDirections) {
  // A tall and a wide rectangle side by side, joined by one point: strips of both kinds cover them cheaply, but
  // each needs its own rows.
  Problem problem;
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y < 12; ++y) problem.points.push_back({1.0 * x, 1.0 * y});
  }
  problem.points.push_back({4, 0});
  for (int x = 5; x < 17; ++x) {
    for (int y = 0; y < 4; ++y) problem.points.push_back({1.0 * x, 1.0 * y});
  }
  const auto lattice = Lattice::recognise(problem.points);
  ASSERT_TRUE(lattice);
  EXPECT_GE(run_cover_bound(*lattice, false), 12);
  EXPECT_GE(run_cover_bound(*lattice, true), 14);
}

/// A lattice of at most nine points.
Problem small_lattice(Random& random) {
  Problem problem =
      lattice_problem(2 + static_cast<int>(random.below(4)), 2 + static_cast<int>(random.below(3)));
  while (problem.size() > 9)
    problem.points.erase(problem.points.begin() + static_cast<int>(random.below(problem.points.size())));
  return problem;
}

/// Ways through one or two points somewhere.
DetourFunction random_detours(const Problem& problem, std::uint64_t seed) {
  const auto n = static_cast<std::size_t>(problem.size());
  Random random(seed);
  std::vector<std::vector<Vec2>> ways(n * n);
  for (auto& way : ways) {
    for (std::uint64_t left = 1 + random.below(2); left > 0; --left)
      way.push_back({4 * random.unit(), 4 * random.unit()});
  }
  return [ways, n](int from, int to) {
    const auto low = static_cast<std::size_t>(std::min(from, to)),
               high = static_cast<std::size_t>(std::max(from, to));
    std::vector<Vec2> way = ways[low * n + high];
    if (from > to) std::reverse(way.begin(), way.end());
    return way;
  };
}

int lines_of(const Problem& problem) {
  const Moves moves(problem);
  const auto lattice = Lattice::recognise(problem.points);
  return lattice ? line_cover_bound(*lattice, problem.closed(),
                                    [&](int a, int b) { return moves.is_straight(a, b); })
                 : 0;
}

TEST(LineCover, StaysBelowTheBestOfAnyMoves) {
  Random random(29);
  int reached = 0, compared = 0;
  for (int trial = 0; trial < 300; ++trial) {
    Problem problem = small_lattice(random);
    problem.shape = trial % 2 == 0 ? Shape::kOpenPath : Shape::kClosedTour;
    const auto best = solve_exact(Moves(problem), *turns_objective());
    ASSERT_TRUE(best);
    const int bound = lines_of(problem);
    EXPECT_LE(bound, best->value);
    ++compared;
    reached += bound == best->value;
  }
  EXPECT_GT(reached, compared / 6);
}

TEST(LineCover, StaysBelowTheBestOfWaysThatBend) {
  Random random(31);
  for (int trial = 0; trial < 200; ++trial) {
    Problem problem = small_lattice(random);
    problem.shape = Shape::kOpenPath;
    // Across a wall every move is illegal: a part of a legal move is legal.
    const auto ways = random_detours(problem, random.next());
    const std::uint64_t wall = random.below(3);
    problem.detour = [ways, wall, points = problem.points](int from, int to) {
      const auto side = [&](int v) {
        return points[static_cast<std::size_t>(v)].x > static_cast<double>(wall) + 0.5;
      };
      return side(from) == side(to) ? std::vector<Vec2>{} : ways(from, to);
    };
    const auto best = solve_exact(Moves(problem), *turns_objective());
    ASSERT_TRUE(best);
    EXPECT_LE(lines_of(problem), best->value);
  }
}

TEST(LineCover, IsSharpWhereOneDirectionServes) {
  for (const auto& [columns, rows] : {std::pair{40, 3}, std::pair{5, 60}, std::pair{24, 2}}) {
    Problem problem = lattice_problem(columns, rows);
    problem.shape = Shape::kOpenPath;
    EXPECT_EQ(lines_of(problem), 2 * std::min(columns, rows) - 2) << columns << "x" << rows;
  }
}

TEST(LatticeBounds, LengthHoldsForAnyMoves) {
  Random random(23);
  for (int trial = 0; trial < 60; ++trial) {
    Problem problem = lattice_problem(3 + trial % 2, 3);
    for (std::uint64_t holes = random.below(4); holes > 0; --holes) {
      problem.points.erase(problem.points.begin() + static_cast<int>(random.below(problem.points.size())));
    }
    const auto lattice = Lattice::recognise(problem.points);
    if (!lattice) continue;
    for (const Shape shape : {Shape::kClosedTour, Shape::kOpenPath}) {
      problem.shape = shape;
      const Moves moves(problem);
      const auto exact = solve_exact(moves, *length_objective());
      EXPECT_LE(lattice_length_bound(*lattice, problem.closed()), exact->value + 1e-9);
    }
  }
}

TEST(LowerBound, NeverExceedsTheOptimum) {
  double worst = 0;
  for (int kind = 0; kind < 4; ++kind) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      const Problem problem = small_problem(kind, 12, seed);
      const Moves moves(problem);
      const auto exact = solve_exact(moves, *length_objective());
      ASSERT_TRUE(exact);
      StopRule rule;
      const StopWatch watch(rule);
      const double bound = lower_bound(problem, *length_objective(), exact->tour, watch).value;
      EXPECT_LE(bound, exact->value + 1e-9) << kind << " " << seed;
      worst = std::max(worst, 1 - bound / exact->value);
    }
  }
  EXPECT_LT(worst, 0.15);  // and is worth having
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
