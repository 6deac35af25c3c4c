// Files with subprograms beside a program.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace clearcut::read::gcode {

/// The text of a file with that plain name, as the control finds it beside the program; nothing where there is none.
using SubprogramFiles = std::function<std::optional<std::string>(const std::string& name)>;

/// Those in the folder of the program at `program`. Names with a folder in them are not looked up.
SubprogramFiles files_beside(const std::string& program);

}  // namespace clearcut::read::gcode
