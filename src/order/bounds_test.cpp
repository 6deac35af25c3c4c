// Lower bounds of orders never exceed what any order reaches.
#include "order/bounds/bounds.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "order/lattice.h"
#include "order/search/solve.h"
#include "order/test_support.h"

namespace clearcut::order {
namespace {

using testing::small_problem;

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

}  // namespace
}  // namespace clearcut::order
