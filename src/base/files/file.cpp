#include "base/files/file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "base/error.h"
#include "base/files/output_names.h"
#include "base/files/project_entry.h"

namespace clearcut::inline base {
namespace {

namespace fs = std::filesystem;

/// Names of streams that are already open, for any files they refer to.
bool is_open_stream(const std::string& path) {
  return path == "/dev/stdout" || path == "/dev/stderr" || path.starts_with("/dev/fd/") ||
         path.starts_with("/proc/");
}

/// A device or pipe (/dev/null): it is written to, never replaced by a file.
bool is_special(const OutputFile& file) {
  if (is_open_stream(file.path)) return true;
  std::error_code ignored;
  const auto status = fs::status(file.path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

bool is_replaced(const OutputFile& file) {
  return !is_special(file);
}

void write_special(const OutputFile& file) {
  std::ofstream out(file.path, std::ios::binary);
  out.write(file.content.data(), static_cast<std::streamsize>(file.content.size()));
  out.close();
  if (!out) throw InputError(file.path, "cannot be written; check that it has room");
}

std::string temporary_name(const std::string& path) {
  return fmt::format("{}.{}.tmp", target_of(path).string(), ::getpid());
}

void write_temporary(const OutputFile& file) {
  const fs::path target(file.path);
  if (fs::is_directory(target)) throw InputError(file.path, "is a folder, name a file");
  std::ofstream out(temporary_name(file.path), std::ios::binary | std::ios::trunc);
  out.write(file.content.data(), static_cast<std::streamsize>(file.content.size()));
  out.close();
  if (!out) throw InputError(file.path, "cannot be written; check that the folder exists and has room");
}

void remove_temporaries(const std::vector<OutputFile>& files) {
  for (const auto& file : files) {
    std::error_code ignored;
    if (is_replaced(file)) fs::remove(temporary_name(file.path), ignored);
  }
}

void give_up_if(const std::function<bool()>& interrupted) {
  if (interrupted && interrupted()) throw InputError("", "interrupted; nothing was written");
}

}  // namespace

std::string read_file(const std::string& path, std::size_t limit) {
  if (const auto within = project_path(path)) return read_project_entry(*within);
  std::error_code error;
  const auto status = fs::status(path, error);
  if (!fs::exists(status)) throw InputError(path, "no such file; check the name");
  if (fs::is_directory(status)) throw InputError(path, "is a folder, name a file");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError(path, "cannot be opened; check its permissions");
  std::string bytes;
  char buffer[1 << 16];
  while (in.read(buffer, sizeof buffer) || in.gcount() > 0) {
    bytes.append(buffer, static_cast<std::size_t>(in.gcount()));
    if (bytes.size() > limit)
      throw InputError(path, fmt::format("is larger than {} bytes, too large to read", limit));
  }
  if (in.bad()) throw InputError(path, "cannot be read to its end");
  return bytes;
}

void write_files(const std::vector<OutputFile>& files, const std::vector<std::string>& inputs,
                 const std::function<bool()>& interrupted) {
  std::vector<std::string> names;
  for (const auto& file : files) names.push_back(file.path);
  check_outputs(names, inputs);
  try {
    for (const auto& file : files) {
      give_up_if(interrupted);
      if (is_replaced(file)) write_temporary(file);
    }
    give_up_if(interrupted);
    for (const auto& file : files) {
      if (is_special(file)) write_special(file);
    }
    for (const auto& file : files) {
      if (is_replaced(file)) fs::rename(temporary_name(file.path), target_of(file.path));
    }
  } catch (const fs::filesystem_error& error) {
    remove_temporaries(files);
    throw InputError(error.path2().string(), "cannot be written: " + error.code().message());
  } catch (...) {
    remove_temporaries(files);
    throw;
  }
}

std::string content_hash(const std::string& bytes) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char byte : bytes) {
    hash ^= static_cast<unsigned char>(byte);
    hash *= 0x100000001b3ULL;
  }
  return fmt::format("{:016x}", hash);
}

}  // namespace clearcut::inline base
