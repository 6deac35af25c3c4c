// The result file (SPEC C7): the segments of a toolpath as plain numbers.
#pragma once

#include <string>
#include <vector>

#include "model/move.h"

namespace clearcut::report {

/// Where the contours of one feature run, mm from its walls, ascending.
struct ContourLevels {
  std::string feature;
  std::vector<double> from_wall;
};

struct ResultInfo {
  std::string name;  ///< of the part; one comment line
  std::vector<ContourLevels> contours;
};

/// Shape   comment lines start with '#': name, columns; distances of the contours and the steps between them, one
///         where all are equal; then for each section and layer a comment and its segments in order of cutting, "x_i y_i x_f y_f"; an arc adds "x_c y_c" and G02 (clockwise)
///         or G03; last the total length.
/// Units   mm, four decimals. Feed moves in plan only: rapids and vertical moves have no segment.
/// Source  [cpo_kappa] fig. 10: the total is contours plus the passages between them.
std::string result_file(const Toolpath& toolpath, const ResultInfo& info);

}  // namespace clearcut::report
