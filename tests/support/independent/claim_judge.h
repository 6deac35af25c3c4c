// A second opinion on the claims of docs/claim.md: sampled points, floating-point numbers, and no code of the checker's.
#pragma once

#include <map>
#include <string>

#include "model/part.h"

namespace clearcut::test_support {

/// mm by which a program breaks its claims, at most 0 where no sample breaks them.
struct ClaimFaults {
  double uncut = -1;  ///< beyond the cutter's reach, at a place that the cutter can reach
  double gouge = -1;  ///< into walls and floors
  double rapid = -1;  ///< of rapids into material, from the cutter's rim
  double rapid_off_height =
      -1;  ///< the same if the control keeps heights within a tolerance: rapids lower, feeds higher
};

/// Judges a program of the LinuxCNC post for the first feature of a part, cut by one flat cutter, with a stock as high as the feature.
/// `off_height` in mm: how far the control may leave the heights of the program.
ClaimFaults judged(const Part& part, const std::string& program, double diameter, double off_height = 0);

/// Greatest engagement in degrees of each level feed below the top, by its line, sampled `spacing` mm and `degrees` apart. The rim is
/// looked at `rim` mm within the cutter.
std::map<int, double> sampled_engagement(const Part& part, const std::string& program, double diameter,
                                         double rim, double spacing, double degrees);

}  // namespace clearcut::test_support
