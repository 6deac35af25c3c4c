// The image of a Gerber file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "read/board/drawn.h"

namespace clearcut::read {

struct GerberImage {
  std::vector<Drawn> drawn;  ///< mm, in order
  std::string function;      ///< attribute FileFunction, "Copper,L1,Top"; "" if the file has none
};

/// Throws InputError "file:line: ..." for damaged or unknown commands, and for more than 2 million edges. Cost O(text
/// + edges drawn), repeated blocks counted each time. Source: Ucamco, The Gerber Layer Format Specification, revision
/// 2022.02; deprecated commands are read if their meaning is clear.
GerberImage gerber_image(std::string_view text, const std::string& file, const RepairOptions& repair);

}  // namespace clearcut::read
