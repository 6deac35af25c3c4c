// Files that must not be overwritten: what was read for an output, and other outputs.
#pragma once

#include <string>
#include <vector>

namespace clearcut::inline base {

/// While one lives, everything that read_file reads is remembered, and write_files refuses to replace any of it. One at a
/// time: of a command that reads, then writes, then ends.
class InputGuard {
 public:
  InputGuard();
  ~InputGuard();
  InputGuard(const InputGuard&) = delete;
  InputGuard& operator=(const InputGuard&) = delete;
};

/// Remembers an input while an InputGuard lives.
void remember_input(const std::string& path);

/// Takes back that a file is an input: one that is read to be continued.
void forget_input(const std::string& path);

/// Whether both name one file, by links of either kind, other spellings of the path included. Devices are no files.
bool is_same_file(const std::string& a, const std::string& b);

/// Throws InputError where an output is an input (of the guard), the same file as another output, a folder, or in a folder that
/// does not exist. Writes nothing.
void check_outputs(const std::vector<std::string>& outputs);

}  // namespace clearcut::inline base
