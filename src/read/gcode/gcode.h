// Reads programs back: any CAM's G-code (RS274/NGC subset, Fanuc, Grbl, Mach, Marlin) and Heidenhain
// Klartext.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "model/control.h"
#include "model/machine.h"
#include "model/move.h"
#include "read/gcode/compensation/values.h"
#include "read/gcode/dialect.h"
#include "read/gcode/macros/subprogram_files.h"

namespace clearcut::read::gcode {

using clearcut::MachinePlaces;

struct ReadControllerOptions {
  std::optional<Dialect> dialect;  ///< absent: recognised from the words used
  double home_z = kUsualHomeZ;     ///< mm, height of places that a program names without stating them
  double safe_z = 0;               ///< mm, nothing stands above it
  std::optional<MachinePlaces> places;
  /// Numbers of the tools that are put in by hand, at the start and at each pause, for programs without T words.
  std::vector<int> hand_tools;
  /// What D words and tables of tools hold where a program has its control compensate.
  CompensationValues compensation;
  /// Files with subprograms that the program calls; empty: none.
  SubprogramFiles subprograms;
  /// Lines that a program with macros may execute: a loop that never ends stops there.
  long long most_lines = 2'000'000;
};

struct Program {
  Toolpath toolpath;
  ControlTable
      control;  ///< tool length, spindle, path control at each move; dwells and tool changes between them
  Diagnostics
      diagnostics;  ///< words that were ignored or assumed without moving anything, each with its line
  std::vector<Condition>
      conditions;  ///< what must hold at the machine for `toolpath` to be what it does; one a name
  std::vector<int> compensated_tools;    ///< T words while the control compensates, ascending
  Dialect dialect = Dialect::kLinuxCnc;  ///< as which it was read
  bool dialect_stated = false;           ///< by the options; else recognised
  bool ended = false;                    ///< an end word was seen; Marlin has none and ends with the text
};

/// Comments name sections for the table of figures and change nothing else. Where the dialect is not stated and the
/// words mean different motion to two controllers that might be meant, that is the condition "dialect".
/// Throws InputError("file:line", ...) for text that the controller would not take or that cannot be understood.
Program read_gcode(std::string_view text, const std::string& file_name, const ReadControllerOptions& options);
Program read_gcode(std::string_view text, const std::string& file_name, double home_z = kUsualHomeZ);

}  // namespace clearcut::read::gcode
