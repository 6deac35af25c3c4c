#include "base/programs.h"

#include <filesystem>

namespace clearcut::inline base {

std::string companion(const std::string& name, const std::string& place, const std::string& other_place) {
  namespace fs = std::filesystem;
  std::error_code none;
  const fs::path beside = fs::path(own_program()).parent_path() / program_file(name);
  for (const fs::path& file : {beside, fs::path(place), fs::path(other_place)})
    if (file.is_absolute() && fs::exists(file, none)) return file.string();
  return {};
}

namespace {

std::string quoted_word(const std::string& word) {
  if (!word.empty() && word.find_first_of(" \t\n\v\"") == std::string::npos) return word;
  std::string out = "\"";
  std::size_t backslashes = 0;
  for (const char c : word) {
    if (c == '"') out.append(backslashes + 1, '\\');
    backslashes = c == '\\' ? backslashes + 1 : 0;
    out += c;
  }
  out.append(backslashes, '\\');
  return out + '"';
}

}  // namespace

std::string command_line(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + quoted_word(word);
  return line;
}

}  // namespace clearcut::inline base
