// Waits; those that nobody means become the condition `dwell`.
#pragma once

#include "read/gcode/motion/builder.h"

namespace clearcut::read::gcode {

/// A wait between moves, of which so many are written: seconds, or milliseconds.
void add_dwell(ToolpathBuilder& builder, int line, double written, bool in_ms);

/// A wait at the bottom of a hole.
void add_dwell_in_hole(ToolpathBuilder& builder, int line, double seconds);

}  // namespace clearcut::read::gcode
