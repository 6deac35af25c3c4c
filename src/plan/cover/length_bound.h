// Lower bound of the length of paths that cover an area with a disc.
#pragma once

#include "geometry/region.h"

namespace clearcut::plan::cover {

/// mm; the greater of two lower bounds of the length of a covering path, at least 0.
///
/// Area       A path of length L sweeps at most 2 R L + pi R^2.
/// Witnesses  Points of the area, and the path must pass each within R. Around each point is a disc of half the
///            distance to the nearest other point; these discs do not overlap. To come within R of its point a closed
///            path crosses the ring between R and the disc's radius twice, in and out; an open one leaves out at most
///            one crossing at each of its ends.
double covering_length_bound(const Regions& area, double radius, bool closed);

}  // namespace clearcut::plan::cover
