// Names of files to be written: where they lead, and which must not be given.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace clearcut::inline base {

/// What writing to `path` replaces: links are followed, whether or not there is a file at their end yet. `path` where it is no
/// link.
std::filesystem::path target_of(const std::string& path);

/// Whether both name one file, by links of either kind, other spellings of the path included. Devices are no files.
bool is_same_file(const std::string& a, const std::string& b);

/// Throws InputError where an output is one of `inputs` (files that were read for it), the same file as another output, a
/// folder, or in a folder that does not exist. Writes nothing.
void check_outputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs = {});

}  // namespace clearcut::inline base
