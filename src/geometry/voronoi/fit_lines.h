// Where a cutter just fits: curves of the medial axis with clearance equal to its radius.
#pragma once

#include "geometry/voronoi/axis.h"

namespace clearcut::inline geometry::voronoi {

/// Clearances at which a cutter of `radius` just fits: from `low` to below `high`. mm.
struct FitBand {
  double low = 0;
  double radius = 0;
  double high = 0;
};

/// Curves of the axis with clearance in the band that are more than the mouth of a wider place or the foot
/// of a corner: dead ends shorter than `stub` mm go where the clearance is below the radius. Where there is room for
/// one place only, a point: a path of one edge with from == to.
std::vector<Path> fit_lines(const Axis& axis, const Diagram& diagram, const FitBand& band, double stub);

}  // namespace clearcut::inline geometry::voronoi
