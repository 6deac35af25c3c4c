// Files within a project file: one JSON file that holds a part, the files that it names, and what is asked of it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace clearcut::inline base {

/// What the name of a project file ends in.
inline constexpr std::string_view kProjectEnding = ".clearcut.json";

/// "a.clearcut.json/plate.dxf" taken apart.
struct ProjectPath {
  std::string project;  ///< "a.clearcut.json"
  std::string entry;    ///< "plate.dxf"
};

/// Nothing for a path that leads into no project file.
std::optional<ProjectPath> project_path(const std::string& path);

/// The bytes of a file within a project file: its "text", or its "base64". Throws InputError where the project file is
/// none, or holds no such file.
std::string read_project_entry(const ProjectPath& path);

/// Whether there is a file at that path, on disk or within a project file.
bool is_file(const std::filesystem::path& path);

}  // namespace clearcut::inline base
