// Coolant from the command line, jobs, tool libraries and STEP-NC to the program, and where it is shown.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "base/file.h"
#include "support/command.h"

namespace clearcut {
namespace {

using test_support::run_clearcut;
using test_support::ScratchFolder;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kPocket = R"({"units": "mm", "depth": 2, "outer": [[0,0],[30,0],[30,20],[0,20]]})";

struct Planned {
  ScratchFolder folder;
  std::string program, sheet, out, err;
  int exit_code = 0;
};

void plan(Planned& made, const std::string& input, const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"plan",
                                     input,
                                     "--strategy",
                                     "zigzag",
                                     "-o",
                                     made.folder.path("a.nc"),
                                     "--setup-sheet",
                                     made.folder.path("sheet.html"),
                                     "--explain"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const auto result = run_clearcut(arguments);
  made.exit_code = result.exit_code;
  made.out = result.out;
  made.err = result.err;
  if (result.exit_code == 2) return;
  made.program = read_file(made.folder.path("a.nc"));
  made.sheet = read_file(made.folder.path("sheet.html"));
}

TEST(Coolant, IsAskedForOnTheCommandLine) {
  Planned made;
  const auto part = made.folder.file("pocket.json", kPocket);
  plan(made, part, {"--tool", "endmill:6", "--coolant", "both"});
  EXPECT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(made.program, HasSubstr("\nM8\nM7\n"));
  EXPECT_THAT(made.program, HasSubstr("\nM9\n"));
  EXPECT_THAT(made.out, ContainsRegex("coolant +both +user +--coolant"));
  EXPECT_THAT(made.sheet, HasSubstr(">flood and mist<"));
  plan(made, part, {"--tool", "endmill:6"});
  EXPECT_THAT(made.program, Not(HasSubstr("\nM8")));
  EXPECT_THAT(made.out, ContainsRegex("coolant +off +default"));
  EXPECT_THAT(made.sheet, HasSubstr(">off<"));
  const auto wrong = run_clearcut({"plan", part, "--coolant", "foam"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("--coolant"));
}

TEST(Coolant, ThatAControlNeedNotHaveIsACondition) {
  Planned made;
  const auto part = made.folder.file("pocket.json", kPocket);
  plan(made, part, {"--tool", "endmill:6", "--post", "grbl", "--coolant", "mist"});
  EXPECT_THAT(made.program, HasSubstr("\nM7\n"));
  EXPECT_THAT(made.out, HasSubstr("ENABLE_M7"));
  plan(made, part, {"--tool", "endmill:6", "--post", "grbl", "--coolant", "mist", "--accept", "m7"});
  EXPECT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr("CLEAN"));
}

std::string job_with(const std::string& tool, const std::string& plan) {
  return "[part]\nfile = \"pocket.json\"\n[[tool]]\nnumber = 1\ndiameter = 6\n" + tool + "[plan]\n" + plan;
}

TEST(Coolant, OfAToolAndOfAJob) {
  Planned made;
  made.folder.file("pocket.json", kPocket);
  const auto program = [&](const std::string& tool, const std::string& of_plan,
                           const std::vector<std::string>& more = {}) {
    plan(made, made.folder.file("job.toml", job_with(tool, of_plan)), more);
    return made.program;
  };
  EXPECT_THAT(program("coolant = true\n", ""), HasSubstr("\nM8\n"));
  EXPECT_THAT(made.out, ContainsRegex("coolant +flood +job file +[^ ]*job.toml T1"));
  EXPECT_THAT(program("coolant = \"mist\"\n", ""), HasSubstr("\nM7\n"));
  EXPECT_THAT(program("coolant = \"mist\"\n", "coolant = false\n"), Not(HasSubstr("\nM7\n")));
  EXPECT_THAT(program("coolant = false\n", "coolant = \"flood\"\n"), HasSubstr("\nM8\n"));
  EXPECT_THAT(program("coolant = \"flood\"\n", "", {"--coolant", "off"}), Not(HasSubstr("\nM8\n")));
  plan(made, made.folder.file("job.toml", job_with("coolant = \"foam\"\n", "")), {});
  EXPECT_EQ(made.exit_code, 2);
  EXPECT_THAT(made.err, HasSubstr("'foam' is unknown; use one of off, flood, mist, both"));
}

/// What [plan] says holds for every tool; where it says nothing each tool has its own.
TEST(Coolant, OfTheSecondToolOfAJob) {
  Planned made;
  made.folder.file("pocket.json", kPocket);
  const auto words = [&](const std::string& of_plan, const std::string& first, const std::string& second) {
    const auto job =
        made.folder.file("job.toml", "[part]\nfile = \"pocket.json\"\n[plan]\nrest = true\n" + of_plan +
                                         "[[tool]]\nnumber = 1\ndiameter = 8\nfeed = 900\n" + first +
                                         "[[tool]]\nnumber = 2\ndiameter = 3\nfeed = 400\n" + second);
    plan(made, job, {});
    std::string found;
    std::istringstream lines(made.program);
    for (std::string line; std::getline(lines, line);)
      if (line == "T1 M6" || line == "T2 M6" || line == "M7" || line == "M8" || line == "M9")
        found += line + " ";
    return found;
  };
  EXPECT_EQ(words("", "coolant = \"flood\"\n", "coolant = \"mist\"\n"), "T1 M6 M8 M9 T2 M6 M7 M9 ")
      << made.err;
  EXPECT_EQ(words("", "coolant = \"flood\"\n", ""), "T1 M6 M8 M9 T2 M6 ");
  EXPECT_EQ(words("coolant = \"flood\"\n", "coolant = \"flood\"\n", ""), "T1 M6 M8 M9 T2 M6 M8 M9 ");
  EXPECT_EQ(words("coolant = \"mist\"\nfeed = 500\n", "", "coolant = \"flood\"\n"),
            "T1 M6 M7 M9 T2 M6 M7 M9 ");
  EXPECT_THAT(made.out, ContainsRegex("all +feed +500 "));
}

/// A library that says nothing of coolant leaves what the part's file says.
TEST(Coolant, OfStepNcStaysUnlessAToolSaysOtherwise) {
  Planned made;
  std::string part = read_file(std::string(CLEARCUT_SOURCE_DIR) + "/examples/fishhead.p21");
  const std::string dry = "MILLING_MACHINE_FUNCTIONS(.F.,$,$,.F.,";
  const auto with = [&](const std::string& functions) {
    std::string text = part;
    for (std::size_t at = 0; (at = text.find(dry, at)) != std::string::npos; at += functions.size())
      text.replace(at, dry.size(), functions);
    return made.folder.file("part.p21", text);
  };
  plan(made, with("MILLING_MACHINE_FUNCTIONS(.F.,$,.T.,.F.,"), {});
  EXPECT_THAT(made.program, HasSubstr("\nM7\n"));
  EXPECT_THAT(made.program, Not(HasSubstr("\nM8\n")));
  plan(made, with("MILLING_MACHINE_FUNCTIONS(.F.,$,.F.,.T.,"), {});
  EXPECT_THAT(made.program, HasSubstr("\nM8\n"));
  const auto library = [&](const std::string& more) {
    return made.folder.file("tools.toml", "[[tool]]\nnumber = 1\ndiameter = 6\nfeed = 700\n" + more);
  };
  plan(made, with("MILLING_MACHINE_FUNCTIONS(.T.,$,$,.F.,"), {"--tools", library("")});
  EXPECT_THAT(made.program, HasSubstr("\nM8\n")) << made.err;
  plan(made, made.folder.path("part.p21"), {"--tools", library("coolant = false\n")});
  EXPECT_THAT(made.program, Not(HasSubstr("\nM8\n")));
}

}  // namespace
}  // namespace clearcut
