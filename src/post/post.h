// Writes a toolpath as a program for one controller.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/tolerances.h"
#include "model/part.h"
#include "model/move.h"

namespace clearcut::post {

struct PostOptions {
  std::string dialect = "linuxcnc";  ///< linuxcnc grbl fanuc haas heidenhain mach3 mach4 marlin
  bool inch = false;
  std::string program_name;             ///< "1234" or "O1234" gives Fanuc and Haas their program number
  std::vector<std::string> header;      ///< comment lines: part, stock, tools, times, certificate summary
  std::optional<int> decimals;          ///< 1 to 6; default per dialect and unit
  bool arcs = true;                     ///< false: lines only, within tol.chord
  bool tool_changer = true;             ///< false: a pause (M0) instead of M6
  bool length_offset = true;            ///< false: no G43
  bool exact_stop = false;              ///< G61 instead of blending, where the control knows it
  std::optional<Seconds> spindle_wait;  ///< after the spindle starts; default per dialect
  MmPerMin rapid = MmPerMin::of(3000);  ///< for controls whose G0 takes an F word (Marlin)
  Tolerances tol;
};

/// Names accepted as PostOptions::dialect.
const std::vector<std::string>& post_dialects();
/// Customary ending of a program's file name: ".ngc", ".nc", ".h", ".tap", ".gcode".
std::string file_extension_of(const std::string& dialect);

/// Largest distance in plan between a toolpath and the program written for it, mm: rounding to the printed
/// decimals. Arcs that have to become lines add tol.chord.
double rounding_of(const PostOptions& options);

/// The program's text: LF line ends, ASCII. Same input, same bytes.
///
/// Shape   one OPERATION comment per section; sections are joined over the safe height.
/// Error   rounding_of(options); arcs are checked after rounding, from the previous printed point.
/// Throws  InputError for an unknown dialect, a number that is not finite or beyond 1 km, a feed move without feed.
/// Cost    linear.
std::string post(const Toolpath& toolpath, const Part& part, const PostOptions& options);

}  // namespace clearcut::post
