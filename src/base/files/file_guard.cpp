#include "base/files/file_guard.h"

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <optional>

#include "base/error.h"

namespace clearcut::inline base {
namespace {

namespace fs = std::filesystem;

std::mutex mutex;
/// Absent: nobody asks.
std::optional<std::vector<std::string>> inputs;

bool is_standard_output(const std::string& path) {
  return path == "-" || path == "/dev/stdout" || path == "/dev/fd/1" || path == "/proc/self/fd/1";
}

/// A device or pipe: nothing is replaced by writing to it.
bool is_device(const std::string& path) {
  std::error_code ignored;
  const auto status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

void refuse_inputs(const std::string& output) {
  const std::lock_guard lock(mutex);
  if (!inputs || is_standard_output(output)) return;
  for (const std::string& input : *inputs) {
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

}  // namespace

InputGuard::InputGuard() {
  const std::lock_guard lock(mutex);
  inputs.emplace();
}

InputGuard::~InputGuard() {
  const std::lock_guard lock(mutex);
  inputs.reset();
}

void remember_input(const std::string& path) {
  const std::lock_guard lock(mutex);
  if (inputs && std::find(inputs->begin(), inputs->end(), path) == inputs->end()) inputs->push_back(path);
}

void forget_input(const std::string& path) {
  const std::lock_guard lock(mutex);
  if (inputs) std::erase_if(*inputs, [&](const std::string& input) { return is_same_file(input, path); });
}

namespace {

/// Where writing to `path` would end up: links followed, whether or not there is a file yet.
fs::path target_of(const std::string& path) {
  std::error_code error;
  fs::path place = fs::absolute(path, error);
  for (int links = 0; links < 40 && fs::is_symlink(place, error); ++links) {
    const fs::path to = fs::read_symlink(place, error);
    place = to.is_absolute() ? to : place.parent_path() / to;
  }
  return fs::weakly_canonical(place, error);
}

}  // namespace

bool is_same_file(const std::string& a, const std::string& b) {
  if (is_standard_output(a) || is_standard_output(b)) return is_standard_output(a) && is_standard_output(b);
  if (is_device(a) || is_device(b)) return false;
  std::error_code error;
  if (fs::equivalent(a, b, error) && !error) return true;
  return target_of(a) == target_of(b);
}

void check_outputs(const std::vector<std::string>& outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    refuse_bad_folder(outputs[i]);
    refuse_inputs(outputs[i]);
    for (std::size_t k = 0; k < i; ++k) {
      if (is_same_file(outputs[i], outputs[k]))
        throw InputError(outputs[i], "is named for two outputs; give each a file of its own");
    }
  }
}

}  // namespace clearcut::inline base
