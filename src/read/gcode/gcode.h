// Reads programs back: any CAM's G-code (RS274/NGC subset, Fanuc, Grbl, Mach, Marlin) and Heidenhain
// Klartext.
#pragma once

#include <string>
#include <string_view>

#include "read/gcode/program/program.h"

namespace clearcut::read::gcode {

/// Comments name sections for the table of figures and change nothing else. Where the dialect is not stated and the
/// words mean different motion to two controllers that might be meant, that is the condition "dialect".
/// Throws InputError("file:line", ...) for text that the controller would not take or that cannot be understood.
Program read_gcode(std::string_view text, const std::string& file_name, const ReadControllerOptions& options);
Program read_gcode(std::string_view text, const std::string& file_name, double home_z = kUsualHomeZ);

}  // namespace clearcut::read::gcode
