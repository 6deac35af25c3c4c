// Reads programs that lay a line: of an extruder, whose moves feed filament (E), or of a laser, whose moves have a power (S).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/units.h"
#include "geometry/edge.h"
#include "model/results/laid_findings.h"

namespace clearcut::read::gcode {

/// A straight move in one layer. mm.
struct LaidMove {
  Edge path;
  double z = 0;
  MmPerMin feed;
  bool lays = false;
  double word = 0;  ///< E of the move, or the S in force; 0 while travelling
  int line = 0;     ///< of the text
};

struct LayingProgram {
  LayingWord word = LayingWord::kExtruded;
  std::vector<LaidMove> moves;  ///< in plan, from the first place on
};

/// Understands G0, G1, G17, G21, G90, G94, M2, M3, M4, M5, M30, M83 and F, S, X, Y, Z, E: the words of a layer and no others. A move
/// lays where it is a G1 with E above 0, or a G1 under M3 or M4 with S above 0. Throws InputError("file:line", ...) for every other
/// word, for E together with M3 or M4, and for a move that lays and changes its height.
LayingProgram read_laying(std::string_view text, const std::string& file_name);

}  // namespace clearcut::read::gcode
