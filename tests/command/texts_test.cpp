// docs/texts.md: the commands that it names run, and its last column says no more than they hold.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "base/files/file.h"
#include "base/text/format.h"
#include "support/command.h"

namespace clearcut::test_support {
namespace {

/// A row of one of the page's tables.
struct Item {
  std::string what;
  std::string command;  ///< "" where there is none
  std::string agreement;
};

std::vector<Item> items_of_the_texts() {
  std::vector<Item> items;
  std::istringstream page(read_file(CLEARCUT_SOURCE_DIR "/docs/texts.md"));
  const std::regex row(R"(\| (.*) \| (.*) \| (?:`clearcut ([^`]*)` )?\| ([a-z ]+) \|)");
  std::smatch match;
  for (std::string line; std::getline(page, line);)
    if (std::regex_match(line, match, row) && match[4] != "agreement")
      items.push_back({match[1], match[3], match[4]});
  return items;
}

/// The command's words; its files are in the scratch folder, the examples in the source folder.
std::vector<std::string> arguments_of(const std::string& command, const ScratchFolder& folder) {
  std::vector<std::string> words = split(command, ' ');
  for (std::string& word : words) {
    if (word.starts_with("examples/"))
      word = std::string(CLEARCUT_SOURCE_DIR) + "/" + word;
    else
      for (const char* end : {".edges", ".p21", ".ngc", ".svg", ".html", ".json", ".txt"})
        if (word.ends_with(end)) word = folder.path(word);
  }
  if (words.front() == "study")
    for (const char* brief : {"--runs", "2", "--generations", "20", "--side", "4"}) words.emplace_back(brief);
  return words;
}

/// The page's own `sed`.
std::string without_a_depth(std::string program) {
  const auto pocket = program.find("POCKET('NO_STRATEGY'");
  const std::string depth = "#22,";
  program.replace(program.find(depth, pocket), depth.size(), "$,");
  return program;
}

TEST(TextsPage, KnowsFourTexts) {
  const auto items = items_of_the_texts();
  EXPECT_GE(items.size(), 85u);
  for (const Item& item : items) {
    EXPECT_THAT(item.agreement, ::testing::AnyOf("agrees", "explained", "differs", "runs", "not built"))
        << item.what;
    EXPECT_EQ(item.command.empty(), item.agreement == "not built") << item.what;
  }
}

/// Tables are held by the tests of the studies; here everything else that the page names.
TEST(TextsPage, EveryCommandRuns) {
  const ScratchFolder folder;
  folder.file("part.edges", "name plate\ndepth 2\n60 90\n40 90\n60 90\n40 90\n");
  folder.file("triangle.edges", "name triangle\ndepth 2\n79.9861 60\n79.9861 60\n79.9861 60\n");
  folder.file("no_depth.p21", without_a_depth(read_file(CLEARCUT_SOURCE_DIR "/examples/strategies.p21")));
  std::set<std::string> done;  // some rows share a command
  int run = 0;
  for (const Item& item : items_of_the_texts()) {
    if (item.command.empty() || item.command.starts_with("reproduce ")) continue;
    if (!done.insert(item.command).second) continue;
    const auto result = run_clearcut(arguments_of(item.command, folder));
    EXPECT_THAT(result.exit_code, ::testing::AnyOf(0, 1)) << item.command << "\n" << result.err;
    EXPECT_EQ(item.agreement, "runs") << item.what;
    if (item.command.find("-o a.ngc") != std::string::npos) {
      EXPECT_TRUE(std::filesystem::remove(folder.path("a.ngc"))) << item.command;
    }
    if (item.command.find("no_depth") != std::string::npos) {
      EXPECT_EQ(result.exit_code, 1);
      EXPECT_TRUE(result.out.starts_with("NOT MACHINED: NO_STRATEGY\n")) << result.out;
    }
    ++run;
  }
  EXPECT_GE(run, 50);
}

/// From its heading to the next.
std::string section_of(const std::string& page, const std::string& table) {
  const auto begin = page.find("<h2 id=\"" + table + "\"");
  if (begin == std::string::npos) return "";
  const auto end = std::min(page.find("<h2", begin + 1), page.find("</body>", begin));
  return page.substr(begin, end - begin);
}

/// Of those tables that hold no times, cell by cell.
TEST(TextsPage, ThePageOfReproducedTablesIsWhatTheProgramWrites) {
  const ScratchFolder folder;
  const std::vector<std::string> tables{"coefficients", "overlaps", "captions", "triangle"};
  std::vector<std::string> command{"reproduce", "--html", folder.path("t.html")};
  command.insert(command.end(), tables.begin(), tables.end());
  ASSERT_EQ(run_clearcut(command).exit_code, 0);
  const std::string written = read_file(folder.path("t.html"));
  const std::string page = read_file(CLEARCUT_SOURCE_DIR "/docs/reproduced.html");
  for (const auto& table : tables) {
    ASSERT_FALSE(section_of(written, table).empty()) << table;
    EXPECT_EQ(section_of(page, table), section_of(written, table));
  }
}

/// The last column of docs/texts.md, for the long tables too: what the program said when it wrote the page of tables.
TEST(TextsPage, TheLastColumnIsWhatThePageOfReproducedTablesHolds) {
  const std::string page = read_file(CLEARCUT_SOURCE_DIR "/docs/reproduced.html");
  const std::regex row(
      "#([a-z0-9-]+)\">[a-z0-9-]+</a></td><td>(\\d+)</td><td>(\\d+)</td><td class=\"([a-z]+)\">");
  std::map<std::string, std::string> made;
  for (std::sregex_iterator at(page.begin(), page.end(), row), end; at != end; ++at) {
    const bool is_compared = (*at)[2] != "0" || (*at)[3] != "0" || (*at)[4] == "differs";
    made[(*at)[1]] = is_compared ? (*at)[4].str() : "runs";
  }
  EXPECT_GE(made.size(), 8u);
  for (const Item& item : items_of_the_texts()) {
    if (!item.command.starts_with("reproduce ")) continue;
    const auto found = made.find(item.command.substr(10));
    if (found != made.end()) {
      EXPECT_EQ(item.agreement, found->second) << item.what;
    }
  }
}

/// A table that the file has is not made again.
TEST(TextsPage, ReproducedTablesAreTakenUpAgain) {
  const ScratchFolder folder;
  const std::string json = folder.path("t.json");
  ASSERT_EQ(run_clearcut({"reproduce", "captions", "--json", json}).exit_code, 0);
  std::string text = read_file(json);
  text.replace(text.find("Coefficients and steps"), 12, "COEFFICIENTS");
  folder.file("t.json", text);
  const auto resumed = run_clearcut({"reproduce", "captions", "triangle", "--json", json, "--resume"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_THAT(resumed.out, ::testing::AllOf(::testing::HasSubstr("COEFFICIENTS and steps"),
                                            ::testing::HasSubstr("CPO-kappa figure 10")));
  EXPECT_EQ(run_clearcut({"reproduce", "captions", "--resume"}).exit_code, 2);
}

}  // namespace
}  // namespace clearcut::test_support
