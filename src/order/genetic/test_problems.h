// For tests: problems and genomes for the published genetic algorithm.
#pragma once

#include <algorithm>

#include "order/genetic/operator_context.h"
#include "order/lattice.h"
#include "order/objective.h"
#include "order/test_support.h"

namespace clearcut::order::testing {

inline Problem open_problem(int n, std::uint64_t seed) {
  Problem problem = random_problem(n, seed);
  problem.shape = Shape::kOpenPath;
  return problem;
}

inline Problem open_lattice(int columns, int rows) {
  Problem problem = lattice_problem(columns, rows);
  problem.shape = Shape::kOpenPath;
  return problem;
}

/// Closed, open, and open with both ends fixed.
inline Problem problem_of_kind(int kind, int n, std::uint64_t seed) {
  Problem problem = kind == 0 ? random_problem(n, seed) : open_problem(n, seed);
  if (kind == 2) problem.start = 0, problem.end = n - 1;
  return problem;
}

/// A random valid genome.
inline Genome random_genome(const Problem& problem, Random& random) {
  Tour tour = random_tour_of(problem.size(), random);
  if (problem.start >= 0) std::iter_swap(tour.begin(), std::find(tour.begin(), tour.end(), problem.start));
  if (problem.end >= 0) std::iter_swap(tour.end() - 1, std::find(tour.begin(), tour.end(), problem.end));
  return Genome(tour);
}

inline std::vector<ObjectivePtr> objectives() {
  return {length_objective(), turns_objective(), angle_objective(),
          weighted_sum({{1.0, length_objective()}, {5.0, turns_objective()}})};
}

}  // namespace clearcut::order::testing
