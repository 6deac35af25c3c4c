// Programs in Siemens' own language: parameters, jumps, loops, subprograms. Lines whose words are computed become plain ones.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "read/gcode/motion/builder.h"
#include "read/gcode/program/dialect.h"
#include "read/gcode/program/program.h"

namespace clearcut::read::gcode {

/// Who executes plain blocks.
struct SinumerikBlocks {
  /// A block without expressions; lines count from 1.
  std::function<void(std::string_view block, int line)> execute;
  /// An end word was seen.
  std::function<bool()> ended;
  /// That word ended a subprogram alone.
  std::function<void()> go_on;
  /// Whether the name is a word of the control's, and no subprogram's.
  std::function<bool(const std::string& name)> is_word;
};

/// Executes the program as the control does; whether it was ended by a word. Throws InputError("file:line", ...) for what the control would not
/// take, for what nothing states, and where the program does not end in a bounded number of lines.
bool run_sinumerik(std::string_view text, const std::string& file_name, const SinumerikBlocks& blocks,
                   const DialectRules& rules, const ReadControllerOptions& options, ToolpathBuilder& builder);

}  // namespace clearcut::read::gcode
