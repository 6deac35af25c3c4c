// Every page of the documentation can be reached from the README, and every link leads somewhere.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "base/file.h"

namespace clearcut {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = CLEARCUT_SOURCE_DIR;

/// The files that a Markdown page links to, relative to the root; links to the web and within the page are left out.
/// Code is no link: blocks between fences and words in backquotes are skipped.
std::vector<fs::path> targets_of(const fs::path& page) {
  static const std::regex code("```[^]*?```|`[^`\n]*`"), link("\\]\\(([^)#\\s]+)(#[^)]*)?\\)");
  const std::string text = std::regex_replace(read_file((kRoot / page).string()), code, "code");
  std::vector<fs::path> targets;
  for (std::sregex_iterator at(text.begin(), text.end(), link), end; at != end; ++at) {
    const std::string target = (*at)[1];
    if (target.find(':') != std::string::npos) continue;
    targets.push_back((page.parent_path() / target).lexically_normal());
  }
  return targets;
}

/// All Markdown pages that links lead to from `first`, itself included.
std::set<fs::path> reachable_from(const fs::path& first) {
  std::set<fs::path> reached{first};
  std::vector<fs::path> open{first};
  while (!open.empty()) {
    const fs::path page = open.back();
    open.pop_back();
    for (const fs::path& target : targets_of(page)) {
      const bool is_page = target.extension() == ".md" && fs::exists(kRoot / target);
      if (is_page && reached.insert(target).second) open.push_back(target);
    }
  }
  return reached;
}

TEST(Docs, EveryPageIsReachedFromTheReadme) {
  const auto reached = reachable_from("README.md");
  int pages = 0;
  for (const auto& file : fs::directory_iterator(kRoot / "docs")) {
    if (file.path().extension() != ".md") continue;
    ++pages;
    const fs::path page = fs::path("docs") / file.path().filename();
    EXPECT_EQ(reached.count(page), 1u) << page << " is linked from no page: add it to docs/README.md";
  }
  EXPECT_GE(pages, 15);
}

TEST(Docs, LinksLeadSomewhere) {
  int links = 0;
  for (const fs::path& page : reachable_from("README.md")) {
    for (const fs::path& target : targets_of(page)) {
      ++links;
      EXPECT_TRUE(fs::exists(kRoot / target)) << page << " links to " << target << ", which does not exist";
    }
  }
  EXPECT_GE(links, 60);
}

}  // namespace
}  // namespace clearcut
