// Jobs of several set-ups as a user plans and verifies them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "post/post.h"
#include "read/step_solid/solid_model.h"
#include "support/command.h"
#include "support/controllers.h"
#include "support/golden.h"
#include "support/programs.h"

namespace clearcut {
namespace {

using test_support::run_clearcut;
using test_support::ScratchFolder;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kExample = CLEARCUT_SOURCE_DIR "/examples/two_sided.toml";

std::string line_box(const std::string& layer, double x0, double y0, double x1, double y1) {
  std::string text = "0\nLWPOLYLINE\n8\n" + layer + "\n90\n4\n70\n1\n";
  const double corners[4][2] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  for (const auto& corner : corners)
    text += "10\n" + std::to_string(corner[0]) + "\n20\n" + std::to_string(corner[1]) + "\n";
  return text;
}

std::string drawing(const std::string& entities) {
  return "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + entities +
         "0\nENDSEC\n0\nEOF\n";
}

const std::string kTop =
    drawing(line_box("STOCK_D12", 0, 0, 80, 60) + line_box("POCKET_D12", 10, 10, 40, 30));
const std::string kUnder =
    drawing(line_box("POCKET_D12", 10, 30, 40, 50) + line_box("POCKET_D4", 50, 10, 70, 30));
const std::string kTool = "[[tool]]\nnumber = 1\nkind = \"endmill\"\ndiameter = 6\n";
const std::string kSetups =
    "[[setup]]\nname = \"top\"\nfile = \"top.dxf\"\n"
    "[[setup]]\nname = \"underside\"\nfile = \"under.dxf\"\nup = \"-Z\"\nwork_offset = \"G55\"\n";

struct Drawn {
  ScratchFolder folder;
  std::string job;
  explicit Drawn(const std::string& setups = kSetups) {
    folder.file("top.dxf", kTop);
    folder.file("under.dxf", kUnder);
    job = folder.file("job.toml", setups + kTool);
  }
};

TEST(Setups, AreAllInWhatInfoSays) {
  const Drawn drawn;
  const auto json = nlohmann::json::parse(run_clearcut({"info", drawn.job, "--json"}).out);
  ASSERT_EQ(json.at("setups").size(), 2U);
  const auto second = nlohmann::json::parse(run_clearcut({"info", drawn.job, "--setup", "2", "--json"}).out);
  EXPECT_EQ(json["setups"][1], second);
  EXPECT_NE(json["setups"][0], second);
  EXPECT_THAT(run_clearcut({"info", drawn.job}).out, HasSubstr("\nset-up 2 of 2\n"));
}

TEST(Setups, EachHasItsProgramAndAllHaveOneVerdict) {
  const Drawn drawn;
  const auto result =
      run_clearcut({"plan", drawn.job, "-o", drawn.folder.path("part.ngc"), "--certificate",
                    drawn.folder.path("part.json"), "--setup-sheet", drawn.folder.path("sheet.html")});
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_THAT(result.out, HasSubstr("2 set-ups, verdict: CLEAN"));
  EXPECT_THAT(read_file(drawn.folder.path("part-1.ngc")), HasSubstr("G54"));
  const std::string second = read_file(drawn.folder.path("part-2.ngc"));
  EXPECT_THAT(second, HasSubstr("G55"));
  EXPECT_THAT(second, HasSubstr("SET-UP 2 OF 2 UNDERSIDE"));
  EXPECT_THAT(read_file(drawn.folder.path("part-2.json")), HasSubstr("CLEAN"));
  const std::string sheet = read_file(drawn.folder.path("sheet.html"));
  EXPECT_THAT(sheet, HasSubstr("set-up 1 of 2 top"));
  EXPECT_THAT(sheet, HasSubstr("set-up 2 of 2 underside"));
  EXPECT_THAT(sheet, HasSubstr("Zero, G55"));
  // What went through from above is not cut again.
  EXPECT_THAT(result.err, HasSubstr("what it cut through is carried"));
  EXPECT_THAT(result.err, HasSubstr("nothing is cut"));
}

TEST(Setups, ProgramsHaveNumbersOfTheirOwn) {
  const ScratchFolder folder;
  const std::string program = folder.path("part.nc");
  const auto first_lines = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{"plan", kExample, "--post", "fanuc", "-o", program, "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(run_clearcut(words).exit_code, 0);
    return read_file(folder.path("part-1.nc")).substr(2, 5) + " " +
           read_file(folder.path("part-2.nc")).substr(2, 5);
  };
  EXPECT_EQ(first_lines({}), "O0001 O0002");
  EXPECT_EQ(first_lines({"--program-number", "70"}), "O0070 O0071");
}

TEST(Setups, ALaterProgramIsVerifiedOnWhatTheOnesBeforeLeave) {
  const Drawn drawn;
  ASSERT_EQ(run_clearcut({"plan", drawn.job, "-o", drawn.folder.path("part.ngc")}).exit_code, 0);
  const std::string one = drawn.folder.path("part-1.ngc"), two = drawn.folder.path("part-2.ngc");
  EXPECT_EQ(run_clearcut({"verify", one, "--part", drawn.job, "--setup", "1"}).exit_code, 0);
  const auto right =
      run_clearcut({"verify", two, "--part", drawn.job, "--setup", "2", "--earlier-setup", one});
  EXPECT_EQ(right.exit_code, 0) << right.out << right.err;
  // What is open about the first program is open about what rests on it.
  std::string elsewhere = read_file(one);
  for (std::size_t at = 0; (at = elsewhere.find("G54", at)) != std::string::npos;)
    elsewhere.replace(at, 3, "G56");
  const auto open = run_clearcut({"verify", two, "--part", drawn.job, "--setup", "2", "--earlier-setup",
                                  drawn.folder.file("elsewhere.ngc", elsewhere), "--quiet"});
  EXPECT_THAT(open.out, HasSubstr("condition g56: in the program of set-up 1: "));
  std::string standing = read_file(one);
  standing.erase(standing.find("M3 S"), 2);
  standing.replace(standing.find("M5"), 2, "M3\nM5");
  const auto faulty = run_clearcut({"verify", two, "--part", drawn.job, "--setup", "2", "--earlier-setup",
                                    drawn.folder.file("standing.ngc", standing), "--quiet"});
  EXPECT_THAT(faulty.out, HasSubstr("spindle off: in the program of set-up 1: "));
  // The first program's through cut is missing: what it would have taken is left.
  std::string shallow = read_file(one);
  for (std::size_t at = 0; (at = shallow.find("Z-12", at)) != std::string::npos;)
    shallow.replace(at, 4, "Z-11");
  const std::string wrong = drawn.folder.file("wrong.ngc", shallow);
  const auto left =
      run_clearcut({"verify", two, "--part", drawn.job, "--setup", "2", "--earlier-setup", wrong});
  EXPECT_EQ(left.exit_code, 1) << left.out;
  EXPECT_THAT(left.out, HasSubstr("nothing is cut"));
}

TEST(Setups, WhatIsNotSaidIsAskedFor) {
  const Drawn drawn;
  ASSERT_EQ(run_clearcut({"plan", drawn.job, "-o", drawn.folder.path("part.ngc")}).exit_code, 0);
  const std::string two = drawn.folder.path("part-2.ngc");
  const auto refused = [&](const std::vector<std::string>& arguments) {
    const auto result = run_clearcut(arguments);
    EXPECT_EQ(result.exit_code, 2) << result.out;
    return result.err;
  };
  EXPECT_THAT(refused({"verify", two, "--part", drawn.job}), HasSubstr("--setup 1"));
  EXPECT_THAT(refused({"verify", two, "--part", drawn.job, "--setup", "2"}), HasSubstr("--earlier-setup"));
  EXPECT_THAT(refused({"verify", two, "--part", drawn.job, "--setup", "3"}), HasSubstr("has 2"));
  EXPECT_THAT(refused({"plan", drawn.job, "-o", "-"}), HasSubstr("name a file"));
}

TEST(Setups, WhatCannotBeIsRefusedWithItsLine) {
  const auto refused = [](const std::string& setups) {
    const Drawn drawn(setups);
    const auto result = run_clearcut({"plan", drawn.job, "-o", drawn.folder.path("part.ngc")});
    EXPECT_EQ(result.exit_code, 2) << result.out;
    EXPECT_EQ(drawn.folder.names().size(), 3u) << "nothing is written";
    return result.err;
  };
  EXPECT_THAT(refused(kSetups + "uq = 1\n"), HasSubstr("uq"));
  EXPECT_THAT(refused(kSetups + "turn = 30\n"), HasSubstr("aslant"));
  EXPECT_THAT(refused(kSetups + "[setup.stock]\nx = [0, 70]\ny = [0, 60]\nz = [-12, 0]\n"),
              HasSubstr("70 x 60 x 12 mm"));
  EXPECT_THAT(refused(kSetups + "[[operation]]\nfeature = \"*\"\n"), HasSubstr("[[setup.operation]]"));
}

TEST(Setups, AZeroCanBeACornerTheMiddleOrAPoint) {
  const Drawn drawn("[part]\nfile = \"top.dxf\"\norigin = \"centre\"\n");
  const std::string out = drawn.folder.path("part.ngc");
  const auto span = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"plan", drawn.job,       "-o",
                                       out,    "--setup-sheet", drawn.folder.path("s.html")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto result = run_clearcut(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return read_file(drawn.folder.path("s.html"));
  };
  EXPECT_THAT(span({}), HasSubstr("X -40 to 40 mm, Y -30 to 30 mm, Z -12 to 0 mm"));
  EXPECT_THAT(span({"--origin", "corner"}), HasSubstr("X 0 to 80 mm, Y 0 to 60 mm, Z -12 to 0 mm"));
  EXPECT_THAT(span({"--origin", "10,10,-12"}), HasSubstr("X -10 to 70 mm, Y -10 to 50 mm, Z 0 to 12 mm"));
}

/// The bracket of two sides, for all controls.
TEST(Setups, ASolidIsMilledFromBothSides) {
  if (!read::solids_can_be_read()) GTEST_SKIP() << "built without Open CASCADE";
  const ScratchFolder folder;
  for (const std::string& post : post::post_dialects()) {
    SCOPED_TRACE(post);
    const std::string ending = post::file_extension_of(post);
    std::vector<std::string> arguments{"plan", kExample, "-o", folder.path(post + ending), "--post", post};
    for (const std::string& name : test_support::controller_named(post).of_tools)
      arguments.insert(arguments.end(), {"--accept", name});
    const auto result = run_clearcut(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
    for (const char* number : {"-1", "-2"}) {
      const std::string name = post + number + ending;
      const std::string golden = "two_sided/" + post + number + test_support::ending_in_tests(post);
      EXPECT_EQ(
          test_support::difference_from_golden(golden, read_file(folder.path(name)), post == "linuxcnc"), "");
    }
  }
}

}  // namespace
}  // namespace clearcut
