// Klartext with labels and Q parameters.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "read/gcode/test_told_program.h"

namespace clearcut::read::gcode {
namespace {

using ::testing::HasSubstr;

std::string program_of(const std::string& blocks) {
  return "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S1000\n2 L X+0 Y+0 Z+5 R0 FMAX M3\n" + blocks +
         "\n99 END PGM A MM\n";
}
std::string ends(const std::string& blocks) {
  std::string told;
  const Program read = read_gcode(program_of(blocks), "test.ngc");
  for (const Section& section : read.toolpath.sections)
    for (const Move& move : section.moves)
      if (!is_rapid(move.kind)) told += "|" + trimmed(move.path.to.x, 3) + " " + trimmed(move.path.to.y, 3);
  return told;
}
std::string refused(const std::string& blocks) {
  return message_of(program_of(blocks));
}

TEST(KlartextLabels, PartsAreRepeated) {
  EXPECT_EQ(ends("LBL 1\nL IX+5 F100\nCALL LBL 1 REP 2"), "|5 0|10 0|15 0");
  EXPECT_EQ(ends("LBL 1\nL IX+5 F100\nCALL LBL 1 REP2/2").substr(0, 4), "|5 0");
}

TEST(KlartextLabels, SubprogramsEndAtLabelZero) {
  EXPECT_EQ(ends("CALL LBL 7\nL Y+3 F100\nCALL LBL \"SLOT\"\nL Z+50 FMAX M30\nLBL 7\nL IX+5 F100\nLBL 0\n"
                 "LBL \"SLOT\"\nL IX-1\nLBL 0"),
            "|5 0|5 3|4 3");
}

TEST(KlartextLabels, MovesOfSubprogramsKnowWhoCalledThem) {
  const Program read = read_gcode(
      program_of("CALL LBL 7\nL Y+3 F100\nL Z+50 FMAX M30\nLBL 7\nL IX+5 F100\nLBL 0"), "test.ngc");
  std::string told;
  std::size_t index = 0;
  for (const Section& section : read.toolpath.sections)
    for (const Move& move : section.moves) {
      const std::string* const calls = read.control.calls_at(index++);
      if (calls) told += std::to_string(move.line) + ": " + *calls;
    }
  EXPECT_EQ(told, "8: LBL 7 called in test.ngc:4");
}

TEST(KlartextLabels, ParametersAreComputed) {
  EXPECT_EQ(ends("FN 0: Q1 = +2\nFN 1: Q2 = +Q1 + +3\nFN 3: Q3 = +Q2 * -2\nFN 0: Q9 = +120\nL X+Q2 Y-Q3 "
                 "FQ9\nL X-Q1"),
            "|5 10|-2 10");
  EXPECT_EQ(ends("FN 0: Q1 = +0\nLBL 1\nFN 1: Q1 = +Q1 + +1\nL X+Q1 F100\nFN 12: IF +Q1 LT +3 GOTO LBL 1"),
            "|1 0|2 0|3 0");
}

TEST(KlartextLabels, LengthsAndAnglesOfSides) {
  EXPECT_EQ(ends("FN 0: Q1 = +3\nFN 8: Q2 = +Q1 LEN +4\nFN 13: Q3 = +Q1 ANG -3\nL X+Q2 Y+Q3 F100"), "|5 135");
  EXPECT_EQ(ends("FN 13: Q3 = -2 ANG +0\nL X+Q3 F100"), "|270 0");
}

TEST(KlartextLabels, ParametersAreSetInTheirOwnBlocks) {
  EXPECT_EQ(ends("Q1 = +4\nQ2=-Q1\nL X+Q1 Y+Q2 F100"), "|4 -4");
}

TEST(KlartextLabels, FormulasAreComputed) {
  EXPECT_EQ(ends("Q1 = 3\nQ2 = Q1 * SIN 30 + ( 4 - Q1 ) ^ 2\nL X+Q2 Y+Q1 F100"), "|2.5 3");
  EXPECT_EQ(ends("Q1 = 2 + 3 * 2 ^ 2 ^ 1 - 8 / 4 / 2\nQ2 = -Q1 + NEG SQ 2\nL X+Q1 Y+Q2 F100"), "|13 -17");
  EXPECT_EQ(ends("Q1 = INT 2.7 + FRAC -2.25 + ABS -3\nQ2 = ATAN 1 + SQRT ( 16 )\nL X+Q1 Y+Q2 F100"),
            "|4.75 49");
  EXPECT_EQ(ends("Q1 = COS 60 * 10 - LOG 1000 + LN EXP 2\nQ2 = PI * 0\nL X+Q1 Y+Q2 F100"), "|4 0");
}

TEST(KlartextLabels, FormulasThatAreNoneAreRefused) {
  EXPECT_THAT(refused("Q1 = 4 * "), HasSubstr("is not read in a formula"));
  EXPECT_THAT(refused("Q1 = -2 ^ 2"), HasSubstr("put its base in parentheses"));
  EXPECT_THAT(refused("Q1 = SGN 4"), HasSubstr("'SGN4' is not read in a formula"));
  EXPECT_THAT(refused("Q1 = ( 4 + 2"), HasSubstr("lacks its ')'"));
  EXPECT_THAT(refused("Q1 = 4 / 0"), HasSubstr("no control holds"));
  EXPECT_THAT(refused("Q1 = SQRT -4"), HasSubstr("no control holds"));
  EXPECT_THAT(refused("Q1 = Q7 + 1"), HasSubstr("Q7 is read before the program sets it"));
  EXPECT_THAT(refused("Q1 = " + std::string(900, '(') + "1"), HasSubstr("nests too deep"));
}

TEST(KlartextWords, ThatChangeMovesAreRefused) {
  for (const std::string m : {"89", "97", "98", "103 F20", "118 X1 Y1", "136"})
    EXPECT_THAT(refused("L X+5 F100 M" + m), HasSubstr("is not read; post the program without it")) << m;
  EXPECT_THAT(refused("M118 X1 Y1"), HasSubstr("M118, which lets the handwheel move beside the path"));
  EXPECT_THAT(refused("L X+5 FZ0.1"), HasSubstr("FZ states the feed for a turn or a tooth"));
}

TEST(KlartextWords, ToolsStandAlongZ) {
  EXPECT_THAT(refused("TOOL CALL 2 Y S1000"), HasSubstr("the tool stands along Y"));
}

TEST(KlartextWords, OfOlderControlsMayBeEmpty) {
  EXPECT_EQ(ends("L X+5 R F100 M\nL Y+50 R F MAX M\nL X+7 R F100 M"), "|5 0|7 50");
}

TEST(KlartextDatum, IsShifted) {
  EXPECT_EQ(ends("CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+10\nCYCL DEF 7.2 Y+5\nL X+1 Y+1 F100\nL "
                 "IX+2\nCYCL DEF 7.0 "
                 "DATUM SHIFT\nCYCL DEF 7.1 IX+10\nL X+1\nCYCL DEF 7.1 X+0\nCYCL DEF 7.2 Y+0\nL X+1 Y+1"),
            "|11 6|13 6|21 6|1 1");
  EXPECT_EQ(ends("TRANS DATUM AXIS X+10 Y+5\nL X+1 F100\nL Y+1\nTRANS DATUM RESET\nL X+1 Y+1"),
            "|11 0|11 6|1 1");
  EXPECT_EQ(ends("FN 0: Q1 = +0\nLBL 1\nTRANS DATUM AXIS X+Q1\nL X+1 Y+0 F100\nFN 1: Q1 = +Q1 + +10\nFN 12: "
                 "IF +Q1 LT "
                 "+30 GOTO LBL 1"),
            "|1 0|11 0|21 0");
}

TEST(KlartextDatum, AxesAreTurned) {
  EXPECT_EQ(
      ends(
          "CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+90\nL X+10 Y+0 F100\nL IX+5\nCC X+0 Y+0\nLP PR+10 PA+0\n"
          "CYCL DEF 10.1 ROT+0\nL X+1 Y+1"),
      "|0 10|0 15|0 10|1 1");
  EXPECT_EQ(ends("TRANS DATUM AXIS X+10\nCYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+90\nL X+5 Y+0 F100\nCC "
                 "X+0 Y+0\nC X+0 "
                 "Y+5 DR+"),
            "|10 5|5 0");
}

TEST(KlartextTolerance, OfNothingIsNone) {
  const auto path_after = [](const std::string& tolerance) {
    return read_gcode(program_of("CYCL DEF 32.0 TOLERANCE\nCYCL DEF 32.1" + tolerance + "\nL X+5 F100"),
                      "test.ngc")
        .control.spans.back()
        .state.path;
  };
  EXPECT_EQ(path_after(" T0.01"), (PathControl{PathMode::kTolerance, 0.01, std::nullopt}));
  for (const char* none : {"", " T0", " T0.000"})
    EXPECT_EQ(path_after(none).mode, PathMode::kUnstated) << none;
}

TEST(KlartextFeeds, FautoIsTheFeedOfTheToolsCall) {
  const auto feeds = [](const std::string& blocks) {
    std::string told;
    for (const Section& section : read_gcode(program_of(blocks), "test.ngc").toolpath.sections)
      for (const Move& move : section.moves)
        if (!is_rapid(move.kind)) told += "|" + trimmed(move.feed.mm_per_min(), 3);
    return told;
  };
  EXPECT_EQ(feeds("TOOL CALL 1 Z S1000 F700\nL X+1 F100\nL X+2\nL X+3 FAUTO"), "|100|100|700");
  EXPECT_THAT(refused("L X+1 FAUTO"), HasSubstr("FAUTO takes the feed of TOOL CALL"));
}

TEST(KlartextDatum, HolesFollowIt) {
  const std::string hole =
      "CYCL DEF 200 DRILLING ~ Q200=+2 ~ Q201=-5 ~ Q206=+100 ~ Q202=+5 ~ Q210=+0 ~ Q203=+0 ~ Q204=+10 ~ "
      "Q211=+0\n";
  const auto lowest = [&](const std::string& before) {
    double z = 100;
    for (const Section& section :
         read_gcode(program_of(before + hole + "CYCL CALL"), "test.ngc").toolpath.sections)
      for (const Move& move : section.moves) z = std::min(z, move.z_to);
    return z;
  };
  EXPECT_EQ(lowest(""), -5);
  EXPECT_EQ(lowest("TRANS DATUM AXIS Z-3\n"), -8);
}

TEST(KlartextDatum, WhatIsNotReadIsNamed) {
  EXPECT_THAT(refused("CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 #5"),
              HasSubstr("'#5' shifts the datum by a table"));
  EXPECT_THAT(refused("TRANS DATUM TABLE TABLINE1"),
              HasSubstr("TRANS DATUM AXIS and TRANS DATUM RESET alone"));
  EXPECT_THAT(refused("CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+30\nTRANS DATUM AXIS X+5"),
              HasSubstr("while cycle 10 turns the axes"));
  EXPECT_THAT(refused("CYCL DEF 8.0 MIRROR IMAGE\nCYCL DEF 8.1 X"), HasSubstr("cycle 8 is not read"));
}

TEST(KlartextLabels, WhatIsNotKnownIsRefused) {
  EXPECT_THAT(refused("L X+Q5 F100"), HasSubstr("test.ngc:4: Q5 is read before the program sets it"));
  EXPECT_THAT(refused("CALL LBL 4"), HasSubstr("test.ngc:4: there is no LBL 4"));
  EXPECT_THAT(refused("LBL 1\nCALL LBL 1"), HasSubstr("over 19 subprograms within each other"));
  EXPECT_THAT(refused("LBL 1\nFN 9: IF +1 EQU +1 GOTO LBL 1"), HasSubstr("a loop that never ends"));
  EXPECT_THAT(refused("FN 14: ERROR = 1000"), HasSubstr("stops here with an error of its own"));
  EXPECT_THAT(refused("FN 18: SYSREAD Q1 = ID20"), HasSubstr("FN 18 is not read"));
}

}  // namespace
}  // namespace clearcut::read::gcode
