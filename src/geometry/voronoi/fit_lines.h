// Where a cutter just fits: curves of the medial axis with clearance equal to its radius.
#pragma once

#include "geometry/voronoi/axis.h"

namespace clearcut::voronoi {

/// Curves of the axis with clearance in [low, high) that are more than the mouth of a wider place or the foot
/// of a corner: dead ends shorter than `stub` mm go. Where there is room for one place only, a point: a path of
/// one edge with from == to.
std::vector<Path> fit_lines(const Axis& axis, const Diagram& diagram, double low, double high, double stub);

}  // namespace clearcut::voronoi
