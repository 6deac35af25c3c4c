// For tests: solids of blocks side by side, as STEP text, so that every floor and wall is known by construction.
#pragma once

#include <string>
#include <vector>

namespace clearcut::test_support {

struct SteppedSolid {
  std::vector<double> x, y;  ///< mm; the lines between blocks, ascending
  std::vector<std::vector<double>>
      heights;  ///< mm; heights[j][i] between x[i], x[i+1] and y[j], y[j+1]; at `bottom` there is no block
  double bottom = 0;  ///< mm
};

/// AP214; every block has a top, a bottom, and walls down to its lower neighbours.
std::string step_text(const SteppedSolid& solid);

/// A block from the origin with its four upper edges broken by `chamfer` mm at 45 degrees.
std::string broken_block_text(double width, double depth, double height, double chamfer);

/// A block of 30 x 20 x 10 mm with two steps at its right, z 2 and z 6: the wall at x 10 is one face, whose foot is at both heights.
std::string stepped_foot_text();

}  // namespace clearcut::test_support
