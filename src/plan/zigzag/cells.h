// Parallel lines clearing a region, grouped into cells of successive lines.
#pragma once

#include <vector>

#include "geometry/region.h"

namespace clearcut::plan::zigzag {

/// A line of the cutter's centre, left.x <= right.x; a single point if both are equal.
struct ZigzagLine {
  Vec2 left;
  Vec2 right;
};

/// Lines one above the other, upwards; neighbours overlap in x, with nothing between them.
struct ZigzagCell {
  std::vector<ZigzagLine> lines;
};

/// Lines along x clearing `rest`, in cells.
///
/// Method  `rest` is divided into horizontal strips of equal height, at most `widest_step` mm. The line in
///         the middle of a strip is as long as the part of `rest` in the strip, less the part cleared by the disc at
///         its end. So every point of the line is straight above or below a point of `rest`, at most a radius away:
///         if `rest` is everywhere a radius inside the legal area, all lines are legal.
/// Error   Lines are computed for a radius smaller by 1 um, so residuals stay below 1 um.
/// Cost    O(edges * crossed strips).
std::vector<ZigzagCell> zigzag_cells(const Region& rest, double radius, double widest_step);

}  // namespace clearcut::plan::zigzag
