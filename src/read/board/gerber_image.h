// What a Gerber file draws.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "read/board/drawn.h"

namespace clearcut::read {

struct GerberImage {
  std::vector<Drawn> drawn;  ///< mm, in order
  std::string function;      ///< attribute FileFunction, "Copper,L1,Top"; "" where the file has none
};

/// Throws InputError "file:line: ..." for what is damaged or not understood, and for more than 2 million edges.
/// Cost O(text + edges drawn), repeated blocks counted each time.
/// Source: Ucamco, The Gerber Layer Format Specification, revision 2022.02; commands that it deprecates are read where their
/// meaning is plain.
GerberImage gerber_image(std::string_view text, const std::string& file, const RepairOptions& repair);

}  // namespace clearcut::read
