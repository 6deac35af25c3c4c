// Whether a program is more than the blocks that stand in it.
#pragma once

#include <string_view>

namespace clearcut::read::gcode {

/// Line of the first parameter, expression, jump, loop or call of a subprogram in a word-address program; 0: it has none.
int first_macro_line(std::string_view text);

}  // namespace clearcut::read::gcode
