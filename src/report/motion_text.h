// The parts of a program's text that a control executes.
#pragma once

#include <string>
#include <string_view>

namespace clearcut::report {

/// `program` without comments, block numbers of Klartext, white space at the ends of lines, and empty lines: two
/// programs with the same motion text move a machine alike.
std::string motion_text(std::string_view program);

}  // namespace clearcut::report
