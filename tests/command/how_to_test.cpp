// docs/tutorial.md, docs/feeds.md and docs/howto-*.md: their commands run in the order of the page, and print what the page says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <regex>

#include "base/file.h"
#include "base/text.h"
#include "read/step_solid/solid_model.h"
#include "support/command.h"

namespace clearcut::test_support {
namespace {

namespace fs = std::filesystem;

const fs::path kDocs = CLEARCUT_SOURCE_DIR "/docs";

std::vector<std::string> pages() {
  std::vector<std::string> names;
  for (const auto& file : fs::directory_iterator(kDocs)) {
    const std::string name = file.path().stem();
    if (file.path().extension() == ".md" &&
        (name == "tutorial" || name == "feeds" || name.starts_with("howto-")))
      names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// A block of commands (`exit_code` is that of its last one), or of lines that the commands before it print.
struct Block {
  bool commands = false;
  int exit_code = 0;
  std::string text;
};

std::vector<Block> blocks_of(const std::string& page) {
  static const std::regex fenced("(?:<!-- exit ([0-9]) -->\n)?```(sh|text)\n([^]*?)```");
  std::vector<Block> blocks;
  for (std::sregex_iterator at(page.begin(), page.end(), fenced), end; at != end; ++at)
    blocks.push_back({(*at)[2] == "sh", (*at)[1].matched ? std::stoi((*at)[1]) : 0, (*at)[3]});
  return blocks;
}

/// Runs commands in a folder, where the built `clearcut` is found; what they print goes into the file `said` there.
int run_in(const ScratchFolder& folder, const std::string& commands) {
  const fs::path programs = fs::path(CLEARCUT_COMMAND).parent_path();
  folder.file("block.sh", "cd \"$(dirname \"$0\")\"\nPATH='" + programs.string() + "':$PATH\n" + commands);
  const int status =
      std::system(("sh -u " + folder.path("block.sh") + " > " + folder.path("said") + " 2>&1").c_str());
  return WEXITSTATUS(status);
}

class HowTo : public ::testing::TestWithParam<std::string> {};

TEST_P(HowTo, RunsAsPrinted) {
  if (GetParam() == "howto-solid" && !read::solids_can_be_read())
    GTEST_SKIP() << "this build reads no STEP solids";
  const ScratchFolder folder;
  fs::create_directory_symlink(CLEARCUT_SOURCE_DIR "/examples", folder.path("examples"));
  fs::create_directory_symlink(CLEARCUT_SOURCE_DIR "/checker", folder.path("checker"));
  std::string said;
  int commands = 0;
  for (const Block& block : blocks_of(read_file((kDocs / (GetParam() + ".md")).string()))) {
    if (block.commands) {
      const int exit_code = run_in(folder, block.text);
      said = read_file(folder.path("said"));
      EXPECT_EQ(exit_code, block.exit_code) << block.text << said;
      ++commands;
      continue;
    }
    for (const std::string& line : split(block.text, '\n')) EXPECT_THAT(said, ::testing::HasSubstr(line));
  }
  EXPECT_GE(commands, 2);
  if (GetParam() != "tutorial") return;
  // Its pictures are those that its commands draw: copy them to docs/pictures where the drawing has changed.
  for (const char* name : {"pocket", "deep"})
    EXPECT_TRUE(read_file(folder.path(std::string(name) + ".svg")) ==
                read_file((kDocs / "pictures" / ("tutorial-" + std::string(name) + ".svg")).string()))
        << name;
}

INSTANTIATE_TEST_SUITE_P(Pages, HowTo, ::testing::ValuesIn(pages()), [](const auto& page) {
  std::string name = page.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace clearcut::test_support
