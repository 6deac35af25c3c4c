// Files that are dropped in a program's place.
#pragma once

#include <string>
#include <string_view>

namespace clearcut::read::gcode {

/// Throws InputError where a text is unmistakably no program: it is empty, is a file of another kind, or no line of it begins as a
/// block does. The message says what it is and what to give instead. Cost O(n).
void refuse_what_is_no_program(std::string_view text, const std::string& file_name);

}  // namespace clearcut::read::gcode
