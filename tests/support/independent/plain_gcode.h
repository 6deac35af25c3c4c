// A second reading of the programs that the LinuxCNC post writes: straight ways, arcs in the plane and drilling cycles, absolute, in
// millimetres. Shares nothing with the reader under test.
#pragma once

#include <string>
#include <vector>

namespace clearcut::test_support {

/// A straight stretch of the tip's way, mm.
struct TipWay {
  int tool = 0;  ///< in the spindle; 0: none
  bool rapid = false;
  int line = 0;             ///< of the program, from 1
  int turning = 0;          ///< of the spindle: 1 by M3, -1 by M4; 0: it stands
  bool has_length = false;  ///< whether a length was set since the tool came into the spindle
  double per_turn = 0;      ///< of a tap, mm: positive where it turns right on its way down; 0: no tapping
  double x0 = 0, y0 = 0, z0 = 0, x1 = 0, y1 = 0, z1 = 0;
  bool operator==(const TipWay&) const = default;
};

/// All ways of a program; arcs as chords that leave them by at most `sagitta`, mm. Throws std::runtime_error for words that it does
/// not know.
std::vector<TipWay> ways_of(const std::string& program, double sagitta);

}  // namespace clearcut::test_support
