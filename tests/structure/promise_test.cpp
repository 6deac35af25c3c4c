// The names that the library promises: include/clearcut/names.txt lists them, header by header. A name that goes, comes or moves to another
// header changes that list, and is seen by whoever reads the change.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
const fs::path kSource(CLEARCUT_SOURCE_DIR);
const fs::path kPromise = kSource / "include" / "clearcut";
/// Folders of src/ with the values that the promised functions take and give.
const std::set<std::string> kValues = {"base", "geometry", "model", "options", "order"};

/// The functions, types and constants of one header.
std::set<std::string> names_in(const fs::path& header) {
  static const std::regex taken("^using (?:[a-z_0-9]+::)+([A-Za-z_0-9]+);");
  static const std::regex renamed("^using ([A-Za-z_0-9]+) =");
  static const std::regex type("^(?:struct|class|enum class) ([A-Za-z_0-9]+)(?!.*;)");
  static const std::regex constant("^inline constexpr [^=]*\\b(k[A-Z][A-Za-z0-9]*)");
  static const std::regex function(
      "^(?!using|namespace|template|struct|class|enum|static_assert)[A-Za-z_][^=;(]*?[ &*]([a-z_0-9]+)\\(");
  std::set<std::string> names;
  std::ifstream file(header);
  for (std::string line; std::getline(file, line);) {
    std::smatch match;
    for (const std::regex* kind : {&taken, &renamed, &type, &constant, &function})
      if (std::regex_search(line, match, *kind)) names.insert(match[1]);
  }
  return names;
}

/// The headers that users see, as they are included: those of include/clearcut and all that these include.
std::set<std::string> seen_headers() {
  static const std::regex include("^#include \"([a-z0-9_/]+\\.h)\"");
  std::set<std::string> seen;
  std::vector<std::string> waiting;
  for (const auto& entry : fs::directory_iterator(kPromise))
    if (entry.path().extension() == ".h") waiting.push_back("clearcut/" + entry.path().filename().string());
  while (!waiting.empty()) {
    const std::string header = waiting.back();
    waiting.pop_back();
    if (!seen.insert(header).second) continue;
    const bool promised = header.starts_with("clearcut/");
    std::ifstream file(kSource / (promised ? "include" : "src") / header);
    for (std::string line; std::getline(file, line);)
      if (std::smatch match; std::regex_search(line, match, include)) waiting.push_back(match[1]);
  }
  return seen;
}

std::string promised_names() {
  std::map<std::string, std::set<std::string>> headers;
  for (const std::string& header : seen_headers())
    headers[header] = names_in(kSource / (header.starts_with("clearcut/") ? "include" : "src") / header);
  std::string text;
  for (const auto& [header, names] : headers) {
    if (names.empty()) continue;
    text += header + "\n";
    for (const std::string& name : names) text += "  " + name + "\n";
  }
  return text;
}

TEST(Promise, StagesAreOutOfReach) {
  for (const std::string& header : seen_headers()) {
    const std::string folder = header.substr(0, header.find('/'));
    EXPECT_TRUE(folder == "clearcut" || kValues.count(folder)) << header << " is a header of a stage";
  }
}

TEST(Promise, NamesAreThoseOfTheList) {
  if (std::getenv("CLEARCUT_UPDATE_GOLDEN") != nullptr)
    std::ofstream(kPromise / "names.txt") << promised_names();
  std::ifstream file(kPromise / "names.txt");
  std::stringstream listed;
  listed << file.rdbuf();
  EXPECT_EQ(promised_names(), listed.str())
      << "if that is meant, CLEARCUT_UPDATE_GOLDEN=1 writes include/clearcut/names.txt";
}

TEST(Promise, NamesOfFoldersAreNotPromised) {
  // Users write clearcut::plan_part, never clearcut::pipeline::plan_part: a stage may move.
  const std::regex folder("\\b(?:pipeline|resolve|plan|order|link|post|verify|report)::");
  std::ifstream file(fs::path(CLEARCUT_SOURCE_DIR) / "examples" / "embed" / "main.cpp");
  ASSERT_TRUE(file);
  for (std::string line; std::getline(file, line);) EXPECT_FALSE(std::regex_search(line, folder)) << line;
}

}  // namespace
