// The command as scripts see it: exit codes, one line for bad input, nothing written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "base/version.h"
#include "options/row.h"
#include "support/command.h"

namespace clearcut {
namespace {

using test_support::CommandResult;
using test_support::run_clearcut;
using test_support::ScratchFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const std::string kSquare = R"({"name": "square", "units": "mm",
  "outer": [[0, 0, 0], [50, 0, 0], [50, 50, 0], [0, 50, 0]], "islands": [], "top": 0, "depth": 2})";

long lines(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n');
}

/// A bad call: one line that says `what`, exit 2, nothing written.
struct BadCase {
  const char* name;
  const char* file_name;
  std::string content;
  std::vector<std::string> options;
  const char* what;
};

void PrintTo(const BadCase& bad, std::ostream* out) {
  *out << bad.name;
}

std::string outline(const std::string& outer, const std::string& islands = "[]") {
  return R"({"name": "p", "units": "mm", "outer": )" + outer + R"(, "islands": )" + islands +
         R"(, "top": 0, "depth": 2})";
}

const std::string kBox = "[[0,0,0],[50,0,0],[50,50,0],[0,50,0]]";

class BadInput : public ::testing::TestWithParam<BadCase> {};

TEST_P(BadInput, GetsOneLineExitTwoAndNothingWritten) {
  const auto& bad = GetParam();
  const ScratchFolder folder;
  const auto input = folder.file(bad.file_name, bad.content);
  std::vector<std::string> arguments{
      "plan", input, "-o", folder.path("out.ngc"), "--certificate", folder.path("c.json")};
  arguments.insert(arguments.end(), bad.options.begin(), bad.options.end());
  const CommandResult result = run_clearcut(arguments);
  EXPECT_EQ(result.exit_code, 2) << result.err;
  EXPECT_EQ(lines(result.err), 1) << result.err;
  EXPECT_THAT(result.err, HasSubstr(bad.what));
  EXPECT_THAT(result.out, IsEmpty());
  EXPECT_THAT(folder.names(), ElementsAre(bad.file_name));
}

const std::vector<std::string> kTool{"--tool", "endmill:6"};

INSTANTIATE_TEST_SUITE_P(
    CommandLine, BadInput,
    ::testing::Values(
        BadCase{"EmptyFile", "a.json", "", kTool, "a.json"},
        BadCase{"NotJson", "a.json", "{\"outer\": [", kTool, "a.json:1"},
        BadCase{"NoTool", "a.json", kSquare, {}, "--tool"},
        BadCase{"BadTool", "a.json", kSquare, {"--tool", "spoon:6"}, "spoon"},
        BadCase{"NegativeDiameter", "a.json", kSquare, {"--tool", "endmill:-6"}, "diameter"},
        BadCase{"ToolTooLarge", "a.json", kSquare, {"--tool", "endmill:60"}, "60"},
        BadCase{
            "UnknownStrategy", "a.json", kSquare, {"--tool", "endmill:6", "--strategy", "magic"}, "magic"},
        BadCase{"UnknownPost", "a.json", kSquare, {"--tool", "endmill:6", "--post", "abacus"}, "abacus"},
        BadCase{"BadStepdown", "a.json", kSquare, {"--tool", "endmill:6", "--stepdown", "0"}, "--stepdown"},
        BadCase{"UnknownOption", "a.json", kSquare, {"--magic"}, "--magic"},
        BadCase{"UnknownKind", "a.xyz", "some text", kTool, "a.xyz"},
        BadCase{"Coordinate", "a.json", outline("[[0,0,0],[1e300,0,0],[50,50,0]]"), kTool, "a.json"},
        BadCase{"TwoPoints", "a.json", outline("[[0,0,0],[50,0,0]]"), kTool, "a.json"},
        BadCase{"NoArea", "a.json", outline("[[0,0,0],[50,0,0],[20,0,0]]"), kTool, "a.json"},
        BadCase{"IslandOutside", "a.json", outline(kBox, "[[[60,60,0],[70,60,0],[70,70,0]]]"), kTool,
                "a.json"},
        BadCase{"Binary", "a.p21", std::string("\0\1\2\3ISO", 7), kTool, "a.p21"},
        BadCase{"TruncatedStep", "a.p21", "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#1=PROJECT('", kTool,
                "a.p21:5"},
        BadCase{"BadDxf", "a.dxf", "no drawing", kTool, "a.dxf"},
        BadCase{"BadSvg", "a.svg", "<svg", kTool, "a.svg"}),
    [](const auto& bad) { return std::string(bad.param.name); });

TEST(CommandLine, MissingInputIsNamed) {
  const auto result = run_clearcut({"plan", "/no/such.json", "-o", "/tmp/x.ngc"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("/no/such.json"));
}

TEST(CommandLine, UnwritableOutputLeavesNothing) {
  const ScratchFolder folder;
  const auto input = folder.file("a.json", kSquare);
  const auto result = run_clearcut({"plan", input, "-o", folder.path("none/out.ngc"), "--certificate",
                                    folder.path("c.json"), "--tool", "endmill:6"});
  EXPECT_EQ(result.exit_code, 2) << result.err;
  EXPECT_THAT(folder.names(), ElementsAre("a.json"));
}

TEST(CommandLine, WhatCannotBePrintedIsNotSilent) {
  const ScratchFolder folder;
  const auto input = folder.file("a.json", kSquare);
  if (!std::filesystem::is_character_file("/dev/full")) GTEST_SKIP() << "no /dev/full";
  const std::vector<std::string> plan{"plan", input, "--tool", "endmill:6", "--strategy", "contour", "-o"};
  auto full = plan;
  full.push_back("/dev/full");
  EXPECT_EQ(run_clearcut(full).exit_code, 2);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
  auto streamed = plan;
  streamed.insert(streamed.end(), {"/dev/stdout", "--quiet"});
  const auto result = run_clearcut(streamed);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("M2"));
}

TEST(CommandLine, SwitchesOfThePostReachTheProgram) {
  const ScratchFolder folder;
  const auto input = folder.file("a.json", kSquare);
  const auto program = [&](std::vector<std::string> switches) {
    std::vector<std::string> arguments{"plan",    input, "--tool", "endmill:6", "--strategy",
                                       "contour", "-o",  "-",      "--quiet"};
    arguments.insert(arguments.end(), switches.begin(), switches.end());
    const auto result = run_clearcut(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.out;
  };
  const std::string usual = program({});
  EXPECT_THAT(usual, HasSubstr("M6"));
  EXPECT_THAT(usual, HasSubstr("G43"));
  EXPECT_THAT(usual, HasSubstr("G64"));
  const std::string own = program({"--no-tool-change", "--exact-stop", "--spindle-wait", "3.5", "--lead", "1",
                                   "--no-arcs", "--decimals", "3"});
  for (const char* word : {"M6", "G43", "G64", "G2 ", "G3 "}) EXPECT_THAT(own, Not(HasSubstr(word)));
  EXPECT_THAT(own, HasSubstr("G61"));
  EXPECT_THAT(own, HasSubstr("G4 P3.5"));
  EXPECT_EQ(run_clearcut({"plan", input, "-o", "-", "--decimals", "7"}).exit_code, 2);
}

/// A table in which nothing can be used.
TEST(CommandLine, NothingThatFitsIsNoSuccess) {
  const ScratchFolder folder;
  const auto input = folder.file("a.json", kSquare);
  for (const char* command : {"tools", "compare"}) {
    const auto result = run_clearcut({command, input, "--tool", "endmill:500"});
    EXPECT_EQ(result.exit_code, 2) << command;
    EXPECT_THAT(result.err, HasSubstr("does not fit")) << command;
  }
}

/// A cutter of the size that is named has to fit, beside the stock that is to stay on walls.
TEST(CommandLine, TheLargestCutterThatFitsIsRoundedDownAndLeavesTheStock) {
  const ScratchFolder folder;
  const auto slot = folder.file("a.json", R"({"name": "slot", "units": "mm", "depth": 2, "outer": [[0, 0, 0],
      [20, 0, 1], [20, 5.9999996, 0], [0, 5.9999996, 1]]})");
  const auto refusal = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"plan", slot, "-o", folder.path("a.ngc"), "--tool", "endmill:6"};
    words.insert(words.end(), more.begin(), more.end());
    return run_clearcut(words).err;
  };
  EXPECT_THAT(refusal({"--allowance", "0.2"}),
              HasSubstr("tool T1 (6 mm) does not fit slot beside 0.2 mm of stock to leave; the largest that "
                        "does has 5.599 mm"));
  EXPECT_THAT(refusal({"--allowance", "3"}), HasSubstr("beside 3 mm of stock to leave; leave less"));
}

TEST(CommandLine, VersionMatchesTheBuild) {
  const auto result = run_clearcut({"--version"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, HasSubstr(kVersion));
  EXPECT_THAT(read_file(std::string(CLEARCUT_SOURCE_DIR) + "/CMakeLists.txt"),
              HasSubstr(std::string("VERSION ") + kVersion));
}

TEST(CommandLine, PlanWritesProgramCertificateAndPicture) {
  const ScratchFolder folder;
  const auto input = folder.file("a.json", kSquare);
  const auto result =
      run_clearcut({"plan", input, "-o", folder.path("a.ngc"), "--tool", "endmill:6", "--certificate",
                    folder.path("a.cert.json"), "--svg", folder.path("a.svg"), "--report",
                    folder.path("a.html"), "--result", folder.path("a.txt")});
  EXPECT_EQ(result.exit_code, 0) << result.err << result.out;
  EXPECT_THAT(folder.names(), ElementsAre("a.cert.json", "a.html", "a.json", "a.ngc", "a.svg", "a.txt"));
  const auto certificate = nlohmann::json::parse(read_file(folder.path("a.cert.json")));
  EXPECT_TRUE(certificate.at("clean").get<bool>());
  EXPECT_LE(certificate.at("uncut_thickness_mm").get<double>(), 0.01);
  EXPECT_LE(certificate.at("gouge_mm").get<double>(), 0.001);
}

TEST(CommandLine, VerifyJudgesTheProgramAndAWrongOne) {
  const ScratchFolder folder;
  const auto input = folder.file("a.json", kSquare);
  ASSERT_EQ(
      run_clearcut({"plan", input, "-o", folder.path("a.ngc"), "--tool", "endmill:6", "--quiet"}).exit_code,
      0);
  const auto good = run_clearcut({"verify", folder.path("a.ngc"), "--part", input, "--tool", "endmill:6"});
  EXPECT_EQ(good.exit_code, 0) << good.out << good.err;
  const auto wrong = run_clearcut({"verify", folder.path("a.ngc"), "--part", input, "--tool", "endmill:5.9"});
  EXPECT_EQ(wrong.exit_code, 1) << wrong.out;
  const auto json =
      run_clearcut({"verify", folder.path("a.ngc"), "--part", input, "--tool", "endmill:6.1", "--json", "-"});
  EXPECT_EQ(json.exit_code, 1);
  EXPECT_FALSE(nlohmann::json::parse(json.out).at("clean").get<bool>());
}

TEST(CommandLine, WithoutAPartNoOptionOnThePartIsTaken) {
  const ScratchFolder folder;
  const auto program = folder.file("a.ngc", "G21 G90\nM30\n");
  int refused = 0;
  for (const Row& row : rows()) {
    if (!(row.checks & kCheckOfPart) || row.checks & kCheckOfProgram) continue;
    std::vector<std::string> arguments{"verify", program, "--tool", "endmill:6", "--" + row.name};
    if (row.kind == ValueKind::kPoint || row.kind == ValueKind::kPoints)
      arguments.emplace_back("1,2");
    else if (row.kind != ValueKind::kFlag)
      arguments.push_back(row.shown_example());
    const auto result = run_clearcut(arguments);
    EXPECT_EQ(result.exit_code, 2) << row.name << result.out;
    EXPECT_THAT(result.err, HasSubstr("--part")) << row.name;
    ++refused;
  }
  EXPECT_GT(refused, 30);
}

TEST(CommandLine, SameInputSameBytes) {
  const ScratchFolder folder;
  const auto input = folder.file("a.json", kSquare);
  for (const char* name : {"1", "2"}) {
    ASSERT_EQ(run_clearcut({"plan", input, "-o", folder.path(name), "--tool", "endmill:6", "--threads", name})
                  .exit_code,
              0);
  }
  EXPECT_EQ(read_file(folder.path("1")), read_file(folder.path("2")));
}

}  // namespace
}  // namespace clearcut
