// Heidenhain conversational programs.
#pragma once

#include <string_view>

#include "read/gcode/motion/builder.h"
#include "read/gcode/motion/compensation_values.h"

namespace clearcut::read::gcode {

/// Returns whether END PGM or M30 was seen. Throws InputError for blocks that would move the tool in ways
/// that are not understood.
bool read_klartext(std::string_view text, const CompensationValues& compensation, ToolpathBuilder& builder);

}  // namespace clearcut::read::gcode
