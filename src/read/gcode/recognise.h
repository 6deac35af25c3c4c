// What a text is, no program at all or a program for which control, by the words it uses, and the tools that the
// comments of posts name.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "read/gcode/program/dialect.h"

namespace clearcut::read::gcode {

/// Throws InputError where a text is unmistakably no program: it is empty, is a file of another kind, or no line of it begins as a
/// block does. The message says what it is and what to give instead. Cost O(n).
void refuse_what_is_no_program(std::string_view text, const std::string& file_name);

struct Recognised {
  Dialect dialect = Dialect::kLinuxCnc;
  bool is_certain = false;       ///< a word of it means nothing to any other control
  std::optional<Dialect> rival;  ///< whose words they all are as well, so that waits are compared, too
};

/// The likeliest; never Klartext. Text that is no G-code counts up to its first fault.
Recognised recognised(std::string_view text, const std::string& file_name);

/// A tool that a comment describes.
struct ToolComment {
  int number = 0;    ///< T word that it is for; 0: none
  std::string tool;  ///< as --tool takes it: "endmill:6:T1"
  int line = 0;
};

/// The tools that the comments of a program describe, the first comment of each number, in the order of their lines. Lengths without a
/// unit count in that of the program. Understood are the comments of the posts of Fusion, Mastercam, Vectric, FreeCAD, Estlcam, bCNC,
/// CamBam, jscut, pcb2gcode and Heidenhain's, and our own: a kind of tool or a word for its diameter, and a size. Cones and taps are left
/// out, whose shape takes more than that.
std::vector<ToolComment> tools_in_comments(std::string_view text);

/// The tools of which comments say that they are put in ("TOOL CHANGE T3: DRILL D4 MM"), in the order of their lines.
std::vector<int> tools_announced(std::string_view text);

}  // namespace clearcut::read::gcode
