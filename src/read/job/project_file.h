// Project files: what the page keeps of a part in one JSON file, <name>.clearcut.json; see docs/input.md.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace clearcut::read {

/// What is asked in a project file. The files themselves are read by their paths within it: "a.clearcut.json/plate.dxf".
struct ProjectFile {
  std::string file;
  std::string input;  ///< path of the part or job within the project file
  /// Values of options by the names of their rows; a flag has none. Names of files within the project file are paths to them.
  std::map<std::string, std::vector<std::string>> options;
};

/// Whether the name is that of a project file.
bool is_project_name(const std::string& path);

/// Throws InputError where it is none, names an option that is none, or a part that it does not hold.
ProjectFile read_project(const std::string& path);

}  // namespace clearcut::read
