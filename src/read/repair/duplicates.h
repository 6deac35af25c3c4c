// Curves and outlines that are drawn twice.
#pragma once

#include <optional>
#include <vector>

#include "read/repair/joining.h"

namespace clearcut::read {

/// Open curves of one edge that lie on each other (either way round, to within `gap`) count once.
std::vector<RawCurve> without_double_curves(std::vector<RawCurve> curves, double gap,
                                            const std::string& where, Diagnostics& diagnostics);

/// Open curves cut into edges, of which those with an end that nothing meets (an odd number of ends there) give up what
/// they share with another edge: one that lies wholly on another edge or on one of `loops` is dropped, and two that
/// overlap in part become one. Lines and arcs, to within `gap`. Nothing where there is no such edge. Cost O(n log n) for
/// few overlaps in one place.
std::optional<std::vector<RawCurve>> without_overlaps(const std::vector<RawCurve>& curves,
                                                      const std::vector<RawLoop>& loops, double gap,
                                                      const std::string& where, Diagnostics& diagnostics);

/// Loops that lie on each other to within `gap` count once: under the even-odd rule they would cancel.
std::vector<RawLoop> without_double_loops(std::vector<RawLoop> loops, double gap, const std::string& where,
                                          Diagnostics& diagnostics);

}  // namespace clearcut::read
