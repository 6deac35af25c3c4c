// Tools as the comments of posts name them: nobody's word for what cuts, but what to ask for.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace clearcut::read::gcode {

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
