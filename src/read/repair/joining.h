// Chains of curves whose ends nearly meet become closed loops; curves and outlines drawn twice count once.
#pragma once

#include <optional>
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

/// Coincident open curves of one edge (in either direction, within `gap`) count once.
std::vector<RawCurve> without_double_curves(std::vector<RawCurve> curves, double gap,
                                            const std::string& where, Diagnostics& diagnostics);

/// Open curves divided into edges. Edges with an unmatched end (an odd number of ends there) lose the parts shared
/// with another edge: an edge wholly on another edge or on one of `loops` is dropped, and two partly overlapping
/// edges become one. Lines and arcs, within `gap`. Nothing if there is no such edge. Cost O(n log n) for few overlaps
/// in one place.
std::optional<std::vector<RawCurve>> without_overlaps(const std::vector<RawCurve>& curves,
                                                      const std::vector<RawLoop>& loops, double gap,
                                                      const std::string& where, Diagnostics& diagnostics);

/// Coincident loops (within `gap`) count once: under the even-odd rule they would cancel.
std::vector<RawLoop> without_double_loops(std::vector<RawLoop> loops, double gap, const std::string& where,
                                          Diagnostics& diagnostics);

}  // namespace clearcut::read
