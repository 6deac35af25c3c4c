// Reads programs back: any CAM's G-code (RS274/NGC subset, Fanuc, Grbl, Mach, Marlin) and Heidenhain
// Klartext.
#pragma once

#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "model/machine.h"
#include "model/move.h"

namespace clearcut::read::gcode {

struct Program {
  Toolpath toolpath;
  Diagnostics diagnostics;  ///< words that were ignored or assumed, each with its line
  bool ended = false;       ///< an end word was seen
};

/// home_z: mm, height of the places that a program names without stating them: where it starts, the machine's own zero.
/// Throws InputError("file:line", ...) for text that no controller would take or that cannot be understood.
Program read_gcode(std::string_view text, const std::string& file_name, double home_z = kUsualHomeZ);

}  // namespace clearcut::read::gcode
