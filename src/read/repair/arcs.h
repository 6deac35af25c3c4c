// Recovers arcs in outlines divided into many short lines.
#pragma once

#include <cstddef>
#include <vector>

#include "read/repair/joining.h"

namespace clearcut::read {

/// mm. Greatest distance of a run's vertices from its arc: the rounding of coordinates in drawings.
inline constexpr double kArcVertexTolerance = 0.001;
/// mm. Greatest distance of the middles of its lines: finer than any outline with intended corners.
inline constexpr double kArcChordTolerance = 0.005;
/// Runs shorter than this stay lines.
inline constexpr std::size_t kFewestChords = 5;

/// Replaces runs of lines with turns in one direction and with vertices and middles on one circle, to within the
/// tolerances above: never across a corner, never a coarse polygon. Reports the numbers of replaced lines and of
/// arcs. Cost O(n log n).
void find_arcs(std::vector<RawLoop>& loops, const RepairOptions& options, Diagnostics& diagnostics);

}  // namespace clearcut::read
