// Parallel lines that clear a region, and the cells in which they follow each other. Used by the planner alone.
#pragma once

#include <vector>

#include "geometry/region.h"

namespace clearcut::plan::zigzag {

/// A line of the cutter's centre from left to right, x.from <= x.to, or a single place.
struct ZigzagLine {
  Vec2 left;
  Vec2 right;
};

/// Lines one above the other, upwards; neighbours overlap, and nothing lies between them.
struct ZigzagCell {
  std::vector<ZigzagLine> lines;
};

/// Lines along x that clear `rest`, in cells.
///
/// Method  `rest` is cut into horizontal strips of equal height, at most `widest_step`. The line in the middle of a
///         strip runs as far as the strip's part of `rest` reaches, less what the disc at its end clears. So every
///         place of the line lies right above or below a point of `rest`, at most a radius away: where `rest` keeps a
///         radius from the boundary of the legal area, all lines are legal.
/// Error   `radius` is taken 1 um less, so residuals stay below that.
/// Cost    O(edges * strips they cross).
std::vector<ZigzagCell> zigzag_cells(const Region& rest, double radius, double widest_step);

}  // namespace clearcut::plan::zigzag
