// Gerber layers of circuit boards: the commands of a file one after another, its image, and the part; see
// docs/input.md.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/part.h"
#include "options/read_options.h"
#include "read/board/drawn.h"

namespace clearcut::read {

/// A word command ("X100Y50D01"), or an extended one ("ADD10C,0.2"), without its delimiters: *, %, ends of lines.
struct GerberCommand {
  std::string text;
  std::vector<std::string> blocks;  ///< of a macro: the blocks after its name
  bool extended = false;
  int line = 0;
};

/// Throws InputError "file:line: ..." if an extended command does not end. Cost O(text).
/// Source: Ucamco, The Gerber Layer Format Specification, revision 2022.02, section 3.
std::vector<GerberCommand> gerber_commands(std::string_view text, const std::string& file);

struct GerberImage {
  std::vector<Drawn> drawn;  ///< mm, in order
  std::string function;      ///< attribute FileFunction, "Copper,L1,Top"; "" if the file has none
};

/// Throws InputError "file:line: ..." for damaged or unknown commands, and for more than 2 million edges. Cost O(text
/// + edges drawn), repeated blocks counted each time. Source: Ucamco, The Gerber Layer Format Specification, revision
/// 2022.02; deprecated commands are read if their meaning is clear.
GerberImage gerber_image(std::string_view text, const std::string& file, const RepairOptions& repair);

/// Reads one layer: copper is isolated (a band around every piece is milled, so that the piece remains and is
/// separated from the rest), the board's profile is cut out, drill files in Gerber's format are holes, and for other
/// layers the drawn areas are milled; rules override this. The purpose of a layer is given by its attribute
/// FileFunction, else by the name of the file.
///
/// Error   lines and arcs exact; mirrored or unevenly scaled blocks within kCurveTolerance.
/// Throws  InputError "file:line: ..." for damaged files, and if the layer's purpose is unknown and
///         options.ask_if_unclear.
Part read_gerber(std::string_view text, const std::string& file_name, const ReadOptions& options);

}  // namespace clearcut::read
