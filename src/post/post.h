// Writes a toolpath as a program for one controller.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/tolerances.h"
#include "toolpath/machine.h"
#include "part/part.h"
#include "toolpath/move.h"

namespace clearcut {

struct PostOptions {
  std::string dialect = "linuxcnc";  ///< linuxcnc grbl fanuc haas heidenhain mach3 mach4 marlin
  bool inch = false;
  std::string program_name;
  std::vector<std::string> header;  ///< comment lines: part, stock, tools, times, certificate summary
  std::optional<int> decimals;      ///< default per dialect and unit
  bool arcs = true;                 ///< false: lines only, within tol.chord
  Tolerances tol;
};

/// Names accepted as PostOptions::dialect.
const std::vector<std::string>& post_dialects();

/// Throws InputError for an unknown dialect, or a number that is not finite.
std::string post(const Toolpath& toolpath, const Part& part, const PostOptions& options);

}  // namespace clearcut
