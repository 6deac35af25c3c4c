// Distances of contours from the walls, and the coefficients that published methods derive them from.
#pragma once

#include <string>
#include <vector>

namespace clearcut::inline model {

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

}  // namespace clearcut::inline model
