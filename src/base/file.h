// Files read whole and written all or nothing: their names, the files behind links, and files within a project file. A
// project file is one JSON file with a part, the files named by the part, and the options of a plan. SHA-256, by OpenSSL.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace clearcut::inline base {

/// The bytes of a file. Throws InputError naming the path when it cannot be read or is larger than `limit`
/// bytes.
std::string read_file(const std::string& path, std::size_t limit = std::size_t{1} << 30);

/// One file to be written.
struct OutputFile {
  std::string path;
  std::string content;
};

/// Writes every file under a temporary name beside its target, then renames them all: either all targets are
/// new and complete, or (InputError) none has changed. Devices and pipes are written to directly and not replaced.
/// Links are followed. None of `inputs` (files that were read for these) is replaced. `interrupted` is asked until
/// the first target is replaced; once it returns true, nothing is written (InputError).
void write_files(const std::vector<OutputFile>& files, const std::vector<std::string>& inputs = {},
                 const std::function<bool()>& interrupted = {});

/// FNV-1a, 64 bit, as 16 hexadecimal digits: names an input, is no protection against intent.
std::string content_hash(const std::string& bytes);

/// The file that writing to `path` replaces: links are followed, whether or not a file exists at their end yet.
/// `path` itself if it is no link.
std::filesystem::path target_of(const std::string& path);

/// Whether both name one file, by links of either kind, other spellings of the path included. Devices are no files.
bool is_same_file(const std::string& a, const std::string& b);

/// Throws InputError if an output is one of `inputs` (files that were read for it), the same file as another output,
/// a folder, or in a folder that does not exist. Writes nothing.
void check_outputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs = {});

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

/// 64 hexadecimal digits, lower case.
std::string sha256_hex(std::string_view bytes);

}  // namespace clearcut::inline base
