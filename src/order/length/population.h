// Number of occurrences of each edge in a population: the measure of diversity. A population of tours improved by
// edge assembly crossover [nagata2013]: localised single AB-cycles with entropy-preserving replacement, then blocks
// of AB-cycles.
#pragma once

#include <functional>
#include <vector>

#include "base/random.h"
#include "order/length/ab_cycles.h"
#include "order/length/assembly.h"
#include "order/length/length_model.h"
#include "order/stop.h"

namespace clearcut::order {

/// Lists per node; a node has few different neighbours in a population of good tours.
class EdgeCounts {
 public:
  explicit EdgeCounts(int nodes) : at_(static_cast<std::size_t>(nodes)) {}

  void add(const Links& tour);
  int count(int a, int b) const;
  void apply(const std::vector<EdgeChange>& changes);
  /// Change of the edge entropy -sum (F/N) ln(F/N) by the changes, N tours in the population (times N).
  double entropy_change(const std::vector<EdgeChange>& changes, int population) const;

 private:
  struct Entry {
    int other;
    int count;
  };
  void change(int a, int b, int by);
  std::vector<std::vector<Entry>> at_;  // at the smaller node of the edge
};

class Population {
 public:
  using Cost = LengthModel::Cost;

  struct Options {
    int children = 30;  ///< number of children of each pair of parents
    std::uint64_t seed = 1;
    long long generations = std::numeric_limits<long long>::max();
  };

  Population(const LengthModel& model, std::vector<std::vector<int>> tours, Options options);

  /// Generations until both stages stop improving, the watch ends or the generations are used up. Pairs are
  /// bred in parallel on the caller's arena, in batches of fixed size: the result does not depend on the
  /// threads. `improved` is called with each new best tour and ends the evolution by returning false.
  void evolve(const StopWatch& watch, const std::function<bool(const std::vector<int>&, Cost)>& improved);

  Cost best_cost() const;
  std::vector<int> best_nodes() const;
  double mean_cost() const;
  long long generation() const { return generation_; }

 private:
  struct Individual {
    Links links;
    Cost cost = 0;
  };
  struct Workspace;
  struct Offspring;
  enum class Stage { kSingle, kBlock };

  void run_generation(Stage stage, const StopWatch& watch, std::vector<Workspace>& workspaces);
  Offspring breed(const Individual& a, const Individual& b, Stage stage, Random random,
                  Workspace& workspace) const;
  void replace(Individual& a, const Offspring& offspring);
  int best_index() const;

  const LengthModel& model_;
  std::vector<Individual> individuals_;
  EdgeCounts counts_;
  Options options_;
  long long generation_ = 0;
};

}  // namespace clearcut::order
