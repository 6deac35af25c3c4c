// Programs of LinuxCNC with parameters, expressions, subroutines and loops.
#pragma once

#include <string>
#include <string_view>

#include "read/gcode/macros/macro_run.h"

namespace clearcut::read::gcode {

/// Executes the program as the control does; whether an end word was seen. Throws InputError("file:line", ...) for what the control would not take, for
/// what nothing states, and where the program does not end in a bounded number of lines.
bool run_linuxcnc(std::string_view text, const std::string& file_name, Interpreter& interpreter,
                  ToolpathBuilder& builder, const DialectRules& rules, const ReadControllerOptions& options);

}  // namespace clearcut::read::gcode
