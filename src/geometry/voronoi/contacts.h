// Exact detection of segments that touch, overlap or cross; the Voronoi builder must not be given any.
#pragma once

#include <span>
#include <vector>

#include "geometry/voronoi/sites.h"

namespace clearcut::inline geometry::voronoi {

/// Segment `segment` passes through the point `at`, not one of its ends.
struct Contact {
  int segment = 0;
  LatticePoint at;
  int element = -1;  ///< of the touching end point; -1 for a crossing
};

struct Contacts {
  std::vector<Contact> places;  ///< sorted by segment and along it, without repeats
  bool doubled = false;         ///< two segments have the same two ends
  bool mixed = false;           ///< two ends at one grid point represent different elements
};

/// Integer arithmetic: exact, but for the rounding of crossing points to the grid. O(n) expected for
/// outlines, over a grid of buckets.
Contacts find_contacts(std::span<const Segment> segments);

}  // namespace clearcut::inline geometry::voronoi
