// Which control a program was written for, by the words it uses.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "read/gcode/program/dialect.h"

namespace clearcut::read::gcode {

struct Recognised {
  Dialect dialect = Dialect::kLinuxCnc;
  bool is_certain = false;       ///< a word of it means nothing to any other control
  std::optional<Dialect> rival;  ///< whose words they all are as well, so that waits are compared, too
};

/// The likeliest; never Klartext. Text that is no G-code counts up to its first fault.
Recognised recognised(std::string_view text, const std::string& file_name);

}  // namespace clearcut::read::gcode
