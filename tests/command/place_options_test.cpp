// Where a program's zero is and where it ends: from the command line and jobs to the program and its verdict.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

TEST(WorkOffsetOption, IsAConditionUntilItIsAccepted) {
  Planned made;
  const auto part = made.folder.file("pocket.json", kPocket);
  const auto plan_at = [&](const char* post, const char* offset, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"--tool", "endmill:6", "--post", post, "--work-offset", offset};
    arguments.insert(arguments.end(), more.begin(), more.end());
    plan(made, part, arguments);
  };
  plan_at("linuxcnc", "g55", {});
  const int as_g55 = made.exit_code;
  plan_at("linuxcnc", "g59.3", {});
  EXPECT_EQ(made.exit_code, as_g55);
  EXPECT_THAT(made.program, HasSubstr(" G59.3 "));
  EXPECT_THAT(made.out, HasSubstr("G59.3 has its origin where the work's is"));
  EXPECT_THAT(made.out, ContainsRegex("work-offset +G59.3 +user +--work-offset"));
  plan_at("fanuc", "G54.1 P12", {"--accept", "g54.1-p12"});
  EXPECT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr("CLEAN"));
  EXPECT_THAT(made.program, HasSubstr("\nG54.1 P12\n"));
  EXPECT_THAT(made.sheet, HasSubstr("Zero, G54.1 P12"));
  plan_at("grbl", "G59.1", {});
  EXPECT_EQ(made.exit_code, 2);
  EXPECT_THAT(made.err, HasSubstr("--work-offset: grbl has no G59.1: it has G54 to G59"));
  plan_at("grbl", "G60", {});
  EXPECT_EQ(made.exit_code, 2);
  EXPECT_THAT(made.err, HasSubstr("'G60' is unknown; use one of G54 to G59"));
}

TEST(WorkOffsetOption, OfAJobIsNoOpenQuestion) {
  Planned made;
  made.folder.file("pocket.json", kPocket);
  const auto job = [&](const std::string& output) {
    return made.folder.file(
        "job.toml",
        "[part]\nfile = \"pocket.json\"\n[[tool]]\nnumber = 1\ndiameter = 6\n[output]\n" + output);
  };
  plan(made, job("post = \"haas\"\nwork_offset = \"G154 P7\"\n"), {});
  EXPECT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr("CLEAN"));
  EXPECT_THAT(made.program, HasSubstr("\nG154 P7\n"));
  plan(made, job("work_offset = \"G60\"\n"), {});
  EXPECT_EQ(made.exit_code, 2);
  EXPECT_THAT(made.err, HasSubstr("job.toml:7: work_offset: 'G60' is unknown; use one of G54 to G59"));
}

TEST(EndPositionOption, IsCertifiedLikeTheRest) {
  Planned made;
  const auto part = made.folder.file("pocket.json", kPocket);
  plan(made, part, {"--tool", "endmill:6", "--end-position", "60,10"});
  EXPECT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr("CLEAN"));
  EXPECT_THAT(made.out, ContainsRegex("end-position +60,10 +user +--end-position"));
  const std::string end = "X60 Y10\n";
  const std::size_t at = made.program.rfind(end);
  ASSERT_NE(at, std::string::npos) << made.program;
  // The same way at a height where the material stands.
  const auto low = made.folder.file(
      "low.nc", std::string(made.program).insert(made.program.rfind('\n', at) + 1, "G0 Z-1\n"));
  const auto verified = run_clearcut({"verify", low, "--part", part, "--tool", "endmill:6"});
  EXPECT_EQ(verified.exit_code, 1) << verified.out;
  EXPECT_THAT(verified.out, HasSubstr("rapid"));
}

TEST(EndPositionOption, HomeIsAConditionWhereTheMachineDecidesIt) {
  Planned made;
  const auto part = made.folder.file("pocket.json", kPocket);
  const auto plan_for = [&](const char* post, const std::string& end) {
    plan(made, part, {"--tool", "endmill:6", "--post", post, "--end-position", end});
  };
  plan_for("haas", "home");
  EXPECT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr("CLEAN"));
  EXPECT_THAT(made.program, HasSubstr("G53 G0 Z0.\nG53 G0 X0. Y0.\nM30"));
  plan_for("linuxcnc", "home");
  EXPECT_THAT(made.out, HasSubstr("g28-home"));
  plan_for("fanuc", "none");
  EXPECT_THAT(made.program, HasSubstr("M5\nM30"));
  plan_for("marlin", "home");
  EXPECT_EQ(made.exit_code, 2);
  EXPECT_THAT(made.err, HasSubstr("--end-position: marlin has no home to go to"));
  plan_for("fanuc", "there");
  EXPECT_EQ(made.exit_code, 2);
  EXPECT_THAT(made.err, HasSubstr("'there' is unknown; use home, none, or X,Y in mm"));
}

TEST(EndPositionOption, OfAJob) {
  Planned made;
  made.folder.file("pocket.json", kPocket);
  const auto plan_with = [&](const std::string& end) {
    plan(made,
         made.folder.file("job.toml",
                          "[part]\nfile = \"pocket.json\"\n[[tool]]\nnumber = 1\ndiameter = 6\n[output]\n"
                          "post = \"fanuc\"\nend_position = " +
                              end + "\n"),
         {});
  };
  plan_with("[60, 10]");
  EXPECT_THAT(made.program, HasSubstr("X60. Y10.\nG91 G28 Z0.\nG90\nM30")) << made.err;
  const std::string by_list = made.program;
  plan_with("\"60,10\"");
  EXPECT_EQ(made.program, by_list);
  plan_with("\"home\"");
  EXPECT_THAT(made.program, HasSubstr("G91 G28 Z0.\nG28 X0. Y0.\nG90\nM30"));
  plan_with("\"there\"");
  EXPECT_EQ(made.exit_code, 2);
  EXPECT_THAT(made.err,
              HasSubstr("job.toml:8: end_position: 'there' is unknown; use home, none, or X,Y in mm"));
}

TEST(EndPositionOption, OfOneSetUpOfSeveral) {
  const ScratchFolder folder;
  folder.file("one.json", kPocket);
  folder.file("two.json", R"({"units": "mm", "depth": 4, "outer": [[0,0],[30,0],[30,20],[0,20]]})");
  const auto job = folder.file(
      "job.toml",
      "[stock]\nx = [-5, 35]\ny = [-5, 25]\nz = [-9, 0]\n[plan]\nstrategy = \"zigzag\"\n"
      "[[tool]]\nnumber = 1\ndiameter = 6\n[output]\npost = \"haas\"\n"
      "[[setup]]\nfile = \"one.json\"\n[[setup]]\nfile = \"two.json\"\nend_position = \"home\"\n");
  const auto result = run_clearcut({"plan", job, "-o", folder.path("a.nc"), "--quiet"});
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_THAT(read_file(folder.path("a-1.nc")), Not(HasSubstr("G53 G0 X0. Y0.")));
  EXPECT_THAT(read_file(folder.path("a-2.nc")), HasSubstr("G53 G0 Z0.\nG53 G0 X0. Y0.\nM30"));
}

}  // namespace
}  // namespace clearcut
