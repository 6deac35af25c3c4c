// Files read whole and written all or nothing.
#pragma once

#include <functional>
#include <string>
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

}  // namespace clearcut::inline base
