// Programs of Siemens Sinumerik 840D and its like, in their own language (G290).
#pragma once

#include <string>
#include <string_view>

#include "read/gcode/control/held_state.h"
#include "read/gcode/motion/builder.h"
#include "read/gcode/program/dialect.h"
#include "read/gcode/program/program.h"

namespace clearcut::read::gcode {

/// How far a program is understood: as plain blocks, or with all that the language computes.
enum class SinumerikDepth : unsigned char { kPlain, kLanguage };

/// At which lines a program can be begun anew, and what the control holds before `line`, as scan_stops() says of other languages.
StopScan scan_sinumerik_stops(std::string_view text, const std::string& file_name,
                              const ReadControllerOptions& options, int line);

/// Returns whether an end word (M2, M17, M30, RET) was seen. Throws InputError for blocks that would move the tool in ways that are not
/// understood, and MacroError for what only kLanguage understands.
bool read_sinumerik(std::string_view text, const std::string& file_name, SinumerikDepth depth,
                    const DialectRules& rules, const ReadControllerOptions& options,
                    ToolpathBuilder& builder);

}  // namespace clearcut::read::gcode
