// Witnesses and the independent checker: docs/claim.md, docs/witness.md. Wrong ones are made by tests/wrong_witnesses/wrong.py.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>

#include "base/files/file.h"
#include "support/command.h"

namespace clearcut::test_support {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

const std::string kBracket = CLEARCUT_SOURCE_DIR "/examples/bracket.json";
const std::string kWrong = CLEARCUT_SOURCE_DIR "/tests/wrong_witnesses";
const std::string kChecker = (fs::path(CLEARCUT_COMMAND).parent_path() / "clearcut-check").string();

/// What a shell command ends with, and what it says.
CommandResult shell(const ScratchFolder& folder, const std::string& command) {
  const std::string said = folder.path("said");
  const int status = std::system((command + " > " + said + " 2>&1").c_str());
  return {WEXITSTATUS(status), read_file(said), ""};
}

CommandResult plan_bracket(const ScratchFolder& folder, std::vector<std::string> more = {}) {
  std::vector<std::string> arguments{
      "plan",   kBracket, "--tool", "endmill:6", "-o", folder.path("b.nc"), "--witness", folder.path("b.ccw"),
      "--quiet"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_clearcut(arguments);
}

CommandResult check_bracket(const ScratchFolder& folder, const std::string& more = "") {
  return shell(folder, kChecker + " " + folder.path("b.nc") + " " + kBracket + " " + folder.path("b.ccw") +
                           " " + more);
}

class WitnessOf : public ::testing::TestWithParam<const char*> {};

TEST_P(WitnessOf, AProgramForEachControllerIsAccepted) {
  const ScratchFolder folder;
  EXPECT_EQ(plan_bracket(folder, {"--post", GetParam()}).exit_code, 0);
  const CommandResult checked = check_bracket(folder, "--diameter 6");
  EXPECT_EQ(checked.exit_code, 0);
  EXPECT_THAT(checked.out, HasSubstr("proven for a flat cutter of diameter 6.0 mm"));
}

INSTANTIATE_TEST_SUITE_P(Controllers, WitnessOf,
                         ::testing::Values("linuxcnc", "grbl", "fanuc", "haas", "heidenhain", "mach3",
                                           "mach4", "marlin", "siemens"));

TEST(Witness, SaysOfWhichCutterAndProgramItIs) {
  const ScratchFolder folder;
  plan_bracket(folder);
  EXPECT_EQ(check_bracket(folder, "--diameter 5").exit_code, 1);
  const std::string program = read_file(folder.path("b.nc"));
  folder.file("b.nc", program + "\n");
  const CommandResult other = check_bracket(folder);
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_THAT(other.out, HasSubstr("another program"));
}

TEST(Witness, StockToLeaveIsPartOfTheClaim) {
  const ScratchFolder folder;
  EXPECT_EQ(plan_bracket(folder, {"--allowance", "0.3", "--allowance-floor", "0.2"}).exit_code, 0);
  EXPECT_THAT(check_bracket(folder).out,
              HasSubstr("0.3 mm of stock left on walls, 0.2 mm of stock left on the floor"));
}

TEST(Witness, WhatIsNotClaimedHasNone) {
  const ScratchFolder folder;
  const CommandResult ball = run_clearcut(
      {"plan", kBracket, "--tool", "ball:6", "-o", folder.path("b.nc"), "--witness", folder.path("b.ccw")});
  EXPECT_EQ(ball.exit_code, 1);
  EXPECT_THAT(ball.out, HasSubstr("NO WITNESS: witnesses are for flat cutters"));
  EXPECT_FALSE(fs::exists(folder.path("b.ccw")));
  const CommandResult deeper = plan_bracket(folder, {"--depth", "4"});
  EXPECT_EQ(deeper.exit_code, 1);
  EXPECT_THAT(deeper.out, HasSubstr("other heights than what was planned"));
  const CommandResult drawing =
      run_clearcut({"plan", CLEARCUT_SOURCE_DIR "/examples/bracket.dxf", "--tool", "endmill:6", "-o",
                    folder.path("c.nc"), "--witness", folder.path("c.ccw")});
  EXPECT_EQ(drawing.exit_code, 2);
  EXPECT_FALSE(fs::exists(folder.path("c.nc")));
}

TEST(Witness, VerifyProvesByTheCheckerAlone) {
  const ScratchFolder folder;
  plan_bracket(folder);
  const std::vector<std::string> verify{"verify", folder.path("b.nc"), "--part", kBracket,
                                        "--tool", "endmill:6",         "--prove"};
  const CommandResult proved = run_clearcut(verify);
  EXPECT_EQ(proved.exit_code, 0);
  EXPECT_THAT(proved.out, HasSubstr("proved by witness (checked in "));
  std::string program = read_file(folder.path("b.nc"));
  const std::string line = "X14.5 Y10.3825\n";
  const std::size_t at = program.find(line);
  ASSERT_NE(at, std::string::npos);
  folder.file("b.nc", program.replace(at, line.size(), "X14.5 Y14.3825\n"));
  const CommandResult wrong = run_clearcut(verify);
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_THAT(wrong.out, HasSubstr("NOT PROVED: "));
}

TEST(Witness, WrongOnesAreRefused) {
  const ScratchFolder folder;
  plan_bracket(folder);
  const CommandResult said =
      shell(folder, "python3 " + kWrong + "/wrong.py " + kChecker + " " + folder.path("b.nc") + " " +
                        kBracket + " " + folder.path("b.ccw") + " 300");
  EXPECT_EQ(said.exit_code, 0) << said.out;
  EXPECT_THAT(said.out, HasSubstr("300 wrong witnesses of 30 kinds, 0 not refused"));
}

TEST(Checker, DecidesAtItsBoundsAsRationalsDo) {
  const ScratchFolder folder;
  const CommandResult said = shell(folder, "${CXX:-c++} -std=c++20 -O0 -o " + folder.path("predicates") +
                                               " " + kWrong + "/predicates.cpp && python3 " + kWrong +
                                               "/bounds.py " + folder.path("predicates") + " 600");
  EXPECT_EQ(said.exit_code, 0) << said.out;
}

}  // namespace
}  // namespace clearcut::test_support
