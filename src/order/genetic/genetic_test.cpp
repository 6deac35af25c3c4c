// The published genetic algorithm: what each operator promises, and what the whole reaches.
#include "order/genetic/genetic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/error.h"
#include "order/genetic/crossover.h"
#include "order/genetic/fitness.h"
#include "order/genetic/initial.h"
#include "order/genetic/mutation.h"
#include "order/genetic/pool.h"
#include "order/genetic/replacement.h"
#include "order/genetic/selection.h"
#include "order/lattice.h"
#include "order/test_support.h"

namespace clearcut::order {
namespace {

Problem open_problem(int n, std::uint64_t seed) {
  Problem problem = random_problem(n, seed);
  problem.shape = Shape::kOpenPath;
  return problem;
}

Problem open_lattice(int columns, int rows) {
  Problem problem = lattice_problem(columns, rows);
  problem.shape = Shape::kOpenPath;
  return problem;
}

/// Closed, open, and open with both ends fixed.
Problem problem_of_kind(int kind, int n, std::uint64_t seed) {
  Problem problem = kind == 0 ? random_problem(n, seed) : open_problem(n, seed);
  if (kind == 2) problem.start = 0, problem.end = n - 1;
  return problem;
}

/// A random valid genome.
Genome random_genome(const Problem& problem, Random& random) {
  Tour tour = random_tour_of(problem.size(), random);
  if (problem.start >= 0) std::iter_swap(tour.begin(), std::find(tour.begin(), tour.end(), problem.start));
  if (problem.end >= 0) std::iter_swap(tour.end() - 1, std::find(tour.begin(), tour.end(), problem.end));
  return Genome(tour);
}

std::vector<ObjectivePtr> objectives() {
  return {length_objective(), turns_objective(), angle_objective(),
          weighted_sum({{1.0, length_objective()}, {5.0, turns_objective()}})};
}

/// Tour 3.6.2 (b.2.1) and table 3.1.
const Genome kParent1({0, 3, 7, 5, 4, 1, 8, 2, 6});
const Genome kParent2({0, 5, 8, 2, 6, 3, 1, 4, 7});

TEST(Crossover, EveryChildIsAValidOrder) {
  for (const std::string& name : crossover_names()) {
    for (int kind = 0; kind < 3; ++kind) {
      for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Problem problem = problem_of_kind(kind, 2 + static_cast<int>(seed) * 2, seed);
        const Moves moves(problem);
        const Ground ground(moves, 24);
        if (ground.free_count() < 2) continue;
        Random random(seed);
        const auto crossover = crossover_named(name, ground);
        Genome child;
        for (int i = 0; i < 10; ++i) {
          crossover->cross(random_genome(problem, random), random_genome(problem, random), random, child);
          EXPECT_TRUE(is_valid(problem, child.genes())) << name << " kind " << kind << " seed " << seed;
          for (int p = 0; p < child.size(); ++p) EXPECT_EQ(child.place(child.at(p)), p);
        }
      }
    }
  }
}

TEST(Crossover, TwoEqualParentsHaveThatChild) {
  for (const char* name : {"pmx", "ox", "cx", "eax"}) {
    const Problem problem = open_problem(20, 3);
    const Moves moves(problem);
    const Ground ground(moves, 24);
    Random random(1);
    const Genome parent = random_genome(problem, random);
    Genome child;
    crossover_named(name, ground)->cross(parent, parent, random, child);
    EXPECT_EQ(child.genes(), parent.genes()) << name;
  }
}

/// The text's two offspring: the stretch 5 4 1 of parent 1 in parent 2, and 2 6 3 of parent 2 in parent 1.
TEST(Crossover, PmxGivesTheTextsOffspring) {
  const Problem problem = open_problem(9, 1);
  const Moves moves(problem);
  const Ground ground(moves, 24);
  const auto crossover = pmx(ground);
  Random random(1);
  bool first_seen = false, second_seen = false;
  Genome child;
  for (int i = 0; i < 2000; ++i) {
    crossover->cross(kParent1, kParent2, random, child);
    first_seen = first_seen || child.genes() == Tour{0, 1, 7, 2, 6, 3, 8, 5, 4};
    crossover->cross(kParent2, kParent1, random, child);
    second_seen = second_seen || child.genes() == Tour{0, 2, 8, 5, 4, 1, 3, 6, 7};
  }
  EXPECT_TRUE(first_seen);
  EXPECT_TRUE(second_seen);
}

/// Outside the stretch a PMX child differs from the first parent only where a displaced gene went: at most as
/// many positions as inside.
TEST(Crossover, PmxKeepsMostOfTheFirstParent) {
  const Problem problem = open_problem(40, 2);
  const Moves moves(problem);
  const Ground ground(moves, 24);
  const auto crossover = pmx(ground);
  Random random(5);
  Genome child;
  for (int i = 0; i < 200; ++i) {
    const Genome a = random_genome(problem, random), b = random_genome(problem, random);
    crossover->cross(a, b, random, child);
    int as_first = 0, as_second = 0;
    for (int p = 0; p < 40; ++p) {
      as_first += child.at(p) == a.at(p) ? 1 : 0;
      as_second += child.at(p) == b.at(p) ? 1 : 0;
    }
    EXPECT_GE(as_first + 2 * as_second, 40);
    EXPECT_GE(as_second, 1);
  }
}

/// The genes that do not come from the second parent keep the order they have in the first.
TEST(Crossover, OxKeepsTheOrderOfTheRest) {
  const Problem problem = open_problem(30, 2);
  const Moves moves(problem);
  const Ground ground(moves, 24);
  const auto crossover = ox(ground);
  Random random(5);
  Genome child;
  for (int i = 0; i < 200; ++i) {
    const Genome a = random_genome(problem, random), b = random_genome(problem, random);
    crossover->cross(a, b, random, child);
    bool explained = false;
    for (int low = 0; low < 30 && !explained; ++low) {
      for (int high = low; high < 30 && !explained; ++high) {
        Tour rest;
        bool donated = true;
        for (int p = low; p <= high; ++p) donated = donated && child.at(p) == b.at(p);
        for (int p = 0; p < 30; ++p) {
          if (p < low || p > high) rest.push_back(a.place(child.at(p)));
        }
        explained = donated && std::is_sorted(rest.begin(), rest.end());
      }
    }
    EXPECT_TRUE(explained);
  }
}

TEST(Crossover, CxGivesEveryPositionAGeneOfOneOfTheParents) {
  const Problem problem = open_problem(30, 2);
  const Moves moves(problem);
  const Ground ground(moves, 24);
  const auto crossover = cx(ground);
  Random random(5);
  Genome child;
  for (int i = 0; i < 200; ++i) {
    const Genome a = random_genome(problem, random), b = random_genome(problem, random);
    crossover->cross(a, b, random, child);
    int from_second = 0;
    for (int p = 0; p < 30; ++p) {
      EXPECT_TRUE(child.at(p) == a.at(p) || child.at(p) == b.at(p));
      from_second += child.at(p) == b.at(p) ? 1 : 0;
    }
    EXPECT_GE(from_second, 1);
  }
}

/// Nearly all edges of an ERX child are edges of a parent; for the text's parents table 3.1 lists them.
TEST(Crossover, ErxInheritsEdges) {
  const Problem problem = random_problem(60, 2);
  const Moves moves(problem);
  const Ground ground(moves, 24);
  const auto crossover = erx(ground);
  Random random(5);
  Genome child;
  double shared = 0;
  for (int i = 0; i < 100; ++i) {
    const Genome a = random_genome(problem, random), b = random_genome(problem, random);
    crossover->cross(a, b, random, child);
    int inherited = 0;
    for (int p = 0; p < 60; ++p) {
      const int u = child.at(p), v = child.at((p + 1) % 60);
      inherited += has_edge(a, u, v, true) || has_edge(b, u, v, true) ? 1 : 0;
    }
    shared += inherited / 60.0;
  }
  EXPECT_GT(shared / 100, 0.75);
}

/// An EAX child has the edges of its parents, except the few that join subtours.
TEST(Crossover, EaxInheritsEdges) {
  const Problem problem = random_problem(100, 4);
  const Moves moves(problem);
  const Ground ground(moves, 24);
  const auto crossover = eax(ground);
  Random random(5);
  Genome child;
  int different = 0;
  for (int i = 0; i < 30; ++i) {
    const Genome a(nearest_path(ground, 2, random)), b(nearest_path(ground, 2, random));
    crossover->cross(a, b, random, child);
    int foreign = 0;
    for (int p = 0; p < 100; ++p) {
      const int u = child.at(p), v = child.at((p + 1) % 100);
      foreign += has_edge(a, u, v, true) || has_edge(b, u, v, true) ? 0 : 1;
    }
    EXPECT_LE(foreign, 30);
    different += child.genes() == a.genes() ? 0 : 1;
  }
  EXPECT_GT(different, 15);
}

TEST(Mutation, PromisesHold) {
  for (int kind = 0; kind < 3; ++kind) {
    const Problem problem = problem_of_kind(kind, 40, 7);
    const Moves moves(problem);
    const Ground ground(moves, 6);
    const bool closed = problem.closed();
    for (const std::string& name : mutation_names()) {
      const auto mutation = mutation_named(name, ground);
      Random random(3);
      int changed = 0;
      for (int i = 0; i < 300; ++i) {
        const Genome before = random_genome(problem, random);
        Genome after = before;
        after.apply(mutation->choose(before, random));
        ASSERT_TRUE(is_valid(problem, after.genes())) << name;
        const int edges = closed ? 40 : 39;
        const int fresh = edges - static_cast<int>(std::lround(shared_edges(after, before, closed) * edges));
        EXPECT_LE(fresh, name == "exchange" ? 4 : 2) << name;  // Tour 4.3.3 iii
        changed += fresh > 0 ? 1 : 0;
        if (name != "nearest" || fresh == 0) continue;
        bool near = false;  // one of the new edges joins near neighbours
        for (int p = 0; p < edges; ++p) {
          const int a = after.at(p), b = after.at((p + 1) % 40);
          if (has_edge(before, a, b, closed)) continue;
          const auto& of_a = ground.neighbours.nearest(a);
          const auto& of_b = ground.neighbours.nearest(b);
          near =
              near || std::count(of_a.begin(), of_a.end(), b) + std::count(of_b.begin(), of_b.end(), a) > 0;
        }
        EXPECT_TRUE(near);
      }
      EXPECT_GT(changed, 200) << name << " kind " << kind;
    }
  }
}

/// Fig. 4-19: pricing altered edges gives what pricing everything gives.
TEST(Fitness, OfAlteredEdgesEqualsFitnessOfAll) {
  for (int kind = 0; kind < 3; ++kind) {
    for (int n = kind == 2 ? 4 : 2; n <= 14; ++n) {
      Problem problem = problem_of_kind(kind, n, static_cast<std::uint64_t>(n));
      for (Vec2& p : problem.points) p = {std::round(p.x / 20), std::round(p.y / 20)};
      const Moves moves(problem);
      const Ground ground(moves, 24);
      for (const auto& objective : objectives()) {
        Fitness fitness(moves, *objective);
        Random random(9);
        for (const std::string& name : mutation_names()) {
          for (int i = 0; i < 20; ++i) {
            Individual before{.genome = random_genome(problem, random)};
            fitness.evaluate(before);
            EXPECT_NEAR(before.value, evaluate(*objective, moves, before.genome.genes()), 1e-9);
            const Rearrangement change = mutation_named(name, ground)->choose(before.genome, random);
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
  const Ground ground(moves, 24);
  Random random(1);
  const auto population = first_population(ground, 25, 0.2, 16, random);
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
  const Ground ground(moves, 24);
  Random random(1), same(1);
  const auto compared = first_population(ground, 25, 0.2, 1, random);
  const auto uncompared = first_population(ground, 25, 1, 1, same);
  ASSERT_EQ(compared.size(), 25u);
  EXPECT_LT(mean_shared(compared, problem.closed()), mean_shared(uncompared, problem.closed()));
}

TEST(FirstPopulation, KeepsEndsAndPrecedenceAndTakesTinyProblems) {
  for (int n = 1; n <= 6; ++n) {
    Problem problem = open_problem(n, 2);
    if (n > 3) problem.start = 1, problem.end = 0, problem.precedence = {{3, 2}};
    const Moves moves(problem);
    const Ground ground(moves, 24);
    Random random(1);
    for (const Genome& genome : first_population(ground, 5, 0.2, 1, random))
      EXPECT_TRUE(is_valid(problem, genome.genes()));
  }
}

TEST(NearestPath, OfBreadthOneGoesToTheNearestUnused) {
  const Problem problem = open_problem(50, 6);
  const Moves moves(problem);
  const Ground ground(moves, 24);
  Random random(1);
  const Tour tour = nearest_path(ground, 1, random);
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
        GeneticOptions options = generations(200);
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
    EXPECT_EQ(result.samples.back().generation, 300);
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
