// A second reading of Grbl 1.1: which lines its parser takes, in its own 32-bit arithmetic. Written from its
// published error codes; shares nothing with the reader under test.
#pragma once

#include <string>
#include <vector>

namespace clearcut::test_support {

struct GrblFault {
  int line = 0;
  int error = 0;     ///< as Grbl numbers them: 20 unsupported command, 22 no feed, 33 arc radii, ...
  std::string text;  ///< the line
};

/// Feeds a program line by line; returns the lines that would be answered by an error. `has_mist`: it was built with ENABLE_M7.
std::vector<GrblFault> grbl_faults(const std::string& program, bool has_mist = false);

}  // namespace clearcut::test_support
