// Islands: a run goes on from where it stood as if it had never stopped, and migration moves the best.
#include "order/genetic/islands.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "order/genetic/operators.h"
#include "order/genetic/selection.h"
#include "order/genetic/test_problems.h"

namespace clearcut::order {
namespace {

using testing::objectives;
using testing::open_lattice;
using testing::problem_of_kind;

GeneticOptions settings(long long generations) {
  GeneticOptions options;
  options.stop.rounds = generations;
  options.breadth = 2;
  return options;
}

void expect_same(const GeneticResult& a, const GeneticResult& b, const std::string& name) {
  EXPECT_EQ(a.tour, b.tour) << name;
  EXPECT_EQ(a.value, b.value) << name;  // to the bit
  EXPECT_EQ(a.generations, b.generations) << name;
  EXPECT_EQ(a.children, b.children) << name;
  EXPECT_EQ(a.improved, b.improved) << name;
  EXPECT_EQ(a.records, b.records) << name;
  ASSERT_EQ(a.samples.size(), b.samples.size()) << name;
  for (std::size_t i = 0; i < a.samples.size(); ++i) {
    EXPECT_EQ(a.samples[i].generation, b.samples[i].generation) << name;
    EXPECT_EQ(a.samples[i].best, b.samples[i].best) << name;
    EXPECT_EQ(a.samples[i].mean, b.samples[i].mean) << name;
    EXPECT_EQ(a.samples[i].worst, b.samples[i].worst) << name;
  }
}

/// In pieces of 7 generations, each of which knows only the text of what the one before left.
GeneticResult in_pieces(const Problem& problem, const Objective& objective, const GeneticOptions& options) {
  std::string text = text_of_state(begin_genetic(problem, objective, options));
  for (long long generation = 7;; generation += 7) {
    auto state = state_of_text(text, options.population, problem.size());
    if (!state) throw InputError("state", "is none");
    GeneticOptions piece = options;
    piece.stop.rounds = std::min(generation, options.stop.rounds);
    *state = continue_genetic(problem, objective, piece, std::move(*state));
    if (piece.stop.rounds == options.stop.rounds) return end_genetic(std::move(*state));
    text = text_of_state(*state);
  }
}

TEST(GeneticState, ARunInPiecesIsTheRunInOne) {
  const Problem problem = problem_of_kind(2, 30, 5);
  for (const std::string& selection : selection_names()) {
    for (const std::string& crossover : crossover_names()) {
      for (const std::string& mutation : mutation_names()) {
        // Operators keep nothing between two calls that another one reads: one of the two is the text's.
        if (crossover != GeneticOptions().crossover && mutation != GeneticOptions().mutation) continue;
        for (const std::string& replacement : replacement_names()) {
          GeneticOptions options = settings(40);
          options.selection = selection;
          options.crossover = crossover;
          options.mutation = mutation;
          options.replacement = replacement;
          options.crossover_rate = 0.5;
          expect_same(in_pieces(problem, *length_objective(), options),
                      run_genetic(problem, *length_objective(), options),
                      selection + " " + crossover + " " + mutation + " " + replacement);
        }
      }
    }
  }
  for (const auto& objective : objectives())
    expect_same(in_pieces(open_lattice(6, 6), *objective, settings(100)),
                run_genetic(open_lattice(6, 6), *objective, settings(100)), "an objective");
}

TEST(GeneticState, WhatIsNoStateIsNotTakenForOne) {
  const Problem problem = open_lattice(3, 3);
  const GeneticOptions options = settings(20);
  const std::string text = text_of_state(continue_genetic(
      problem, *length_objective(), options, begin_genetic(problem, *length_objective(), options)));
  ASSERT_TRUE(state_of_text(text, 25, 9));
  EXPECT_EQ(text_of_state(*state_of_text(text, 25, 9)), text);
  EXPECT_FALSE(state_of_text(text, 24, 9));
  EXPECT_FALSE(state_of_text(text, 26, 9));
  EXPECT_FALSE(state_of_text(text, 25, 8));
  EXPECT_FALSE(state_of_text(text + " end", 25, 9));
  for (std::size_t size = 0; size < text.size(); ++size)
    EXPECT_FALSE(state_of_text(text.substr(0, size), 25, 9)) << size;
  std::string twice = text;  // one gene twice, another not at all
  const auto last = twice.rfind(' ');
  twice[last - 1] = twice[last - 3];
  EXPECT_FALSE(state_of_text(twice, 25, 9));
}

/// Individuals of these values, all different.
GeneticState state_of(const std::vector<double>& values, int first_gene) {
  GeneticState state;
  for (const double value : values) {
    Tour genes{0, 1, 2, 3, 4, 5, 6, 7};
    std::rotate(genes.begin(), genes.begin() + first_gene++, genes.end());
    state.individuals.push_back({.genome = Genome(genes), .local = value, .value = value});
  }
  return state;
}

std::vector<double> values_of(const GeneticState& state) {
  std::vector<double> values;
  for (const Individual& individual : state.individuals) values.push_back(individual.value);
  return values;
}

TEST(Migration, TheBestTakeThePlacesOfTheWorst) {
  const GeneticState from = state_of({5, 1, 3}, 0);
  GeneticState into = state_of({4, 9, 7}, 3);
  migrate(from, into, 2);
  EXPECT_EQ(values_of(into), (std::vector<double>{4, 1, 3}));
  EXPECT_EQ(into.individuals[1].genome.genes(), from.individuals[1].genome.genes());
  migrate(from, into, 2);  // they are there already
  EXPECT_EQ(values_of(into), (std::vector<double>{4, 1, 3}));
  migrate(from, into, 0);
  EXPECT_EQ(values_of(into), (std::vector<double>{4, 1, 3}));
}

TEST(Migration, WhatIsNoBetterIsNotTakenIn) {
  const GeneticState from = state_of({8, 9, 7}, 0);
  GeneticState into = state_of({4, 6, 7}, 3);
  migrate(from, into, 2);
  EXPECT_EQ(values_of(into), (std::vector<double>{4, 6, 7}));
}

/// All epochs, island by island as far as each can go.
std::vector<GeneticState> run_all(const Problem& problem, const GeneticOptions& options,
                                  const IslandOptions& islands) {
  std::vector<GeneticState> states;
  for (long long epoch = 1; epoch <= epoch_count(islands, options); ++epoch) {
    const std::vector<GeneticState> before = states;
    states.clear();
    for (int island = 0; island < islands.islands; ++island) {
      const auto at = [&](int i) { return before.empty() ? nullptr : &before[static_cast<std::size_t>(i)]; };
      states.push_back(run_epoch(problem, *length_objective(), options, islands, {island, epoch}, at(island),
                                 at(island_before(island, islands))));
    }
  }
  return states;
}

TEST(Islands, OneIslandIsTheRunWithout) {
  GeneticOptions options = settings(60);
  const auto alone = run_genetic(open_lattice(6, 6), *length_objective(), options);
  options.patience = 1;  // counts for nothing
  expect_same(end_islands(run_all(open_lattice(6, 6), options, {1, 10, 1})), alone, "one");
}

TEST(Islands, WithoutMigrantsEachIsARunOfItsOwn) {
  const GeneticOptions options = settings(60);
  const auto states = run_all(open_lattice(6, 6), options, {3, 25, 0});
  expect_same(end_genetic(states[0]), run_genetic(open_lattice(6, 6), *length_objective(), options), "first");
  EXPECT_NE(states[1].reached.tour, states[2].reached.tour);
  const GeneticResult all = end_islands(states);
  EXPECT_EQ(all.children, 3 * 60 * 25);
  double mean = 0;
  for (const GeneticState& state : states) {
    EXPECT_EQ(state.reached.generations, 60);
    const GeneticResult one = end_genetic(state);
    EXPECT_LE(all.samples.back().best, one.samples.back().best);
    EXPECT_GE(all.samples.back().worst, one.samples.back().worst);
    mean += one.samples.back().mean / 3;
  }
  EXPECT_NEAR(all.samples.back().mean, mean, 1e-9);
  EXPECT_EQ(all.value, all.samples.back().best);
}

TEST(Islands, TheBestOfOneReachesAll) {
  const auto states = run_all(open_lattice(8, 8), settings(400), {4, 20, 2});
  const auto apart = run_all(open_lattice(8, 8), settings(400), {4, 20, 0});
  const auto spread = [](const std::vector<GeneticState>& all) {
    const auto [low, high] = std::minmax_element(all.begin(), all.end(), [](const auto& a, const auto& b) {
      return a.reached.value < b.reached.value;
    });
    return high->reached.value - low->reached.value;
  };
  EXPECT_LT(spread(states), spread(apart));
  EXPECT_LE(end_islands(states).value, end_islands(apart).value);
}

TEST(Islands, RefusesWhatMakesNoSense) {
  const GeneticOptions options = settings(10);
  EXPECT_THROW(check_islands({0, 10, 1}, options), InputError);
  EXPECT_THROW(check_islands({2, 0, 1}, options), InputError);
  EXPECT_THROW(check_islands({2, 10, -1}, options), InputError);
  EXPECT_THROW(check_islands({2, 10, 25}, options), InputError);
  check_islands({2, 10, 24}, options);
  EXPECT_EQ(epoch_count({2, 4, 1}, options), 3);
  EXPECT_EQ(epoch_count({2, 5, 1}, options), 2);
  EXPECT_EQ(epoch_count({2, 50, 1}, options), 1);
}

}  // namespace
}  // namespace clearcut::order
