// Chains of curves whose ends nearly meet become closed loops.
#pragma once

#include <string>
#include <vector>

#include "read/repair/repair.h"

namespace clearcut::read {

/// A closed loop and its source.
struct RawLoop {
  Loop loop;
  std::string source;
  std::optional<Compound> compound = {};
};

/// Joins ends at most tol.join_gap apart, nearest first, and closes curves declared as closed. If more than two ends
/// meet they are paired so that the loops touch there without crossing. Curves drawn twice count once. Throws
/// InputError naming the place of an unmatched end (OpenCurves::kRefuse). Cost O(n log n) unless very many ends are
/// within one gap; this is refused.
std::vector<RawLoop> join(std::vector<RawCurve> curves, const RepairOptions& options,
                          Diagnostics& diagnostics);

}  // namespace clearcut::read
