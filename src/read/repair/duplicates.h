// Curves and outlines that are drawn twice.
#pragma once

#include <vector>

#include "read/repair/joining.h"

namespace clearcut {

/// Open curves of one edge that lie on each other (either way round, to within `gap`) count once.
std::vector<RawCurve> without_double_curves(std::vector<RawCurve> curves, double gap,
                                            const std::string& where, Diagnostics& diagnostics);

/// Loops that lie on each other to within `gap` count once: under the even-odd rule they would cancel.
std::vector<RawLoop> without_double_loops(std::vector<RawLoop> loops, double gap, const std::string& where,
                                          Diagnostics& diagnostics);

}  // namespace clearcut
