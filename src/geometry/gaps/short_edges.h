// Edges too short to be anything but the rounding of a boolean.
#pragma once

#include "geometry/region.h"

namespace clearcut::inline geometry {

/// The regions with each run of edges of at most `shortest` mm drawn together into one corner: where outlines all but coincide,
/// booleans leave such edges, and offsets are not reliable around them.
///
/// Error   a corner moves by no more than `shortest`; runs that are longer in all, or lie between two arcs, stay as they are. O(n).
Regions without_short_edges(const Regions& regions, double shortest);

}  // namespace clearcut::inline geometry
