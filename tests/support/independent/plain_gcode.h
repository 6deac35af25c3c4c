// A second reading of the programs that the LinuxCNC post writes: straight ways and arcs in the plane, absolute, in millimetres.
// Shares nothing with the reader under test.
#pragma once

#include <string>
#include <vector>

namespace clearcut::test_support {

/// A straight stretch of the tip's way, mm.
struct TipWay {
  int tool = 0;
  bool rapid = false;
  int line = 0;  ///< of the program, from 1
  double x0 = 0, y0 = 0, z0 = 0, x1 = 0, y1 = 0, z1 = 0;
};

/// All ways of a program; arcs as chords that leave them by at most `sagitta`, mm. Throws std::runtime_error for words that it does
/// not know.
std::vector<TipWay> ways_of(const std::string& program, double sagitta);

}  // namespace clearcut::test_support
