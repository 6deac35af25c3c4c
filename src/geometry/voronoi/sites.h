// The boundary of a region as segments between points of an integer grid: the input of the Voronoi builder, which
// does not check its input and must not be given segments that touch, overlap or cross. Every segment and point
// stores its exact element.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "base/tolerances.h"
#include "geometry/region.h"
#include "geometry/voronoi/element.h"

namespace clearcut::inline geometry::voronoi {

struct LatticePoint {
  std::int32_t x = 0;
  std::int32_t y = 0;
  friend bool operator==(LatticePoint, LatticePoint) = default;
  friend auto operator<=>(LatticePoint, LatticePoint) = default;
};

/// Indices are those of Sites::elements.
struct Segment {
  LatticePoint from;
  LatticePoint to;
  int element = 0;
  int from_element = 0;
  int to_element = 0;
  /// A wall of no thickness: the element on its right side, whose edge runs in the opposite direction; -1 for all
  /// other sites.
  int back_element = -1;
};

/// Maps between mm and the grid.
struct Grid {
  Vec2 origin;
  double unit = 1e-4;  ///< mm
  LatticePoint to_grid(Vec2 p) const {
    return {static_cast<std::int32_t>(std::lround((p.x - origin.x) / unit)),
            static_cast<std::int32_t>(std::lround((p.y - origin.y) / unit))};
  }
  Vec2 to_mm(double x, double y) const { return {origin.x + x * unit, origin.y + y * unit}; }
  Vec2 to_mm(LatticePoint p) const { return to_mm(p.x, p.y); }
};

/// Distinct segments that meet only at their end points.
struct Sites {
  Grid grid;
  double error = 0;  ///< mm, greatest distance of a site from its element
  std::vector<Element> elements;
  std::vector<Segment> segments;
  std::vector<int> met;  ///< elements whose segments crossed, touched or overlapped
};

/// Greatest distance of an arc's tangents from the arc. mm.
struct SiteErrors {
  double usual = 0;
  std::map<int, double> of_element;  ///< errors that differ from `usual`
  double of(int element) const {
    const auto found = of_element.find(element);
    return found == of_element.end() ? usual : found->second;
  }
};

/// Runs of short lines become one line within `simplify` mm; vertices in one square of the grid become one.
/// Segments are split at points of contact, doubled ones made one. Elements have the same index for all errors.
Sites make_sites(const Region& region, const SiteErrors& errors, double simplify);

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
