// Project files: what the page keeps of a part in one JSON file, <name>.clearcut.json; see docs/input.md.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "options/job_file.h"

namespace clearcut::read {

/// Whether the name is that of a project file.
bool is_project_name(const std::string& path);

/// Throws InputError where it is none, names an option that is none, or a part that it does not hold.
ProjectFile read_project(const std::string& path);

}  // namespace clearcut::read
