// Typical mistakes at the command line and in job files: each gets one clear line that names the remedy, exit code 2, and nothing
// is written or overwritten. The table says which; the command itself is run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "base/file.h"
#include "base/text.h"
#include "support/command.h"

namespace clearcut {
namespace {

namespace fs = std::filesystem;
using test_support::run_clearcut;
using test_support::ScratchFolder;
using ::testing::HasSubstr;

const fs::path kFolder = fs::path(CLEARCUT_SOURCE_DIR) / "tests/mistakes";

struct Mistake {
  std::string name, call, job, says;
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

std::vector<Mistake> mistakes() {
  std::vector<Mistake> out;
  std::istringstream table(read_file((kFolder / "table.tsv").string()));
  for (std::string line; std::getline(table, line);) {
    if (line.empty() || line.front() == '#') continue;
    const auto cells = split(line, '\t');
    if (cells.size() != 4) throw std::runtime_error("not four columns: " + line);
    out.push_back({cells[0], cells[1], replaced(cells[2], "\\n", "\n"), cells[3]});
  }
  return out;
}

/// The files beside the table, and the job of this mistake.
void fill(const ScratchFolder& folder, const std::string& job) {
  for (const auto& entry : fs::directory_iterator(kFolder / "files"))
    folder.file(entry.path().filename().string(), read_file(entry.path().string()));
  const bool whole = job.starts_with("!");
  folder.file("job.toml",
              whole ? job.substr(1) + "\n" : read_file((kFolder / "files/head.toml").string()) + job + "\n");
}

std::map<std::string, std::string> contents(const ScratchFolder& folder) {
  std::map<std::string, std::string> out;
  for (const auto& name : folder.names()) out[name] = read_file(folder.path(name));
  return out;
}

void expect_refused(const Mistake& mistake) {
  const ScratchFolder folder;
  fill(folder, mistake.job);
  const auto before = contents(folder);
  std::vector<std::string> arguments;
  std::istringstream words(replaced(mistake.call, "@/", folder.path("")));
  for (std::string word; words >> word;) arguments.push_back(word);
  const auto result = run_clearcut(arguments);
  EXPECT_EQ(result.exit_code, 2) << result.err;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  EXPECT_THAT(result.err, HasSubstr(mistake.says));
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(contents(folder), before) << "something was written";
}

TEST(Mistakes, GetOneLineThatNamesTheRemedyAndNothingIsWritten) {
  const auto all = mistakes();
  EXPECT_GE(all.size(), 120U);
  std::set<std::string> names;
  for (const Mistake& mistake : all) {
    SCOPED_TRACE(mistake.name + ": clearcut " + mistake.call);
    EXPECT_TRUE(names.insert(mistake.name).second) << "a name twice";
    expect_refused(mistake);
  }
}

/// Where a call refuses to overwrite one, the same call refuses it by its links.
TEST(Mistakes, LinksToInputsAreInputs) {
  const ScratchFolder folder;
  fill(folder, "");
  fs::create_symlink(folder.path("square.json"), folder.path("soft.json"));
  fs::create_hard_link(folder.path("square.json"), folder.path("hard.json"));
  const auto before = contents(folder);
  for (const char* output : {"soft.json", "hard.json"}) {
    const auto result =
        run_clearcut({"plan", folder.path("square.json"), "--tool", "endmill:6", "-o", folder.path(output)});
    EXPECT_EQ(result.exit_code, 2) << result.err;
    EXPECT_THAT(result.err, HasSubstr("would be overwritten"));
  }
  EXPECT_EQ(contents(folder), before);
}

std::string program_of(const ScratchFolder& folder, std::vector<std::string> call) {
  call.insert(call.begin(), "plan");
  call.insert(call.end(), {"-o", folder.path("out.ngc")});
  const auto result = run_clearcut(call);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return read_file(folder.path("out.ngc"));
}

TEST(Quantities, InchesOnTheCommandLineAreThoseMillimetres) {
  const ScratchFolder folder;
  fill(folder, "");
  const std::string part = folder.path("square.json");
  const auto metric = program_of(
      folder, {part, "--tool", "endmill:6.35", "--feed", "1016", "--stepover", "0.4", "--stepdown", "1.27"});
  const auto inch = program_of(folder, {part, "--tool", "endmill:1/4in", "--feed", "40in/min", "--stepover",
                                        "40%", "--stepdown", "0.05in"});
  EXPECT_EQ(metric, inch);
}

/// Blocks of a program after a tool change.
std::string after_change(const std::string& program, const std::string& change) {
  const auto at = program.find(change);
  return at == std::string::npos ? "" : program.substr(at);
}

const std::string kTwoTools = R"([[tool]]
number = 1
kind = "endmill"
diameter = 16
feed = 1000
plunge_feed = 300
spindle = 8000
coolant = true

[[tool]]
number = 2
kind = "endmill"
diameter = 4
feed = 400
plunge_feed = 100
spindle = 15000
)";

void expect_own_data(const std::string& program) {
  const std::string first = program.substr(0, program.find("T2 M6")), second = after_change(program, "T2 M6");
  EXPECT_THAT(first, HasSubstr("M3 S8000"));
  EXPECT_THAT(first, HasSubstr("F1000"));
  EXPECT_THAT(first, HasSubstr("M8"));
  EXPECT_THAT(second, HasSubstr("M3 S15000"));
  EXPECT_THAT(second, HasSubstr("F400"));
  EXPECT_THAT(second, HasSubstr("F100\n"));
  for (const char* of_the_other : {"F1000", "F300", "M8\n", "M7\n"})
    EXPECT_EQ(second.find(of_the_other), std::string::npos) << of_the_other;
}

TEST(CuttingData, EveryToolOfAJobHasItsOwn) {
  const ScratchFolder folder;
  fill(folder, "!" + kTwoTools + "[part]\nfile = \"square.json\"\n[plan]\nrest = true");
  expect_own_data(program_of(folder, {folder.path("job.toml")}));
}

TEST(CuttingData, ALibraryOnTheCommandLineKeepsItsFeeds) {
  const ScratchFolder folder;
  fill(folder, "");
  const auto library = folder.file("two.toml", kTwoTools);
  expect_own_data(program_of(folder, {folder.path("square.json"), "--tools", library, "--rest"}));
}

TEST(CuttingData, WhatIsAskedForOnTheCommandLineGoesFirst) {
  const ScratchFolder folder;
  fill(folder, "");
  const auto library = folder.file("two.toml", kTwoTools);
  const auto program =
      program_of(folder, {folder.path("square.json"), "--tools", library, "--rest", "--feed", "777"});
  EXPECT_THAT(after_change(program, "T2 M6"), HasSubstr("F777"));
  EXPECT_THAT(after_change(program, "T2 M6"), HasSubstr("S15000"));
}

/// A workingstep without what it needs is a fault by name: terminal, header, certificate, exit code.
TEST(NotMachined, AMissingDepthIsAFaultByName) {
  const ScratchFolder folder;
  const fs::path whole = fs::path(CLEARCUT_SOURCE_DIR) / "examples/fishhead.p21";
  const std::string text =
      replaced(read_file(whole.string()), "#285=CLOSED_POCKET('POCKET2',#3,(#232),#281,#284,",
               "#285=CLOSED_POCKET('POCKET2',#3,(#232),#281,$,");
  const auto part = folder.file("part.p21", text);
  const auto result = run_clearcut({"plan", part, "--strategy", "contour", "-o", folder.path("out.ngc"),
                                    "--certificate", folder.path("c.json")});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.out.substr(0, result.out.find('\n')), "NOT MACHINED: POCKET2");
  const std::string program = read_file(folder.path("out.ngc"));
  EXPECT_THAT(program, HasSubstr("(CERTIFICATE: FAULTY)"));
  EXPECT_THAT(program, HasSubstr("(NOT MACHINED: POCKET2)"));
  EXPECT_THAT(read_file(folder.path("c.json")), HasSubstr("POCKET2 is not machined: "));
  const auto verified = run_clearcut({"verify", folder.path("out.ngc"), "--part", part});
  EXPECT_EQ(verified.exit_code, 1) << "nor is a program that does all the rest right";
}

}  // namespace
}  // namespace clearcut
