// The README's commands are run as they stand there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

TEST(Readme, CommandsRunCleanAsWritten) {
  const ScratchFolder folder;
  folder.file("pocket.json", json_block());
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

}  // namespace
}  // namespace clearcut
