// The result file: the segments of a toolpath as plain numbers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/published_time.h"
#include "model/move.h"

namespace clearcut::report {

/// What a contour's smallest angle makes of the step to the next.
struct ContourCoefficient {
  double from_wall = 0;       ///< mm
  double smallest_angle = 0;  ///< radians
  double share = 0;           ///< kappa or rho: the step as a share of the diameter
  double residual = 0;        ///< mm, F of CPO-kappa eq. 4; below 0 the rings overlap
};

/// Where the contours of one feature run, mm from its walls, ascending.
struct ContourLevels {
  std::string feature;
  std::vector<double> from_wall;
  std::vector<ContourCoefficient> coefficients = {};  ///< of all but the innermost, where the method has them
};

struct ResultInfo {
  std::string name;  ///< of the part; one comment line
  std::vector<ContourLevels> contours;
  std::optional<kinematics::PublishedTime> published = {};  ///< CPO-rho eq. 9
};

/// Shape   comment lines start with '#': name, columns; distances of the contours and the steps between them, one
///         where all are equal; then for each section and layer a comment and its segments in order of cutting, "x_i y_i x_f y_f"; an arc adds "x_c y_c" and G02 (clockwise)
///         or G03; last the total length.
/// Units   mm, four decimals. Feed moves in plan only: rapids and vertical moves have no segment.
/// Source  [cpo_kappa] fig. 10: the total is contours plus the passages between them.
std::string result_file(const Toolpath& toolpath, const ResultInfo& info);

}  // namespace clearcut::report
