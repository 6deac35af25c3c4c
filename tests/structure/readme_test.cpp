// The README's commands are run as they stand there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <sstream>

#include "base/file.h"
#include "support/command.h"

namespace clearcut {
namespace {

using test_support::run_clearcut;
using test_support::ScratchFolder;

const std::string kSource = CLEARCUT_SOURCE_DIR;

/// Lines of the README that are indented by four and begin with "clearcut ".
std::vector<std::vector<std::string>> commands() {
  std::vector<std::vector<std::string>> all;
  std::istringstream text(read_file(kSource + "/README.md"));
  for (std::string line; std::getline(text, line);) {
    if (line.rfind("    clearcut ", 0) != 0) continue;
    std::istringstream words(line.substr(0, line.find('#')));
    std::vector<std::string> command;
    for (std::string word; words >> word;) command.push_back(word);
    all.emplace_back(command.begin() + 1, command.end());
  }
  return all;
}

std::string json_block() {
  const std::string text = read_file(kSource + "/README.md");
  const auto begin = text.find("```json\n") + 8;
  return text.substr(begin, text.find("```", begin) - begin);
}

/// What a drawing program writes that knows nothing of layers' names: a rectangle and a circle in it.
std::string own_drawing() {
  std::string text =
      "0\nSECTION\n2\nHEADER\n9\n$"
      "INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\n0\n90\n4\n70\n1\n";
  for (const char* corner : {"10\n0\n20\n0\n", "10\n70\n20\n0\n", "10\n70\n20\n40\n", "10\n0\n20\n40\n"})
    text += corner;
  return text + "0\nCIRCLE\n8\n0\n10\n50\n20\n20\n40\n6\n0\nENDSEC\n0\nEOF\n";
}

TEST(Readme, CommandsRunCleanAsWritten) {
  const ScratchFolder folder;
  folder.file("pocket.json", json_block());
  folder.file("drawing.dxf", own_drawing());
  const auto all = commands();
  ASSERT_GE(all.size(), 4u);
  for (auto command : all) {
    for (auto& word : command) {
      if (word.rfind("examples/", 0) == 0) {
        word = kSource + "/" + word;
      } else if (word.find('.') != std::string::npos && word[0] != '-') {
        word = folder.path(word);
      }
    }
    const auto result = run_clearcut(command);
    EXPECT_EQ(result.exit_code, 0) << command[0] << " " << command[1] << "\n" << result.out << result.err;
  }
}

TEST(Readme, LinksLeadSomewhere) {
  const std::string text = read_file(kSource + "/README.md");
  const std::regex link("\\]\\(([^)]+)\\)");
  int links = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), link), end; it != end; ++it, ++links) {
    EXPECT_TRUE(std::filesystem::exists(kSource + "/" + (*it)[1].str())) << (*it)[1];
  }
  EXPECT_GE(links, 8);
}

/// Every key that the sources cite, such as [name1999], stands in docs/references.bib.
TEST(Readme, CitedKeysAreInTheReferences) {
  const std::string references = read_file(kSource + "/docs/references.bib");
  const std::regex citation("\\[([a-z]+(19|20)[0-9]{2}[a-z]?)\\]");
  int cited = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kSource + "/src")) {
    const auto extension = entry.path().extension();
    if (extension != ".h" && extension != ".cpp") continue;
    const std::string text = read_file(entry.path().string());
    for (std::sregex_iterator it(text.begin(), text.end(), citation), end; it != end; ++it, ++cited) {
      EXPECT_NE(references.find("{" + (*it)[1].str() + ","), std::string::npos)
          << entry.path() << " cites " << (*it)[1];
    }
  }
  EXPECT_GT(cited, 5);
}

}  // namespace
}  // namespace clearcut
