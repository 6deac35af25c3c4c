// The names that the library promises: include/clearcut/names.txt lists them, header by header. A name that goes, comes or moves to another
// header changes that list, and is seen by whoever reads the change.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

namespace {

namespace fs = std::filesystem;
const fs::path kPromise = fs::path(CLEARCUT_SOURCE_DIR) / "include" / "clearcut";

/// Of one header: names that it takes from the stages, its functions, classes and constants.
std::set<std::string> names_in(const fs::path& header) {
  static const std::regex taken("^using (?:[a-z_0-9]+::)+([A-Za-z_0-9]+);");
  static const std::regex renamed("^using ([A-Za-z_0-9]+) =");
  static const std::regex function("^inline [^=;]*?([a-z_0-9]+)\\(");
  static const std::regex type("^(?:struct|class|enum class) ([A-Za-z_0-9]+)");
  static const std::regex space("^(?:namespace clearcut::|namespace [a-z]+ = )([a-z_0-9]+)");
  std::set<std::string> names;
  std::ifstream file(header);
  for (std::string line; std::getline(file, line);) {
    std::smatch match;
    for (const std::regex* kind : {&taken, &renamed, &function, &type, &space})
      if (std::regex_search(line, match, *kind)) names.insert(match[1]);
  }
  return names;
}

std::string promised_names() {
  std::map<std::string, std::set<std::string>> headers;
  for (const auto& entry : fs::directory_iterator(kPromise))
    if (entry.path().extension() == ".h") headers[entry.path().filename().string()] = names_in(entry.path());
  std::string text;
  for (const auto& [header, names] : headers) {
    if (names.empty()) continue;
    text += header + "\n";
    for (const std::string& name : names) text += "  " + name + "\n";
  }
  return text;
}

TEST(Promise, NamesAreThoseOfTheList) {
  std::ifstream file(kPromise / "names.txt");
  std::stringstream listed;
  listed << file.rdbuf();
  EXPECT_EQ(promised_names(), listed.str())
      << "write the names to include/clearcut/names.txt, if that is meant";
}

TEST(Promise, NamesOfFoldersAreNotPromised) {
  // Users write clearcut::plan_part, never clearcut::pipeline::plan_part: a stage may move.
  const std::regex folder("\\b(?:pipeline|resolve|plan|order|link|post|verify|report)::");
  std::ifstream file(fs::path(CLEARCUT_SOURCE_DIR) / "examples" / "embed" / "main.cpp");
  ASSERT_TRUE(file);
  for (std::string line; std::getline(file, line);) EXPECT_FALSE(std::regex_search(line, folder)) << line;
}

}  // namespace
