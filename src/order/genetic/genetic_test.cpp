// The published genetic algorithm as a whole: what it promises and what it reaches.
#include "order/genetic/genetic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

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
using testing::problem_of_kind;

GeneticOptions generations(long long count, std::uint64_t seed = 1) {
  GeneticOptions options;
  options.stop.rounds = count;
  options.seed = seed;
  return options;
}

TEST(Genetic, EveryCombinationOfOperatorsImprovesAndRepeats) {
  const Problem problem = problem_of_kind(2, 40, 5);
  for (const std::string& selection : selection_names()) {
    for (const std::string& crossover : crossover_names()) {
      for (const std::string& replacement : replacement_names()) {
        GeneticOptions options = generations(100);
        options.selection = selection;
        options.crossover = crossover;
        options.replacement = replacement;
        const GeneticResult a = run_genetic(problem, *length_objective(), options);
        const GeneticResult b = run_genetic(problem, *length_objective(), options);
        const std::string name = selection + " " + crossover + " " + replacement;
        EXPECT_EQ(a.tour, b.tour) << name;
        EXPECT_TRUE(is_valid(problem, a.tour)) << name;
        EXPECT_LT(a.value, a.samples.front().best) << name;
        EXPECT_NEAR(a.value, tour_length(problem, a.tour), 1e-6) << name;
      }
    }
  }
}

TEST(Genetic, NeverLosesItsBest) {
  for (const auto& objective : objectives()) {
    const GeneticResult result = run_genetic(open_lattice(8, 8), *objective, generations(300));
    for (std::size_t i = 1; i < result.samples.size(); ++i) {
      EXPECT_LE(result.samples[i].best, result.samples[i - 1].best + 1e-6);
      EXPECT_LE(result.samples[i].best, result.samples[i].mean + 1e-9);
      EXPECT_LE(result.samples[i].mean, result.samples[i].worst + 1e-9);
    }
    std::vector<long long> sampled;
    for (const GenerationSample& sample : result.samples) sampled.push_back(sample.generation);
    EXPECT_EQ(sampled, (std::vector<long long>{0,  1,  2,  3,  4,  5,  6,  7,  8,   9,   10,
                                               20, 30, 40, 50, 60, 70, 80, 90, 100, 200, 300}))
        << "eq. 5.1: n 10^i";
    EXPECT_EQ(result.children, 300 * 25);
    EXPECT_GE(result.improved, result.records);
  }
}

TEST(Genetic, EndsAfterGenerationsWithoutGain) {
  GeneticOptions options;
  options.patience = 7;
  const GeneticResult result = run_genetic(random_problem(1, 1), *length_objective(), options);
  EXPECT_EQ(result.generations, 0);  // nothing to order
  const GeneticResult two = run_genetic(random_problem(2, 1), *length_objective(), options);
  EXPECT_EQ(two.generations, 7);
}

TEST(Genetic, KeepsEndsPrecedenceAndDetours) {
  Problem problem = open_lattice(6, 6);
  problem.start = 0;
  problem.end = 35;
  problem.precedence = {{20, 3}, {30, 20}};
  problem.detour = [&](int a, int b) -> std::vector<Vec2> {
    const double low = std::min(problem.points[a].x, problem.points[b].x);
    const double high = std::max(problem.points[a].x, problem.points[b].x);
    return low < 2.5 && high > 2.5 ? std::vector<Vec2>{{2.5, -1}} : std::vector<Vec2>{};
  };
  const GeneticResult result = run_genetic(problem, *length_objective(), generations(200));
  EXPECT_TRUE(is_valid(problem, result.tour));
  EXPECT_NEAR(result.value, tour_length(problem, result.tour), 1e-9);
  EXPECT_LT(result.value, result.samples.front().best);
}

TEST(Genetic, SolutionsCarryBoundsBelowThem) {
  const Solution solution = solve_genetic(open_lattice(6, 6), *length_objective(), generations(2000));
  EXPECT_NEAR(solution.bound, 35, 1e-9);
  EXPECT_GE(solution.objective, 35 - 1e-9);
  EXPECT_NEAR(solution.gap, solution.objective / 35 - 1, 1e-9);
}

TEST(Genetic, RefusesWhatMakesNoSense) {
  const Problem problem = random_problem(5, 1);
  const auto with = [&](auto change) {
    GeneticOptions options = generations(1);
    change(options);
    return run_genetic(problem, *length_objective(), options);
  };
  EXPECT_THROW(with([](auto& o) { o.selection = "luck"; }), InputError);
  EXPECT_THROW(with([](auto& o) { o.crossover = "luck"; }), InputError);
  EXPECT_THROW(with([](auto& o) { o.mutation = "luck"; }), InputError);
  EXPECT_THROW(with([](auto& o) { o.replacement = "luck"; }), InputError);
  EXPECT_THROW(with([](auto& o) { o.population = 1; }), InputError);
  EXPECT_THROW(with([](auto& o) { o.children = 0; }), InputError);
  EXPECT_THROW(with([](auto& o) { o.crossover_rate = 2; }), InputError);
  EXPECT_THROW(with([](auto& o) { o.again_rate = 1; }), InputError);
  EXPECT_THROW(with([](auto& o) { o.patience = 0; }), InputError);
}

/// How far the text's algorithm ends above `optimum`; a quarter of the text's 10 million individuals.
double excess(const Problem& problem, double optimum, int runs) {
  double sum = 0;
  for (int seed = 1; seed <= runs; ++seed) {
    GeneticOptions options = generations(60000);
    options.seed = static_cast<std::uint64_t>(seed);
    sum += run_genetic(problem, *length_objective(), options).value / runs;
  }
  return sum / optimum;
}

/// Table 6.2, the instance of Qatar: the text ends 4.1 % above the optimum, ours 3 to 6 % after as many individuals. Random
/// points of the same number stand beside it; their best known length is the solver's, within its proven gap.
TEST(Genetic, EndsNearTheTextOn194Points) {
  const Problem ours = random_problem(194, 1);
  SolveOptions options;
  options.stop.rounds = 2;
  options.stop.seconds = std::numeric_limits<double>::infinity();
  const Solution solution = solve(ours, *length_objective(), options);
  EXPECT_LT(solution.gap, 0.02);
  const double above = excess(ours, solution.length, 1);
  EXPECT_LT(above, 1.12);
  EXPECT_GT(above, 1.0);
  if (const auto text = reference_text("qa194.tsp")) {
    const double qatar = excess(read_tsplib(*text, "qa194.tsp"), 9352, 2);
    EXPECT_LT(qatar, 1.09);
    EXPECT_GT(qatar, 1.0);
  }
}

/// Table 6.6, length of the open path through a lattice. Nearest-neighbour paths begin at the optimum there, so the first
/// paths are drawn from all points.
TEST(Genetic, EndsNearTheOptimumOnASmallLatticeFromRandomPaths) {
  double sum = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    GeneticOptions options = generations(20000);
    options.seed = seed;
    options.breadth = 100;
    const GeneticResult result = run_genetic(open_lattice(10, 10), *length_objective(), options);
    EXPECT_GT(result.samples.front().best, 2 * 99) << "begins far from the optimum";
    sum += 99 / result.value / 4;
  }
  EXPECT_GT(sum, 0.97);
}

}  // namespace
}  // namespace clearcut::order
