// A program as it was read, and how it is to be read, with files of subprograms beside it and own comments in it that
// tell the reader something.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "model/control.h"
#include "model/machine.h"
#include "model/move.h"
#include "model/program.h"
#include "read/gcode/motion/builder.h"
#include "read/gcode/motion/compensation.h"
#include "read/gcode/program/dialect.h"

namespace clearcut::read::gcode {

/// The text of a file with that plain name, as the control finds it beside the program; nothing where there is none.
using SubprogramFiles = std::function<std::optional<std::string>(const std::string& name)>;

/// Those in the folder of the program at `program`. Names with a folder in them are not looked up.
SubprogramFiles files_beside(const std::string& program);

/// "OPERATION 3: POCKET1" and "OPERATION: POCKET1" begin a section of `builder` and name it, for the table of figures.
/// No comment says anything about motion, tools or the program's end.
void read_marker(std::string_view comment, ToolpathBuilder& builder);

using clearcut::MachinePlaces;

struct ReadControllerOptions {
  std::optional<Dialect> dialect;  ///< absent: recognised from the words used
  double home_z = kUsualHomeZ;     ///< mm, height of places that a program names without stating them
  double safe_z = 0;               ///< mm, nothing stands above it
  std::optional<MachinePlaces> places;
  /// Numbers of the tools that are put in by hand, at the start and at each pause, for programs without T words.
  std::vector<int> hand_tools;
  /// Values of D words and tool tables for programs with cutter compensation.
  CompensationValues compensation;
  /// Files with subprograms that the program calls; empty: none.
  SubprogramFiles subprograms;
  /// Lines that a program with macros may execute: a loop that never ends stops there.
  long long most_lines = 2'000'000;
};

}  // namespace clearcut::read::gcode
