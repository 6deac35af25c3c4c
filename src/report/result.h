// The result file, the segments of a toolpath as plain numbers, and the parts of a program's text that a control
// executes.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kinematics/kinematics.h"
#include "model/move.h"
#include "model/results/contour_levels.h"
#include "model/results/published_time.h"

namespace clearcut::report {

struct ResultInfo {
  std::string name;  ///< name of the part; one comment line
  std::vector<ContourLevels> contours;
  std::optional<PublishedTime> published = {};  ///< CPO-rho eq. 9
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
