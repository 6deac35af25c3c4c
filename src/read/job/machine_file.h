// Machine files: what the machine can do.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "model/machine.h"
#include "read/common/data_value.h"

namespace clearcut::read {

/// TOML with name, rapid (mm/min), acceleration (mm/s2), junction_deviation (mm), max_spindle (rpm),
/// max_feed (mm/min), spindle_wait (s), tool_change (s), path_tolerance (mm), travel = {x = [low, high], y = ..., z = ...}
/// (mm) and places = {start, g28, g30, g54 ... g59 = [x, y, z]} (mm, the machine's own); all may be left out. Throws
/// InputError "file:line: ...".
Machine read_machine(const std::filesystem::path& file);
Machine read_machine_text(std::string_view text, const std::string& file_name);
/// The same keys as a table of a job. `base` gives what is left out.
Machine machine_of_section(DataSection section, Machine base);

}  // namespace clearcut::read
