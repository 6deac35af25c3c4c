// The commands of a Gerber file, one after another.
#pragma once

#include <string>
#include <string_view>
#include <vector>

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

}  // namespace clearcut::read
