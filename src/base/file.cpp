#include "base/file.h"

#include <fmt/format.h>
#include <openssl/evp.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.h"

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
  std::ofstream out(fs::path(file.path), std::ios::binary);
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
  std::ofstream out(fs::path(temporary_name(file.path)), std::ios::binary | std::ios::trunc);
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
  std::ifstream in(fs::path(path), std::ios::binary);
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

namespace {

namespace fs = std::filesystem;

bool is_standard_output(const std::string& path) {
  return path == "-" || path == "/dev/stdout" || path == "/dev/fd/1" || path == "/proc/self/fd/1";
}

/// A device or pipe: writing to it replaces no file.
bool is_device(const std::string& path) {
  std::error_code ignored;
  const auto status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

void refuse_inputs(const std::string& output, const std::vector<std::string>& inputs) {
  if (is_standard_output(output)) return;
  for (const std::string& input : inputs) {
    if (!is_same_file(input, output)) continue;
    const std::string name = input == output ? "an input" : "the input " + input;
    throw InputError(output, "is " + name + " and would be overwritten; name another file to write");
  }
}

void refuse_bad_folder(const std::string& output) {
  if (is_standard_output(output) || is_device(output)) return;
  std::error_code ignored;
  if (output.empty()) throw InputError("output", "has no name; name the file to write");
  if (fs::is_directory(output, ignored)) throw InputError(output, "is a folder, name a file");
  const fs::path folder = fs::path(output).parent_path();
  if (!folder.empty() && !fs::is_directory(folder, ignored))
    throw InputError(output, "cannot be written; check that the folder exists and has room");
}

/// One spelling for all paths to a file.
fs::path canonical_target(const std::string& path) {
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(target_of(path), ignored), ignored);
}

}  // namespace

fs::path target_of(const std::string& path) {
  constexpr int kMostLinks = 40;
  std::error_code ignored;
  fs::path place = path;
  for (int links = 0; links < kMostLinks && fs::is_symlink(place, ignored); ++links)
    place = place.parent_path() / fs::read_symlink(place, ignored);
  return place;
}

bool is_same_file(const std::string& a, const std::string& b) {
  if (is_standard_output(a) || is_standard_output(b)) return is_standard_output(a) && is_standard_output(b);
  if (is_device(a) || is_device(b)) return false;
  std::error_code error;
  if (fs::equivalent(a, b, error) && !error) return true;
  return canonical_target(a) == canonical_target(b);
}

void check_outputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    refuse_bad_folder(outputs[i]);
    refuse_inputs(outputs[i], inputs);
    for (std::size_t k = 0; k < i; ++k) {
      if (is_same_file(outputs[i], outputs[k]))
        throw InputError(outputs[i], "is named for two outputs; give each a file of its own");
    }
  }
}

namespace {

using Json = nlohmann::json;

/// The value of each character of base64; -1 for all others.
constexpr std::array<int, 256> values_of_base64() {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<int, 256> values{};
  values.fill(-1);
  for (std::size_t i = 0; i < kDigits.size(); ++i)
    values[static_cast<unsigned char>(kDigits[i])] = static_cast<int>(i);
  return values;
}

/// The bytes that base64 stands for (RFC 4648); nothing for other text.
std::optional<std::string> decoded_base64(std::string_view text) {
  static constexpr auto kValues = values_of_base64();
  if (text.size() % 4 != 0) return std::nullopt;
  std::size_t padding = 0;
  while (padding < 2 && text.ends_with('=')) text.remove_suffix(1), ++padding;
  std::string bytes;
  unsigned held = 0;
  int bits = 0;
  for (const char c : text) {
    const int value = kValues[static_cast<unsigned char>(c)];
    if (value < 0) return std::nullopt;
    held = (held << 6 | static_cast<unsigned>(value)) & 0xfff;
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes.push_back(static_cast<char>(held >> bits & 0xff));
  }
  return bytes;
}

/// Its entry of that name; null where it has none.
Json entry_of(const ProjectPath& path) {
  const Json project = Json::parse(read_file(path.project), nullptr, false);
  if (!project.is_object() || !project.contains("files") || !project["files"].is_array())
    throw InputError(path.project, "is no project file; the page writes one with Save");
  for (const Json& file : project["files"])
    if (file.is_object() && file.value("name", Json()) == path.entry) return file;
  return nullptr;
}

}  // namespace

std::optional<ProjectPath> project_path(const std::string& path) {
  const std::size_t at = path.find(std::string(kProjectEnding) + "/");
  if (at == std::string::npos) return std::nullopt;
  const std::size_t end = at + kProjectEnding.size();
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path.substr(0, end), ignored)) return std::nullopt;
  return ProjectPath{path.substr(0, end), path.substr(end + 1)};
}

std::string read_project_entry(const ProjectPath& path) {
  const Json file = entry_of(path);
  if (file.is_null()) throw InputError(path.project, "holds no file '" + path.entry + "'");
  if (const auto text = file.find("text"); text != file.end() && text->is_string())
    return text->get<std::string>();
  const auto coded = file.find("base64");
  const auto bytes = coded != file.end() && coded->is_string()
                         ? decoded_base64(coded->get_ref<const std::string&>())
                         : std::nullopt;
  if (!bytes)
    throw InputError(path.project,
                     "the file '" + path.entry + "' has neither text nor base64; save the project again");
  return *bytes;
}

bool is_file(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_regular_file(path, ignored)) return true;
  const auto within = project_path(path.string());
  return within && !entry_of(*within).is_null();
}

std::string sha256_hex(std::string_view bytes) {
  std::array<unsigned char, 32> digest{};
  unsigned int size = 0;
  const int done = EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr);
  CLEARCUT_ASSERT(done == 1 && size == digest.size());
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (const unsigned char byte : digest) {
    text += kDigits[byte >> 4U];
    text += kDigits[byte & 15U];
  }
  return text;
}

}  // namespace clearcut::inline base
