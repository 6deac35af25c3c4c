// Edges too short to be anything but the rounding of a boolean.
#pragma once

#include "geometry/region.h"

namespace clearcut::inline geometry {

/// The regions with each run of edges of at most `shortest` mm replaced by one corner. Booleans of nearly coincident
/// outlines leave runs of short edges, and offsets are unreliable near them.
///
/// Error   a corner moves by no more than `shortest`; runs that are longer in total, or between two arcs, stay
///         unchanged. O(n).
Regions without_short_edges(const Regions& regions, double shortest);

}  // namespace clearcut::inline geometry
