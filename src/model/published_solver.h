// How the Tour text's genetic algorithm is run, where somebody asks for it.
#pragma once

#include <optional>
#include <string>

namespace clearcut::inline model {

/// The Tour text's genetic algorithm; what is left out is as published.
struct PublishedSolver {
  std::optional<long long> generations;  ///< at most; absent: until 1000 bring no gain (4.3.3)
  std::optional<int> population;
  std::optional<std::string> selection, crossover, mutation;  ///< names of operators
  std::optional<double> crossover_rate, mutation_rate;
  std::optional<double> most_shared;  ///< share of edges above which two individuals are too similar
};

}  // namespace clearcut::inline model
