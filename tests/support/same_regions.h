// How far two regions' boundaries are from each other.
#pragma once

#include <algorithm>

#include "geometry/region.h"

namespace clearcut::test_support {

inline std::vector<Edge> all_edges(const Regions& regions) {
  std::vector<Edge> edges;
  for (const Region& region : regions)
    for (const Edge& edge : region.edges()) edges.push_back(edge);
  return edges;
}

/// Greatest distance of ends, quarters and middles of `from`'s edges from the boundary of `to`. mm.
inline double one_sided_gap(const Regions& from, const Regions& to) {
  const std::vector<Edge> edges = all_edges(to);
  double gap = 0;
  for (const Edge& edge : all_edges(from)) {
    for (const double t : {0.0, 0.25, 0.5, 0.75}) {
      double nearest_distance = std::numeric_limits<double>::infinity();
      for (const Edge& other : edges)
        nearest_distance = std::min(nearest_distance, distance(other, edge.at(t)));
      gap = std::max(gap, nearest_distance);
    }
  }
  return gap;
}

/// Both ways; 0 for equal regions, infinite where one is empty.
inline double boundary_gap(const Regions& a, const Regions& b) {
  if (a.empty() && b.empty()) return 0;
  if (a.empty() || b.empty()) return std::numeric_limits<double>::infinity();
  return std::max(one_sided_gap(a, b), one_sided_gap(b, a));
}

}  // namespace clearcut::test_support
