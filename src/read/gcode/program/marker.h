// Own comments in programs: what they tell the reader. Other comments say nothing.
#pragma once

#include <string_view>

#include "read/gcode/motion/builder.h"

namespace clearcut::read::gcode {

/// "OPERATION 3: POCKET1" and "OPERATION: POCKET1" begin a section of `builder` and name it, for the table of figures.
/// No comment says anything about motion, tools or the program's end.
void read_marker(std::string_view comment, ToolpathBuilder& builder);

}  // namespace clearcut::read::gcode
