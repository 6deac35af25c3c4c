// The genetic algorithm of the Tour text (4.3), every operator exchangeable by name. docs/tour.md describes the
// algorithm.
//
// symbol       here                     where
// N            population               4.3.2, fig. 4-14: 25
// f_i          1 / Individual::value    eq. 4.12, 4.15
// X, X'        altered edges            eq. 4.15, fig. 4-19: Fitness::local_after, Fitness::change
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/random.h"
#include "order/genetic/fitness.h"
#include "order/search/solve.h"

namespace clearcut::order {

/// Defaults are the values of the text if stated. The text states no rates and no replacement: these were chosen by
/// measurement, see docs/tour.md.
struct GeneticOptions {
  int population = 25;                 ///< 4.3.2
  double most_shared = 0.2;            ///< share of edges above which two individuals are too similar, 4.3.2
  int breadth = 1;                     ///< number of nearest points from which a first path draws, 6.2.1
  std::string selection = "roulette";  ///< 4.3.3 i
  std::string crossover = "pmx";       ///< 4.3.3 ii
  std::string mutation = "nearest";    ///< 4.3.3 iii
  std::string replacement = "parent";
  double crossover_rate = 0.1;  ///< chance of a new individual to have two parents instead of one
  double mutation_rate = 1;     ///< chance of a new individual to be mutated
  double again_rate = 0.3;      ///< chance of a mutated individual to be mutated once more, and so on
  int children = 25;            ///< new individuals in a generation
  int neighbours = 24;          ///< 4.3.2; 0: all points, as for the text's reference instances, 5.3.2
  /// Generations without gain that end the run, 4.3.3. The text also has runs of 5 to 10 million individuals (5.3.2, 6.2.1), of which only
  /// the latter reach its figures for instances.
  long long patience = 1000;
  /// Also ends the run: `rounds` are generations. Without seconds the same seed gives the same result.
  StopRule stop{.seconds = std::numeric_limits<double>::infinity()};
  std::uint64_t seed = 1;
  std::function<void(const Progress&)> progress;
};

/// The population after a generation.
struct GenerationSample {
  long long generation = 0;
  double best = 0;
  double mean = 0;
  double worst = 0;
};

struct GeneticResult {
  Tour tour;
  double value = 0;
  long long generations = 0;
  long long children = 0;
  long long improved = 0;  ///< children better than both parents
  long long records = 0;   ///< children better than all before them
  double seconds = 0;
  std::vector<GenerationSample> samples;  ///< generation 0, those of eq. 5.1 (n 10^i, n = 1..9), the last
};

/// Runs the algorithm over any problem and objective. One thread; runs of a study go side by side. Children
/// that break precedence are dropped. Throws InputError for unknown operators and invalid sizes.
/// Cost O(1) for a rejected mutated child, O(n) for the others; objectives that depend on the whole
/// path are evaluated whole. Memory O(population n); no matrix of distances.
GeneticResult run_genetic(const Problem& problem, const Objective& objective, const GeneticOptions& options);

/// State of a run between two generations. Continuing from here gives the same result as an uninterrupted run.
struct GeneticState {
  std::vector<Individual> individuals{};
  Random random{1};
  long long idle = 0;       ///< generations since the last gain
  GeneticResult reached{};  ///< its tour and value are those of the best individual
};

/// The first population of a run. Throws as run_genetic.
GeneticState begin_genetic(const Problem& problem, const Objective& objective, const GeneticOptions& options);

/// Continues from `state` until `options` end the run; `stop.rounds` counts the generations from its beginning.
/// Throws as run_genetic.
GeneticState continue_genetic(const Problem& problem, const Objective& objective,
                              const GeneticOptions& options, GeneticState state);

/// The result of a finished run.
GeneticResult end_genetic(GeneticState state);

/// The same as a Solution with its proven gap, unknown to the algorithm itself.
Solution solve_genetic(const Problem& problem, const Objective& objective, const GeneticOptions& options);

}  // namespace clearcut::order
