// The public face of ordering: a problem and an objective in, an order with its proven gap out. Proven optima of
// small problems, for every objective: dynamic programming over subsets [held1962], and complete enumeration if the
// value depends on the whole path.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "order/objective.h"
#include "order/problem.h"
#include "order/stop.h"

namespace clearcut::order {

struct ExactResult {
  Tour tour;
  double value = 0;
};

/// The largest number of points solve_exact() takes: 14 for edge sums, 12 (open) or 10 (closed) with corners,
/// 8 when the objective depends on the path; each well under a second.
int exact_limit(const Problem& problem, const Objective& objective);

/// An optimal valid tour, absent above the limit. Keeps ends and precedence.
/// Cost O(2^n n^2), with corners O(2^n n^3) (closed tours: times n); path-dependent O(n!).
std::optional<ExactResult> solve_exact(const Moves& moves, const Objective& objective);

struct SolveOptions {
  StopRule stop;
  std::uint64_t seed = 1;
  int threads = 0;                                ///< 0: all cores
  std::function<void(const Progress&)> progress;  ///< best so far, from the calling thread
};

struct Solution {
  Tour tour;  ///< indices of problem.points in visiting order
  double objective = 0;
  double length = 0;  ///< in the problem's metric
  int turns = 0;
  double angle_deg = 0;
  double bound = 0;         ///< no tour has a smaller objective
  std::string bound_basis;  ///< basis of the bound
  double gap = 0;           ///< (objective - bound) / bound; 0 when proven optimal
  double seconds = 0;
  std::uint64_t seed = 0;
  long long rounds = 0;  ///< rounds of the method; pass them as stop.rounds to repeat a run exactly
  std::string method;
};

/// Orders the points. Any size: up to about ten points the result is proven optimal, to about 20000 length is
/// within 0.1 % of the optimum in a minute, and a million fits in memory. Keeps fixed ends and precedence;
/// illegal moves cost their legal detour. The same seed gives the same tour on any number of threads, unless the
/// clock ends the search. Throws InputError for contradictory problems.
Solution solve(const Problem& problem, const Objective& objective, const SolveOptions& options);

/// Lower bound of an objective: combined from the bounds of length (1-tree, lattice) and turns (lattice).
/// `tour` is any valid tour with value `objective_value`; turn bounds for unit steps are used only if `tour` does not
/// undercut them.
struct Bound {
  double value = 0;
  std::string basis;
};
Bound lower_bound(const Problem& problem, const Objective& objective, const Tour& tour,
                  const StopWatch& watch);

/// Writes a tour, its value and the derived figures, bound and gap into a solution.
void set_result(Solution& solution, const Moves& moves, const Tour& tour, double objective,
                const Bound& bound);

}  // namespace clearcut::order
