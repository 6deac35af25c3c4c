#include "base/files/output_names.h"

#include "base/error.h"

namespace clearcut::inline base {
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

}  // namespace clearcut::inline base
