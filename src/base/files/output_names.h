// Names of output files: the files behind links, and names that are refused.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace clearcut::inline base {

/// The file that writing to `path` replaces: links are followed, whether or not a file exists at their end yet.
/// `path` itself if it is no link.
std::filesystem::path target_of(const std::string& path);

/// Whether both name one file, by links of either kind, other spellings of the path included. Devices are no files.
bool is_same_file(const std::string& a, const std::string& b);

/// Throws InputError if an output is one of `inputs` (files that were read for it), the same file as another output,
/// a folder, or in a folder that does not exist. Writes nothing.
void check_outputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs = {});

}  // namespace clearcut::inline base
