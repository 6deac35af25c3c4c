// Compares every #include in src/ with src/dependencies.txt, and holds the programs in apps/ to the library's own headers.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

namespace {

namespace fs = std::filesystem;
const fs::path kSource = fs::path(CLEARCUT_SOURCE_DIR) / "src";

std::map<std::string, std::set<std::string>> allowed_edges() {
  std::map<std::string, std::set<std::string>> allowed;
  std::ifstream file(kSource / "dependencies.txt");
  for (std::string line; std::getline(file, line);) {
    const auto colon = line.find(':');
    if (line.empty() || line[0] == '#' || colon == std::string::npos) continue;
    auto& uses = allowed[line.substr(0, colon)];
    std::istringstream words(line.substr(colon + 1));
    for (std::string word; words >> word;) uses.insert(word);
  }
  return allowed;
}

TEST(Dependencies, EveryIncludeIsAllowed) {
  const auto allowed = allowed_edges();
  ASSERT_FALSE(allowed.empty());
  const std::regex include("^\\s*#include \"([a-z_]+)/[^\"]+\"");
  int checked = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kSource)) {
    const auto extension = entry.path().extension();
    if (extension != ".h" && extension != ".cpp") continue;
    const std::string folder = fs::relative(entry.path(), kSource).begin()->string();
    ASSERT_TRUE(allowed.count(folder)) << folder << " is not in dependencies.txt";
    std::ifstream file(entry.path());
    int number = 0;
    for (std::string line; std::getline(file, line);) {
      ++number;
      std::smatch match;
      if (!std::regex_search(line, match, include) || match[1] == folder) continue;
      ++checked;
      // The finder of witnesses reads program and part by the very code that will check them.
      if (match[1] == "checker" && folder == "pipeline") continue;
      EXPECT_TRUE(allowed.at(folder).count(match[1]))
          << entry.path() << ":" << number << ": " << folder << " may not include " << match[1];
    }
  }
  EXPECT_GT(checked, 50);
}

/// Folders of src/ by the folders whose files they include, each with one such file. Tests are left out.
using FolderArrows = std::map<std::string, std::map<std::string, std::string>>;

FolderArrows folder_arrows() {
  FolderArrows arrows;
  const std::regex include("^#include \"([a-z0-9_/]+)/([a-z0-9_]+\\.h)\"");
  for (const auto& entry : fs::recursive_directory_iterator(kSource)) {
    const std::string name = entry.path().filename().string(), stem = entry.path().stem().string();
    const bool is_test =
        name.rfind("test_", 0) == 0 || (stem.size() > 5 && stem.substr(stem.size() - 5) == "_test");
    if ((entry.path().extension() != ".h" && entry.path().extension() != ".cpp") || is_test) continue;
    const std::string from = fs::relative(entry.path().parent_path(), kSource).string();
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      std::smatch match;
      if (!std::regex_search(line, match, include) || match[1] == from ||
          !fs::exists(kSource / match[1].str()))
        continue;
      arrows[from].emplace(match[1], name + " includes " + match[1].str() + "/" + match[2].str());
    }
  }
  return arrows;
}

/// Follows the arrows depth first and says the first way that comes back to where it was.
std::string way_back(const FolderArrows& arrows, const std::string& folder, std::vector<std::string>& way,
                     std::set<std::string>& done) {
  if (!done.insert(folder).second) return "";
  way.push_back(folder);
  const auto found = arrows.find(folder);
  if (found != arrows.end()) {
    for (const auto& [to, why] : found->second) {
      if (std::find(way.begin(), way.end(), to) != way.end())
        return folder + "/" + why + ", and that needs " + folder;
      const std::string back = way_back(arrows, to, way, done);
      if (!back.empty()) return back;
    }
  }
  way.pop_back();
  return "";
}

TEST(Dependencies, FoldersWithinFoldersClimbNowhere) {
  const FolderArrows arrows = folder_arrows();
  EXPECT_GT(arrows.size(), 60U);
  std::set<std::string> done;
  for (const auto& [folder, to] : arrows) {
    std::vector<std::string> way;
    const std::string back = way_back(arrows, folder, way, done);
    EXPECT_EQ(back, "");
    if (!back.empty()) return;
  }
}

std::vector<fs::directory_entry> sources_of_programs() {
  std::vector<fs::directory_entry> all;
  for (const char* folder : {"apps", "python/src"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(CLEARCUT_SOURCE_DIR) / folder))
      all.push_back(entry);
  }
  return all;
}

/// The command and the Python module are users of the library like any other: <clearcut/...>, and its own files by their bare names. The programs
/// that know the CAD kernel and that draw pages stand behind the reader of solids and the writer of sheets and speak their languages.
TEST(Dependencies, ProgramsIncludeTheLibraryAlone) {
  const std::regex include("^\\s*#include [<\"]([a-z0-9_]+)/([a-z_0-9/]+\\.h)[>\"]");
  int checked = 0;
  for (const auto& entry : sources_of_programs()) {
    const auto extension = entry.path().extension();
    if (extension != ".h" && extension != ".cpp") continue;
    const fs::path folder = entry.path().parent_path().filename();
    const bool solids = folder == "solids", sheet = folder == "sheet";
    std::ifstream file(entry.path());
    int number = 0;
    for (std::string line; std::getline(file, line);) {
      ++number;
      std::smatch match;
      if (!std::regex_search(line, match, include)) continue;
      const bool header_of_system = !fs::exists(kSource / match[1].str()) && match[1] != "studies";
      if (header_of_system && match[1] != "clearcut") continue;
      ++checked;
      EXPECT_TRUE(match[1] == "clearcut" ||
                  (solids && (match[1] == "base" || match[1] == "geometry" || match[1] == "read")) ||
                  (sheet && match[1] == "report"))
          << entry.path() << ":" << number << ": include <clearcut/...> instead of " << match[1] << "/"
          << match[2];
    }
  }
  EXPECT_GT(checked, 20);
}

/// What is installed brings no header of research and none of another package.
TEST(Dependencies, PublicHeadersIncludeOursAlone) {
  const std::regex include("^\\s*#include ([<\"])([^>\"]+)[>\"]");
  int checked = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(CLEARCUT_SOURCE_DIR) / "include")) {
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      std::smatch match;
      if (!std::regex_search(line, match, include)) continue;
      ++checked;
      const bool of_the_language = match[1] == "<" && match[2].str().find_first_of("./") == std::string::npos;
      EXPECT_TRUE(match[1] == "\"" || of_the_language) << entry.path() << ": " << line;
      EXPECT_NE(match[2].str().substr(0, 8), "studies/") << entry.path() << ": " << line;
    }
  }
  EXPECT_GT(checked, 20);
}

/// Of the programs, clearcut-studies alone holds research; the command hands it over.
TEST(Dependencies, TheProductHoldsNoResearch) {
  int checked = 0, research = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(CLEARCUT_SOURCE_DIR) / "apps")) {
    if (!entry.is_regular_file()) continue;
    const bool is_of_studies = entry.path().parent_path().filename() == "studies";
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      if (!line.starts_with("#include")) continue;
      ++checked;
      const bool is_research = line.find("studies.h") != std::string::npos;
      research += is_research;
      EXPECT_TRUE(is_of_studies || !is_research) << entry.path() << ": " << line;
    }
  }
  EXPECT_GT(checked, 300);
  EXPECT_GT(research, 2);
}

}  // namespace
