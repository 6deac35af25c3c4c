#include "base/files/project_entry.h"

#include <array>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/files/file.h"

namespace clearcut::inline base {
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

}  // namespace clearcut::inline base
