// Proven optima of small problems, for every objective: dynamic programming over subsets [held1962], and complete
// enumeration if the value depends on the whole path.
#pragma once

#include <optional>

#include "order/objective.h"

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

}  // namespace clearcut::order
