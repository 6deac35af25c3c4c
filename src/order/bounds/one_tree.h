// Held and Karp's lower bound for the length of tours and paths [held1971].
#pragma once

#include <span>

#include "order/length/length_model.h"
#include "order/stop.h"

namespace clearcut::order {

/// A lower bound of the length of any tour or path of the model, in the problem's unit; typically 0.7 % below the
/// optimum.
///
/// A minimum 1-tree with penalties on nodes bounds every tour from below. The penalties are found by
/// subgradient ascent [volgenant1982] on a sparse graph (candidate edges and `tour`, any valid tour of the
/// model); the bound itself is the 1-tree of the complete graph under the final penalties, found exactly
/// through a k-d tree, so the bound is valid regardless of edges missing in the sparse graph. Whole-number problems
/// are rounded up. Cost O(iterations n log n); deterministic unless `watch` ends first.
double held_karp_bound(const LengthModel& model, std::span<const int> tour, int iterations,
                       const StopWatch& watch);

}  // namespace clearcut::order
