// A length that no path has which covers an area with a disc.
#pragma once

#include "geometry/region.h"

namespace clearcut::plan::cover {

/// mm; the greater of two lengths that no covering path falls short of, 0 at least.
///
/// Area       A path of length L sweeps at most 2 R L + pi R^2.
/// Witnesses  Points of the area, each of which the path comes within R of. About each stands a disc of half the distance to the
///            nearest other one; these do not overlap. To come within R of its point a closed path crosses the ring between R
///            and the disc's radius twice, in and out; an open one leaves out at most one crossing at each of its ends.
double covering_length_bound(const Regions& area, double radius, bool closed);

}  // namespace clearcut::plan::cover
