// Curves on which a cutter just fits: parts of the medial axis with clearance equal to the cutter's radius.
#pragma once

#include "geometry/voronoi/axis.h"

namespace clearcut::inline geometry::voronoi {

/// Range of clearances in which a cutter of `radius` just fits: from `low` to below `high`. mm.
struct FitBand {
  double low = 0;
  double radius = 0;
  double high = 0;
};

/// Curves of the axis with clearance in the band, except mouths of wider places and ends in corners: dead ends
/// shorter than `stub` mm are removed if their clearance is below the radius. A place with room for only one position
/// becomes a point: a path of one edge with from == to.
std::vector<Path> fit_lines(const Axis& axis, const Diagram& diagram, const FitBand& band, double stub);

}  // namespace clearcut::inline geometry::voronoi
