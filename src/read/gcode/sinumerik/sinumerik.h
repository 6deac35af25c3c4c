// Programs of Siemens Sinumerik 840D and its like, in their own language (G290).
#pragma once

#include <string_view>

#include "read/gcode/motion/builder.h"
#include "read/gcode/program/dialect.h"
#include "read/gcode/program/program.h"

namespace clearcut::read::gcode {

/// Returns whether an end word (M2, M17, M30, RET) was seen. Throws InputError for blocks that would move the tool in ways that are not
/// understood.
bool read_sinumerik(std::string_view text, const DialectRules& rules, const ReadControllerOptions& options,
                    ToolpathBuilder& builder);

}  // namespace clearcut::read::gcode
