// The published genetic algorithm: fitness, selection, first population, replacement.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "order/genetic/fitness.h"
#include "order/genetic/operators.h"
#include "order/genetic/pool.h"
#include "order/genetic/selection.h"
#include "order/genetic/test_problems.h"
#include "order/test_support.h"

namespace clearcut::order {
namespace {

using testing::objectives;
using testing::open_lattice;
using testing::open_problem;
using testing::problem_of_kind;
using testing::random_genome;

/// Fig. 4-19: pricing altered edges gives what pricing everything gives.
TEST(Fitness, OfAlteredEdgesEqualsFitnessOfAll) {
  for (int kind = 0; kind < 3; ++kind) {
    for (int n = kind == 2 ? 4 : 2; n <= 14; ++n) {
      Problem problem = problem_of_kind(kind, n, static_cast<std::uint64_t>(n));
      for (Vec2& p : problem.points) p = {std::round(p.x / 20), std::round(p.y / 20)};
      const Moves moves(problem);
      const OperatorContext context(moves, 24);
      for (const auto& objective : objectives()) {
        Fitness fitness(moves, *objective);
        Random random(9);
        for (const std::string& name : mutation_names()) {
          for (int i = 0; i < 20; ++i) {
            Individual before{.genome = random_genome(problem, random)};
            fitness.evaluate(before);
            EXPECT_NEAR(before.value, evaluate(*objective, moves, before.genome.genes()), 1e-9);
            const Rearrangement change = mutation_named(name, context)->choose(before.genome, random);
            Individual after = before;
            after.genome.apply(change);
            const double priced = before.local + fitness.change(before.genome, change);
            const double altered = fitness.local_after(before, after.genome);
            fitness.evaluate(after);
            EXPECT_NEAR(priced, after.local, 1e-9) << name << " n " << n << " kind " << kind;
            EXPECT_NEAR(altered, after.local, 1e-9) << name << " n " << n << " kind " << kind;
          }
        }
      }
    }
  }
}

TEST(Selection, ChancesAreTheStatedOnes) {
  const std::vector<double> values{1, 2, 4, 8};  // fitness 1, 1/2, 1/4, 1/8
  const std::map<std::string, std::vector<double>> chances{
      {"random", {0.25, 0.25, 0.25, 0.25}},
      {"rank", {0.4, 0.3, 0.2, 0.1}},
      {"roulette", {8.0 / 15, 4.0 / 15, 2.0 / 15, 1.0 / 15}},
      {"tournament", {37.0 / 64, 19.0 / 64, 7.0 / 64, 1.0 / 64}},  // best of 3
      {"truncation", {0.5, 0.5, 0, 0}}};
  ASSERT_EQ(chances.size(), selection_names().size());
  constexpr int kDraws = 40000;
  for (const auto& [name, expected] : chances) {
    Random random(11);
    std::vector<int> count(values.size(), 0);
    const auto selection = selection_named(name);
    for (int i = 0; i < kDraws; ++i) ++count[static_cast<std::size_t>(selection->pick(values, random))];
    for (std::size_t i = 0; i < values.size(); ++i)  // 5 standard deviations
      EXPECT_NEAR(count[i] / double{kDraws}, expected[i], 5 * 0.5 / std::sqrt(kDraws)) << name << " " << i;
  }
}

TEST(Selection, RouletteTakesValuesOfZeroAndBelow) {
  Random random(1);
  const std::vector<double> values{-3, 0, 5};
  int best = 0;
  for (int i = 0; i < 3000; ++i) best += roulette_selection()->pick(values, random) == 0 ? 1 : 0;
  EXPECT_GT(best, 1500);
}

/// Mean share of edges over all pairs.
double mean_shared(const std::vector<Genome>& population, bool closed) {
  double sum = 0;
  int pairs = 0;
  for (std::size_t i = 0; i < population.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j, ++pairs) sum += shared_edges(population[i], population[j], closed);
  }
  return sum / pairs;
}

TEST(FirstPopulation, SharesFewEdgesWherePathsCan) {
  const Problem problem = open_lattice(12, 12);
  const Moves moves(problem);
  const OperatorContext context(moves, 24);
  Random random(1);
  const auto population = first_population(context, 25, 0.2, 16, random);
  ASSERT_EQ(population.size(), 25u);
  for (std::size_t i = 0; i < population.size(); ++i) {
    EXPECT_TRUE(is_valid(problem, population[i].genes()));
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_LE(shared_edges(population[i], population[j], problem.closed()), 0.2);
  }
}

TEST(FirstPopulation, OfPlainPathsTakesTheLeastSimilar) {
  const Problem problem = open_lattice(12, 12);
  const Moves moves(problem);
  const OperatorContext context(moves, 24);
  Random random(1), same(1);
  const auto compared = first_population(context, 25, 0.2, 1, random);
  const auto uncompared = first_population(context, 25, 1, 1, same);
  ASSERT_EQ(compared.size(), 25u);
  EXPECT_LT(mean_shared(compared, problem.closed()), mean_shared(uncompared, problem.closed()));
}

/// Of three points in a row all paths share an edge, so that the second one is drawn ten times; a path draws a number for each point.
TEST(FirstPopulation, IsDrawnAnewAtMostNineTimes) {
  const Problem problem = open_lattice(3, 1);
  const Moves moves(problem);
  const OperatorContext context(moves, 24);
  Random random(1), same(1);
  first_population(context, 2, 0.2, 1, random);
  for (int draws = 0; draws < 3 * (1 + 10); ++draws) same.next();
  EXPECT_EQ(random.state(), same.state());
}

TEST(FirstPopulation, KeepsEndsAndPrecedenceAndTakesTinyProblems) {
  for (int n = 1; n <= 6; ++n) {
    Problem problem = open_problem(n, 2);
    if (n > 3) problem.start = 1, problem.end = 0, problem.precedence = {{3, 2}};
    const Moves moves(problem);
    const OperatorContext context(moves, 24);
    Random random(1);
    for (const Genome& genome : first_population(context, 5, 0.2, 1, random))
      EXPECT_TRUE(is_valid(problem, genome.genes()));
  }
}

TEST(NearestPath, OfBreadthOneGoesToTheNearestUnused) {
  const Problem problem = open_problem(50, 6);
  const Moves moves(problem);
  const OperatorContext context(moves, 24);
  Random random(1);
  const Tour tour = nearest_path(context, 1, random);
  for (std::size_t i = 0; i + 1 < tour.size(); ++i) {
    for (std::size_t j = i + 2; j < tour.size(); ++j)
      EXPECT_LE(moves.length(tour[i], tour[i + 1]), moves.length(tour[i], tour[j]));
  }
}

TEST(LegalNeighbours, LeaveIllegalMovesOut) {
  Problem problem = open_lattice(6, 6);
  // A wall between the third and the fourth column, open below.
  problem.detour = [&](int a, int b) -> std::vector<Vec2> {
    const double low = std::min(problem.points[a].x, problem.points[b].x);
    const double high = std::max(problem.points[a].x, problem.points[b].x);
    return low < 2.5 && high > 2.5 ? std::vector<Vec2>{{2.5, -1}} : std::vector<Vec2>{};
  };
  const Moves moves(problem);
  for (const int count : {8, 0}) {
    const LegalNeighbours neighbours(moves, count);
    Random random(1);
    int crossing = 0;
    for (int i = 0; i < 500; ++i) {
      const int v = static_cast<int>(random.below(36));
      crossing += moves.is_straight(v, neighbours.pick(v, random)) ? 0 : 1;
    }
    EXPECT_LE(crossing, count == 0 ? 15 : 0);  // among all points a legal one is drawn for at most 8 times
  }
}

/// Tour 4.3.2: 24 where all points are asked for; legal ones are looked for among twice the number.
TEST(LegalNeighbours, AreTwoRingsOrTheLegalOnesOfTwiceAsMany) {
  Problem problem = open_lattice(6, 6);
  EXPECT_EQ(LegalNeighbours(Moves(problem), 0).nearest(14).size(), 24U);
  // Moves shorter than 2.2 are illegal: 12 of the 16 points next to one in the middle.
  problem.detour = [&](int a, int b) -> std::vector<Vec2> {
    return distance(problem.points[a], problem.points[b]) < 2.2 ? std::vector<Vec2>{{0, -1}}
                                                                : std::vector<Vec2>{};
  };
  const Moves moves(problem);
  EXPECT_EQ(LegalNeighbours(moves, 8).nearest(14).size(), 4U);
}

TEST(Replacement, DoesWhatItsNameSays) {
  const auto with = [](double value, Tour genes) {
    return Individual{.genome = Genome(std::move(genes)), .local = value, .value = value};
  };
  const auto pool = [&] {
    return Pool({with(10, {0, 1, 2, 3}), with(30, {1, 0, 2, 3}), with(20, {2, 1, 0, 3})}, false);
  };
  Pool worst = pool();
  Individual child = with(15, {3, 1, 2, 0});
  replace_worst()->offer(worst, child, 0);
  EXPECT_DOUBLE_EQ(worst.worst().value, 20);
  Pool parent = pool();
  child = with(15, {3, 1, 2, 0});
  replace_parent()->offer(parent, child, 0);  // worse than that parent
  EXPECT_DOUBLE_EQ(parent.worst().value, 30);
  replace_parent()->offer(parent, child, 2);
  EXPECT_DOUBLE_EQ(parent.at(2).value, 15);
  Pool distinct = pool();
  child = with(10, {0, 1, 2, 3});  // a copy
  replace_distinct()->offer(distinct, child, 1);
  EXPECT_DOUBLE_EQ(distinct.worst().value, 30);
  child = with(10, {3, 2, 0, 1});  // as good, but another
  replace_distinct()->offer(distinct, child, 1);
  EXPECT_DOUBLE_EQ(distinct.worst().value, 20);
  Pool whole = pool();
  const auto generation = replace_generation();
  child = with(50, {0, 1, 3, 2});
  generation->offer(whole, child, 0);
  child = with(40, {0, 2, 1, 3});
  generation->offer(whole, child, 0);
  EXPECT_DOUBLE_EQ(whole.worst().value, 30);
  generation->end_generation(whole);
  EXPECT_DOUBLE_EQ(whole.best().value, 10);
  EXPECT_DOUBLE_EQ(whole.worst().value, 50);
  EXPECT_DOUBLE_EQ(whole.values()[1], 40);
}

}  // namespace
}  // namespace clearcut::order
