// The result file, the segments of a toolpath as plain numbers, and the parts of a program's text that a control
// executes.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kinematics/kinematics.h"
#include "model/move.h"

namespace clearcut::report {

/// Step to the next contour, given by a contour's smallest angle.
struct ContourCoefficient {
  double from_wall = 0;       ///< mm
  double smallest_angle = 0;  ///< radians
  double share = 0;           ///< kappa or rho: the step as a share of the diameter
  double residual = 0;        ///< mm, F of CPO-kappa eq. 4; below 0 the rings overlap
};

/// Distances of the contours of one feature from its walls, mm, ascending.
struct ContourLevels {
  std::string feature;
  std::vector<double> from_wall;
  /// Coefficients of all but the innermost contour, if the method has any.
  std::vector<ContourCoefficient> coefficients = {};
};

struct ResultInfo {
  std::string name;  ///< name of the part; one comment line
  std::vector<ContourLevels> contours;
  std::optional<kinematics::PublishedTime> published = {};  ///< CPO-rho eq. 9
};

/// Shape   comment lines start with '#': name, columns; distances of the contours and the steps between them, only
///         one step if all are equal; then for each section and layer a comment and its segments in order of cutting,
///         "x_i y_i x_f y_f"; an arc adds "x_c y_c" and G02 (clockwise) or G03; last the total length.
/// Units   mm, four decimals. Feed moves in plan only: rapids and vertical moves have no segment.
/// Source  [cpo_kappa] fig. 10: the total is contours plus the passages between them.
std::string result_file(const Toolpath& toolpath, const ResultInfo& info);

/// `program` without comments, block numbers of Klartext, white space at the ends of lines, and empty lines: two
/// programs with the same motion text move a machine alike.
std::string motion_text(std::string_view program);

}  // namespace clearcut::report
