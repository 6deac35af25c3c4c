// Own comments in programs: what they tell the reader. Other comments say nothing.
#pragma once

#include <string_view>

#include "read/gcode/builder.h"

namespace clearcut::read::gcode {

enum class Marker { kNone, kSection, kTool, kEnd };

/// "OPERATION 3: POCKET1" and "OPERATION: POCKET1" begin a section of `builder`; "TOOL CHANGE T2: ..." sets
/// `tool`, for controls without a T word; "END OF PROGRAM" ends one without an end word.
Marker read_marker(std::string_view comment, ToolpathBuilder& builder, int& tool);

}  // namespace clearcut::read::gcode
