// Places of rectangles of one size on a rectangular sheet, some of them turned by 90 degrees.
#pragma once

#include <vector>

#include "geometry/vec2.h"

namespace clearcut::pipeline {

/// Where the lower left corner of one lies, mm from that of the sheet.
struct NestPlace {
  Vec2 at;
  bool turned = false;
};

/// Lengths in mm.
struct NestQuestion {
  double width = 0, height = 0;            ///< of the sheet
  double edge = 0;                         ///< of the sheet, that stays free
  double gap = 0;                          ///< between two rectangles
  double part_width = 0, part_height = 0;  ///< of the rectangle, as it is not turned
};

/// The best of all layouts of two blocks: columns (or rows) of one orientation, and the rest of the sheet filled with the other. Rows from
/// below, there and back.
///
/// Bound   most_by_area() of the same question: no layout of whatever kind has more.
/// Cost    O(columns + rows) layouts, each by arithmetic alone.
std::vector<NestPlace> nest(const NestQuestion& question);
int most_by_area(const NestQuestion& question);

}  // namespace clearcut::pipeline
