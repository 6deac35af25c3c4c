// Witnesses and the independent checker: docs/claim.md, docs/witness.md. Wrong ones are made by tests/wrong_witnesses/wrong.py.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>

#include "base/file.h"
#include "model/dialect.h"
#include "support/command.h"
#include "support/controllers.h"

namespace clearcut::test_support {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

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

/// All but Okuma, whose G15 H and G56 H the checker does not claim.
std::vector<std::string> claimed_controllers() {
  std::vector<std::string> names = controller_names();
  std::erase(names, "okuma");
  return names;
}

class WitnessOf : public ::testing::TestWithParam<std::string> {};

TEST_P(WitnessOf, AProgramForEachControllerIsAccepted) {
  const ScratchFolder folder;
  EXPECT_EQ(plan_bracket(folder, {"--post", GetParam()}).exit_code, 0);
  const CommandResult checked = check_bracket(folder, "--diameter 6");
  EXPECT_EQ(checked.exit_code, 0);
  EXPECT_THAT(checked.out, HasSubstr("a flat cutter of diameter 6.0 mm"));
}

INSTANTIATE_TEST_SUITE_P(Controllers, WitnessOf, ::testing::ValuesIn(claimed_controllers()));

TEST(Witness, OfAControllerThatIsNotClaimedIsSaidToBeMissing) {
  const ScratchFolder folder;
  const CommandResult planned = plan_bracket(folder, {"--post", "okuma"});
  EXPECT_EQ(planned.exit_code, 1);
  EXPECT_THAT(planned.out + planned.err, HasSubstr("NO WITNESS"));
  EXPECT_THAT(planned.out + planned.err, HasSubstr("G15 is not claimed"));
}

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
}

TEST(Witness, IsAboutTheOutlineOfWhatWasPlannedWhereTheFileIsNone) {
  const ScratchFolder folder;
  const std::string program = folder.path("f.nc"), witness = folder.path("f.ccw");
  const CommandResult deeper = plan_bracket(folder, {"--depth", "4"});
  EXPECT_EQ(deeper.exit_code, 0);
  EXPECT_THAT(deeper.out, Not(HasSubstr("NOT PROVED")));
  EXPECT_TRUE(fs::exists(folder.path("b.ccw.json")));
  const CommandResult drawing = run_clearcut({"plan", CLEARCUT_SOURCE_DIR "/examples/bracket.dxf", "--tool",
                                              "endmill:6", "-o", program, "--witness", witness, "--quiet"});
  EXPECT_EQ(drawing.exit_code, 0);
  EXPECT_EQ(shell(folder, kChecker + " " + program + " " + witness + ".json " + witness).exit_code, 0);
}

TEST(Witness, OfTheFishheadHasAllFeaturesAndBothTools) {
  const ScratchFolder folder;
  const std::string program = folder.path("f.nc"), witness = folder.path("f.ccw");
  const CommandResult planned = run_clearcut(
      {"plan", CLEARCUT_SOURCE_DIR "/examples/fishhead.p21", "-o", program, "--witness", witness, "--quiet"});
  EXPECT_EQ(planned.exit_code, 0) << planned.out;
  const CommandResult checked = shell(folder, kChecker + " " + program + " " + witness + ".json " + witness);
  EXPECT_EQ(checked.exit_code, 0);
  EXPECT_THAT(checked.out, HasSubstr("proven for T4, a flat cutter of diameter 40.0 mm"));
  EXPECT_THAT(checked.out, HasSubstr("feature 9 (PLANAR_FACE4) all of it"));
  EXPECT_THAT(checked.out, Not(HasSubstr("not proven")));
  // By contours 195 kB; the covers of the faces, which turn more often, need more tiles. 2 MB packed are allowed.
  EXPECT_LT(fs::file_size(witness), 400'000);
}

/// A circle in a program that leaves 9.45 of the 10 micrometres that may be left: blending takes half of one, so that the chords of the
/// wall have 50 nm.
TEST(Witness, NearTheBoundIsFoundWithShorterChords) {
  const ScratchFolder folder;
  const auto circle = [&](const std::string& name, const std::string& radius) {
    return folder.file(
        name, R"({"units": "mm", "depth": 2, "outer": [[)" + radius + ", 0, 1], [-" + radius + ", 0, 1]]}");
  };
  const std::string wanted = circle("wanted.json", "10"), made = circle("made.json", "9.99055"),
                    program = folder.path("c.nc"), witness = folder.path("c.ccw");
  run_clearcut({"plan", made, "--tool", "endmill:6", "-o", program, "--quiet"});
  run_clearcut({"verify", program, "--part", wanted, "--tool", "endmill:6", "--witness", witness, "--quiet"});
  const CommandResult checked = shell(folder, kChecker + " " + program + " " + wanted + " " + witness);
  EXPECT_EQ(checked.exit_code, 0) << checked.out;
  EXPECT_EQ(
      shell(folder, kChecker + " " + program + " " + wanted + " " + witness + " --uncut 0.0099").exit_code,
      1);
}

TEST(Witness, OfABossADeeperPocketAndAHoleInAFloor) {
  const ScratchFolder folder;
  const std::string part = folder.file(
                        "b.json",
                        R"({"units": "mm", "stock": {"x": [0, 60], "y": [0, 50], "z": [-20, 0]}, "pockets": [
{"name": "around", "kind": "closed_pocket", "depth": 6, "outer": [[5, 5], [55, 5], [55, 45], [5, 45]],
 "islands": [[[20, 18], [36, 18], [36, 32], [20, 32]]]},
{"name": "boss", "kind": "step", "depth": 2, "outer": [[20, 18], [36, 18], [36, 32], [20, 32]],
 "allowed": [{"outer": [[5, 5], [55, 5], [55, 45], [5, 45]]}]},
{"name": "deeper", "kind": "closed_pocket", "top": -6, "depth": 4, "outer": [[40, 20], [53, 20], [53, 38], [40, 38]]},
{"name": "hole", "kind": "round_hole", "top": -6, "depth": 9, "outer": [[16, 10, 1], [8, 10, 1]]}]})"),
                    program = folder.path("b.nc"), witness = folder.path("b.ccw");
  run_clearcut({"plan", part, "--tool", "endmill:5", "-o", program, "--witness", witness, "--quiet"});
  const CommandResult checked = shell(folder, kChecker + " " + program + " " + part + " " + witness);
  EXPECT_EQ(checked.exit_code, 0) << checked.out;
  EXPECT_THAT(checked.out, HasSubstr("feature 1 (boss) all of it"));
  EXPECT_THAT(checked.out, HasSubstr("feature 2 (deeper) what a cutter"));
  EXPECT_THAT(checked.out, HasSubstr("feature 3 (hole) all of it"));
}

/// Two drilled holes and a pocket with another tool.
const char kHolesAndPocket[] =
    R"({"units": "mm", "stock": {"x": [0, 60], "y": [0, 40], "z": [-10, 0]}, "pockets": [
{"name": "h1", "kind": "round_hole", "depth": 6, "outer": [[13, 10, 1], [7, 10, 1]]},
{"name": "h2", "kind": "round_hole", "depth": 6, "outer": [[33, 10, 1], [27, 10, 1]]},
{"name": "p", "kind": "closed_pocket", "depth": 4, "outer": [[5, 20], [50, 20], [50, 35], [5, 35]]}]})";

class WitnessOfHoles : public ::testing::TestWithParam<std::string> {};

TEST_P(WitnessOfHoles, CountsCyclesAsDiscs) {
  const ScratchFolder folder;
  const std::string part = folder.file("t.json", kHolesAndPocket), program = folder.path("t.nc");
  const CommandResult planned =
      run_clearcut({"plan", part, "--tool", "endmill:5", "--tool", "drill:6", "-o", program, "--post",
                    GetParam(), "--witness", folder.path("t.ccw"), "--quiet"});
  const bool is_clean = test_support::controller_named(GetParam()).of_tools.empty();
  EXPECT_EQ(planned.exit_code, is_clean ? 0 : 1) << planned.out;
  const std::string check = kChecker + " " + program + " " + part + " " + folder.path("t.ccw");
  const CommandResult checked = shell(folder, check);
  EXPECT_EQ(checked.exit_code, 0) << checked.out;
  EXPECT_THAT(checked.out, HasSubstr("a drill of diameter 6.0 mm"));
  EXPECT_THAT(checked.out, HasSubstr("feature 1 (h2) all of it"));
}

INSTANTIATE_TEST_SUITE_P(Controllers, WitnessOfHoles, ::testing::ValuesIn(claimed_controllers()));

TEST(Witness, NamesTheHoleThatIsNotDrilledToItsDepth) {
  const ScratchFolder folder;
  const std::string part = folder.file("t.json", kHolesAndPocket), program = folder.path("t.nc");
  run_clearcut({"plan", part, "--tool", "endmill:5", "--tool", "drill:6", "-o", program, "--quiet"});
  std::string text = read_file(program);
  const std::size_t at = text.rfind("Z-6 R1");
  ASSERT_NE(at, std::string::npos);
  folder.file("t.nc", text.replace(at, 6, "Z-5.99 R1"));
  const CommandResult proved = run_clearcut(
      {"verify", program, "--part", part, "--tool", "endmill:5", "--tool", "drill:6", "--prove"});
  EXPECT_EQ(proved.exit_code, 1);
  EXPECT_THAT(proved.out, HasSubstr("not proven to be cut: feature 1 (h2)"));
  EXPECT_THAT(proved.out, HasSubstr("NOT PROVED: h2: "));
}

TEST(Witness, ADrillsPointStaysAboveTheFloorOfABlindHole) {
  const ScratchFolder folder;
  const std::string part = folder.file("t.json", kHolesAndPocket), program = folder.path("t.nc");
  run_clearcut({"plan", part, "--tool", "endmill:5", "--tool", "drill:6", "-o", program, "--quiet"});
  std::string text = read_file(program);
  const std::size_t at = text.rfind("Z-6 R1");
  ASSERT_NE(at, std::string::npos);
  folder.file("t.nc", text.replace(at, 6, "Z-6.05 R1"));
  const CommandResult proved = run_clearcut(
      {"verify", program, "--part", part, "--tool", "endmill:5", "--tool", "drill:6", "--prove"});
  EXPECT_EQ(proved.exit_code, 1);
  EXPECT_THAT(proved.out, HasSubstr("goes below all floors"));
}

TEST(Checker, ACycleWithoutAFeedIsARapidIntoTheHole) {
  const ScratchFolder folder;
  const std::string part = folder.file("t.json", kHolesAndPocket), program = folder.path("t.nc");
  run_clearcut({"plan", part, "--tool", "endmill:5", "--tool", "drill:6", "-o", program, "--quiet"});
  std::string text = read_file(program);
  const std::size_t at = text.rfind("Z-6 R1");
  ASSERT_NE(at, std::string::npos);
  folder.file("t.nc", text.replace(at, 6, "Z-6 R-6"));
  const CommandResult proved = run_clearcut(
      {"verify", program, "--part", part, "--tool", "endmill:5", "--tool", "drill:6", "--prove"});
  EXPECT_EQ(proved.exit_code, 1);
  EXPECT_THAT(proved.out, HasSubstr("NOT PROVED: "));
  EXPECT_THAT(proved.out, Not(HasSubstr("proved by witness")));
}

TEST(Checker, DoesNotTakeACutterThatIsMadeReadyForTheOneInTheSpindle) {
  const ScratchFolder folder;
  plan_bracket(folder);
  std::string program = read_file(folder.path("b.nc"));
  const std::size_t at = program.find("T1 M6");
  ASSERT_NE(at, std::string::npos);
  folder.file("b.nc", program.insert(at, "T1\n"));
  const CommandResult checked = check_bracket(folder);
  EXPECT_EQ(checked.exit_code, 2);
  EXPECT_THAT(checked.out, HasSubstr("M6 after a T word without it"));
}

TEST(Certificate, ListsWhatIsProvedAndNoMore) {
  const ScratchFolder folder;
  run_clearcut({"plan", CLEARCUT_SOURCE_DIR "/examples/fishhead_sloped.p21", "-o", folder.path("s.nc"),
                "--witness", folder.path("s.ccw"), "--certificate", folder.path("s.cert.json"), "--quiet"});
  const auto certificate = nlohmann::json::parse(read_file(folder.path("s.cert.json")));
  const auto proved = certificate.at("proved").get<std::vector<std::string>>();
  EXPECT_THAT(proved, Contains("POCKET1"));
  EXPECT_THAT(proved, Not(Contains("POCKET3")));
  EXPECT_EQ(certificate.at("proof").at("not_proved").size(), 1u);
  EXPECT_EQ(run_clearcut({"plan", kBracket, "--tool", "endmill:6", "-o", folder.path("b.nc"), "--certificate",
                          folder.path("b.cert.json"), "--quiet"})
                .exit_code,
            0);
  EXPECT_FALSE(nlohmann::json::parse(read_file(folder.path("b.cert.json"))).contains("proved"));
}

TEST(Witness, ProvesNothingOfWhatNoCylinderMakes) {
  const ScratchFolder folder;
  const CommandResult planned =
      run_clearcut({"plan", CLEARCUT_SOURCE_DIR "/examples/fishhead_sloped.p21", "-o", folder.path("s.nc"),
                    "--witness", folder.path("s.ccw"), "--quiet"});
  EXPECT_EQ(planned.exit_code, 1);
  EXPECT_THAT(planned.out, HasSubstr("NOT PROVED: "));
  const std::string check =
      kChecker + " " + folder.path("s.nc") + " " + folder.path("s.ccw.json") + " " + folder.path("s.ccw");
  const CommandResult whole = shell(folder, check);
  EXPECT_EQ(whole.exit_code, 1);
  EXPECT_THAT(whole.out, HasSubstr("refused: not all is proven"));
  EXPECT_THAT(whole.out, HasSubstr("not proven to be cut: feature"));
  EXPECT_EQ(shell(folder, check + " --partial").exit_code, 0);
}

TEST(Witness, ProvesNothingOfAFloorThatMeetsItsWallsInAFillet) {
  const ScratchFolder folder;
  const std::string part = folder.file(
      "f.json",
      R"({"units": "mm", "outer": [[0, 0], [30, 0], [30, 20], [0, 20]], "depth": 2, "floor_fillet": 1})");
  const CommandResult planned =
      run_clearcut({"plan", part, "--tool", "bullnose:6:corner=1", "--tool", "endmill:4", "-o",
                    folder.path("f.nc"), "--witness", folder.path("f.ccw")});
  EXPECT_THAT(planned.out, HasSubstr("its floor meets its walls in a fillet"));
  EXPECT_NE(planned.exit_code, 0);
}

TEST(Checker, ReadsNoPartThatMayMeanSomethingElse) {
  const ScratchFolder folder;
  plan_bracket(folder);
  const auto said = [&](const std::string& part) {
    return shell(folder, kChecker + " " + folder.path("b.nc") + " " + folder.file("p.json", part) + " " +
                             folder.path("b.ccw"))
        .out;
  };
  const std::string outer = R"("outer": [[0, 0], [9, 0], [9, 9]], "depth": 1)";
  // A stock without inside has no material anywhere.
  EXPECT_THAT(said(R"({"stock": {"x": [9, 0], "y": [0, 9], "z": [-9, 0]}, )" + outer + "}"),
              HasSubstr("a range that is empty"));
  // Units that stand beside a feature of a list hold for none.
  EXPECT_THAT(said(R"({"pockets": [{"units": "inch", )" + outer + "}]}"),
              HasSubstr("\"units\" is not claimed"));
}

TEST(Checker, CountsTheWaysThatBlendingTakesBelowTheTop) {
  const ScratchFolder folder;
  plan_bracket(folder);
  std::string program = read_file(folder.path("b.nc"));
  ASSERT_THAT(program, HasSubstr("G64 P0.0005"));
  const std::vector<std::string> verify{"verify", folder.path("b.nc"), "--part", kBracket,
                                        "--tool", "endmill:6",         "--prove"};
  const auto with = [&](const std::string& more) {
    std::string text = program;
    folder.file("b.nc", text.insert(text.rfind("M5"), more));
    return run_clearcut(verify).out;
  };
  EXPECT_THAT(with("G0 X-20 Y-20\nG1 Z0.001\nX-10\nG0 Z10\n"), HasSubstr("proved by witness"));
  EXPECT_THAT(with("G0 X-20 Y-20\nG1 Z0\nX-10\nG0 Z10\n"), HasSubstr("is outside of all features"));
}

/// A slot of 20 mm, 2 mm deep, cut in one pass after `entry`; then rapids along it, the first one as low as its floor.
CommandResult rapids_at_the_floor(const ScratchFolder& folder, const std::string& entry) {
  const std::string part = folder.file(
      "r.json", R"({"units": "mm", "outer": [[0, 0], [20, 0], [20, 6.01], [0, 6.01]], "depth": 2})");
  const std::string program = folder.file(
      "r.h", "0 BEGIN PGM R MM\n1 TOOL CALL 1 Z S1000\n2 L Z+10 R0 FMAX\n3 L X+3.005 Y+3.005 R0 FMAX\n" +
                 entry +
                 "4 L X+3.005 Z-2 F500\n5 L X+16.995 F500\n6 L X+3.005 R0 FMAX\n"
                 "7 L X+16.995 Z-1.9 R0 FMAX\n8 L Z+10 R0 FMAX\n9 M30\n10 END PGM R MM\n");
  return run_clearcut({"verify", program, "--part", part, "--tool", "endmill:6", "--prove"});
}

TEST(Checker, AHelixEndsAtItsHeight) {
  const ScratchFolder folder;
  const std::string plunge = "4 L Z-2 F500\n";
  EXPECT_THAT(rapids_at_the_floor(folder, plunge).out, HasSubstr("proved by witness"));
  const std::string helix = "4 L Z+0.1 F500\n4 L X+5 F500\n4 CC X+4.997 Y+3.005\n4 CP IPA-360 IZ-2.1 DR-\n";
  EXPECT_THAT(rapids_at_the_floor(folder, helix).out, HasSubstr("proved by witness"));
}

TEST(Checker, ARapidAsLowAsAFeedIsNotProvenWhereHeightsAreBlended) {
  const ScratchFolder folder;
  const CommandResult blended =
      rapids_at_the_floor(folder, "4 CYCL DEF 32.0 TOLERANCE\n4 CYCL DEF 32.1 T0.001\n4 L Z-2 F500\n");
  EXPECT_EQ(blended.exit_code, 1);
  EXPECT_THAT(blended.out, HasSubstr("feeds as low as the rapid do not count"));
}

TEST(Checker, AToleranceOfNothingIsNone) {
  const ScratchFolder folder;
  plan_bracket(folder);
  std::string program = read_file(folder.path("b.nc"));
  const std::size_t at = program.find("G64 P0.0005");
  ASSERT_NE(at, std::string::npos);
  folder.file("b.nc", program.replace(at, 11, "G64 P0"));
  const CommandResult checked = check_bracket(folder);
  EXPECT_EQ(checked.exit_code, 2);
  EXPECT_THAT(checked.out, HasSubstr("a tolerance of nothing"));
}

TEST(Witness, VerifyProvesByTheCheckerAlone) {
  const ScratchFolder folder;
  plan_bracket(folder);
  const std::vector<std::string> verify{"verify", folder.path("b.nc"), "--part", kBracket,
                                        "--tool", "endmill:6",         "--prove"};
  const CommandResult proved = run_clearcut(verify);
  EXPECT_EQ(proved.exit_code, 0);
  EXPECT_THAT(proved.out, HasSubstr("proved by witness (checked in "));
  const std::string program = read_file(folder.path("b.nc"));
  const std::regex along_the_wall("\nY6\\.983\n");
  ASSERT_TRUE(std::regex_search(program, along_the_wall));
  folder.file("b.nc", std::regex_replace(program, along_the_wall, "\nY10.983\n"));
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
  EXPECT_THAT(said.out, HasSubstr("300 wrong witnesses of 47 kinds, 0 not refused"));
}

/// Words that a control carries out otherwise than a reader of plain moves might: each is hidden in a program whose witness is right.
TEST(Checker, RefusesHiddenWords) {
  const ScratchFolder folder;
  const std::string part = folder.file("t.json", kHolesAndPocket);
  for (const std::string control : {"linuxcnc", "grbl", "fanuc", "heidenhain", "marlin", "siemens"})
    run_clearcut({"plan", part, "--tool", "endmill:5", "--tool", "drill:6", "-o",
                  folder.path(control + ".nc"), "--post", control, "--witness", folder.path(control + ".ccw"),
                  "--quiet"});
  const CommandResult said =
      shell(folder, "python3 " + kWrong + "/words.py " + kChecker + " " + part + " " + folder.path(""));
  EXPECT_EQ(said.exit_code, 0) << said.out;
  EXPECT_THAT(said.out, HasSubstr("33 programs with hidden words, 0 not refused for their reason"));
}

TEST(Checker, StatesTheEngagementOfEachLevelFeed) {
  const ScratchFolder folder;
  plan_bracket(folder, {"--strategy", "adaptive"});
  const CommandResult checked = check_bracket(folder, "--each");
  EXPECT_THAT(checked.out, HasSubstr("C4 engagement: at most "));
  EXPECT_TRUE(std::regex_search(checked.out, std::regex("\n  line [0-9]+ [0-9.]+\n")));
  EXPECT_EQ(check_bracket(folder, "--engagement 180").exit_code, 0);
  // Slots have no rim: nobody says that they are engaged by less than half a turn.
  EXPECT_THAT(check_bracket(folder, "--engagement 179.9").out, HasSubstr("is a level feed without a rim"));
  std::string rest = checked.out;
  const CommandResult less = check_bracket(folder, "--engagement 3");
  EXPECT_EQ(less.exit_code, 1);
  EXPECT_TRUE(
      std::regex_search(less.out, std::regex("line [0-9]+ of the program has an engagement of up to")));
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
