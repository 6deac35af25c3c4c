#include "batch/batch_parts.h"

#include <clearcut/error.h>
#include <clearcut/file.h>
#include <clearcut/text.h>
#include <clearcut/version.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <set>
#include <sstream>

namespace clearcut::cli {
namespace {

namespace fs = std::filesystem;

bool is_part(const fs::path& file) {
  static const std::set<std::string> known{".p21", ".stp", ".step", ".stpnc", ".238",
                                           ".dxf", ".svg", ".json", ".edges", ".toml"};
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return known.contains(extension);
}

/// Certificates of an earlier run, in an output folder below, are no parts.
std::vector<BatchPart> parts_in_folder(const fs::path& folder, const fs::path& output) {
  std::error_code absent;
  if (fs::equivalent(folder, output, absent))
    throw InputError("--output", "is the folder of the parts; name another, which may lie in it");
  std::vector<BatchPart> parts;
  for (auto at = fs::recursive_directory_iterator(folder); at != fs::recursive_directory_iterator(); ++at) {
    const fs::path& path = at->path();
    if (at->is_directory() && fs::equivalent(path, output, absent)) at.disable_recursion_pending();
    if (at->is_regular_file() && is_part(path))
      parts.push_back({path.generic_string(), {}, fs::relative(path, folder).generic_string()});
  }
  std::sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return parts;
}

/// "part.dxf", then "part.dxf-2".
std::string unused(const std::string& name, std::map<std::string, int>& used) {
  const int count = ++used[name];
  return count == 1 ? name : name + "-" + std::to_string(count);
}

std::vector<BatchPart> parts_of_list(const fs::path& list) {
  std::vector<BatchPart> parts;
  std::map<std::string, int> used;
  std::istringstream lines(read_file(list.string()));
  for (std::string line; std::getline(lines, line);) {
    const auto words = CLI::detail::split_up(line.substr(0, line.find('#')));
    if (words.empty()) continue;
    const fs::path named(words.front());
    const fs::path file = named.is_absolute() ? named : list.parent_path() / named;
    parts.push_back(
        {file.generic_string(), {words.begin() + 1, words.end()}, unused(named.filename().string(), used)});
  }
  return parts;
}

/// Files named in a job: quoted words equal to names of files beside it.
std::vector<std::string> files_of_job(const std::string& job) {
  std::vector<std::string> files;
  std::error_code ignored;
  for (const auto& word : split(read_file(job), '"')) {
    const fs::path file = fs::path(job).parent_path() / word;
    if (!word.empty() && fs::is_regular_file(file, ignored)) files.push_back(file.generic_string());
  }
  return files;
}

}  // namespace

std::vector<BatchPart> batch_parts(const std::string& folder_or_list, const std::string& output) {
  auto parts = fs::is_directory(folder_or_list) ? parts_in_folder(folder_or_list, output)
                                                : parts_of_list(folder_or_list);
  if (parts.empty())
    throw InputError(folder_or_list,
                     "holds no parts; name a folder of .dxf, .svg, .json, .p21, .step or .toml "
                     "files, or a list with one part a line");
  return parts;
}

std::string batch_key(const BatchPart& part, const std::vector<std::string>& options) {
  std::string all = std::string(kVersion) + '\n';
  const auto add = [&all](const std::string& word) {
    all += word + '\n';
    std::error_code ignored;
    if (fs::is_regular_file(word, ignored)) all += sha256_hex(read_file(word)) + '\n';
  };
  add(part.file);
  if (fs::path(part.file).extension() == ".toml") {
    for (const auto& file : files_of_job(part.file)) add(file);
  }
  for (const auto& word : options) add(word);
  for (const auto& word : part.options) add(word);
  return sha256_hex(all);
}

}  // namespace clearcut::cli
