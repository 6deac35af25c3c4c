// For tests: small problems of every kind.
#pragma once

#include <cmath>

#include "order/test_support.h"

namespace clearcut::order::testing {

/// Small problems of every kind: closed, open, fixed ends, precedence, duplicates, rounding.
inline Problem small_problem(int kind, int n, std::uint64_t seed) {
  Problem problem = random_problem(n, seed);
  if (seed % 2 == 0) {
    for (Vec2& p : problem.points) p = {std::round(p.x / 25), std::round(p.y / 25)};
  }
  if (seed % 3 == 0) problem.metric = Metric::kRoundedEuc2d;
  if (kind == 0) return problem;
  problem.shape = Shape::kOpenPath;
  if (kind == 2 && n > 1) problem.start = 1;
  if (kind == 3 && n > 1) problem.start = 0, problem.end = n - 1;
  if (kind == 4 && n > 3) problem.precedence = {{3, 0}, {2, 1}, {0, 1}};
  return problem;
}

}  // namespace clearcut::order::testing
