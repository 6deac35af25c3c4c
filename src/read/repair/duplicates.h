// Curves and outlines drawn twice.
#pragma once

#include <optional>
#include <vector>

#include "read/repair/joining.h"

namespace clearcut::read {

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
