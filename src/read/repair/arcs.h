// Arcs found again in outlines that were cut into many short lines.
#pragma once

#include <cstddef>
#include <vector>

#include "read/repair/joining.h"

namespace clearcut::read {

/// mm. How far vertices of a run may lie from its arc: the rounding of coordinates in drawings.
inline constexpr double kArcVertexTolerance = 0.001;
/// mm. How far the middles of its lines may: finer than any outline that means its corners.
inline constexpr double kArcChordTolerance = 0.005;
/// Runs shorter than this stay lines.
inline constexpr std::size_t kFewestChords = 5;

/// Replaces runs of lines that turn one way with vertices and middles on one circle, to within the
/// tolerances above: never across a corner, never a coarse polygon. Reports how many lines became how many
/// arcs. Cost O(n log n).
void find_arcs(std::vector<RawLoop>& loops, const RepairOptions& options, Diagnostics& diagnostics);

}  // namespace clearcut::read
