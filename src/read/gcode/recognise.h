// Which control a program was written for, by the words it uses.
#pragma once

#include <string>
#include <string_view>

#include "read/gcode/dialect.h"

namespace clearcut::read::gcode {

/// The likeliest; never Klartext. Text that is no G-code counts up to its first fault.
Dialect recognised(std::string_view text, const std::string& file_name);

}  // namespace clearcut::read::gcode
