// What each word does, told as short programs and the moves they make.
#include "read/gcode/gcode.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "read/gcode/test_told_program.h"

namespace clearcut::read::gcode {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kStart = "from 0 0 100\nrapid to 0 0 5";

TEST(GcodeStart, FirstMoveBeginsAtItsOwnCoordinatesAndHigh) {
  EXPECT_EQ(moves_of("G0 X3 Y4\nZ5\nG1 Z-1 F50\nM2"), "from 3 4 100\nrapid to 3 4 5\nplunge to 3 4 -1 F50");
  EXPECT_EQ(moves_of("G0 Z5\nX3 Y4\nG1 Z-1 F50\nM2"), "from 3 4 5\nplunge to 3 4 -1 F50");
  EXPECT_EQ(moves_of("G0 X3 Y4 Z150\nG1 Z-1 F50\nM2"), "from 3 4 150\nplunge to 3 4 -1 F50");
}

TEST(GcodeStart, CuttingFromAnUnknownPlaceIsACondition) {
  EXPECT_EQ(conditions("G21 G61 G0 Z5\nG1 Z-1 F50\nX5\nG0 Z5\nM2"), "start-position@2");
  EXPECT_EQ(conditions("G21 G61 G91 G0 X5 Y5\nM2"), "start-position@1");
  EXPECT_EQ(conditions("G21 G61 G0 Z5\nX1 Y1\nG1 Z-1 F50\nG0 Z5\nM2"), "");
}

TEST(GcodeStart, RapidsDownBeforeTheFirstPlaceAreKept) {
  EXPECT_EQ(moves_of("G21 G0 Z-2\nX3 Y4\nG1 X5 F50\nM2"), "from 3 4 100\nrapid to 3 4 -2\ncut to 5 4 -2 F50");
  EXPECT_EQ(conditions("G21 G61 G0 Z-2\nX3 Y4\nG1 X5 F50\nG0 Z5\nM2"), "start-position@2");
}

TEST(GcodeComments, ChangeNothing) {
  const std::string plain = "G21 G61 T3 M6\nG0 X0 Y0 Z5\nG1 Z-1 F50\nX20\nG0 Z5\nM2\n";
  const std::string told =
      "G21 G61 T3 (TOOL CHANGE T1: ENDMILL) M6\n;TOOL CHANGE T2: X\nG0 X0 Y0 Z5\n(END OF PROGRAM)\n"
      "(M2) (OPERATION 2: B)\nG1 Z-1 F50\n;END OF PROGRAM\nX20\nG0 Z5\nM2\n";
  EXPECT_EQ(moves_of(told), moves_of(plain));
  const Program program = read_gcode(told, "t");
  for (const Section& section : program.toolpath.sections) EXPECT_EQ(section.tool_number, 3);
  EXPECT_EQ(conditions(told), "");
}

TEST(GcodeLines, WordsAreModal) {
  EXPECT_EQ(from_origin("G1 Z-1\nX10\nY5 F200\nG0 Z5"),
            std::string(kStart) +
                "\nplunge to 0 0 -1 F100\ncut to 10 0 -1 F100\ncut to 10 5 -1 F200\nrapid to 10 5 5");
}

TEST(GcodeLines, KindsAreGuessedFromTheMotion) {
  EXPECT_EQ(from_origin("G1 Z1\nG1 X10 Z0\nG1 X20\nG1 Z5"),
            std::string(kStart) +
                "\nplunge to 0 0 1 F100\nramp to 10 0 0 F100\ncut to 20 0 0 F100\nretract to 20 0 5 F100");
}

TEST(GcodeLines, EveryNumberForm) {
  EXPECT_EQ(from_origin("g1x10.y.5\nX-.5Y+2\nX 1 0 . 2 5 Y-0\n  N20 x0010 (no) y1 ; no X7\nX1*71"),
            std::string(kStart) + "\ncut to 10 0.5 5 F100\ncut to -0.5 2 5 F100\ncut to 10.25 0 5 F100" +
                "\ncut to 10 1 5 F100\ncut to 1 1 5 F100");
}

TEST(GcodeLines, AnyLineEndAndByteOrderMark) {
  EXPECT_EQ(moves_of("\xEF\xBB\xBFG0 X0 Y0 Z5\r\nG1 X1 F100\rX2\n\nX3\r\nM30\r\n"),
            "from 0 0 100\nrapid to 0 0 5\ncut to 1 0 5 F100\ncut to 2 0 5 F100\ncut to 3 0 5 F100");
  EXPECT_EQ(
      read_gcode("G0 X0 Y0 Z5\r\nG1 X1 F100\rX2\n\nX3\r\nM30", "t").toolpath.sections[0].moves.back().line,
      5);
}

TEST(GcodeLines, InchAndIncremental) {
  EXPECT_EQ(moves_of("G20 G90 G0 X1 Y0\nZ0.1\nG91 G1 X1 F10\nX-0.5 Y0.5\nG90 G21\nX0 F100\nM2"),
            "from 25.4 0 100\nrapid to 25.4 0 2.54\ncut to 50.8 0 2.54 F254\ncut to 38.1 12.7 2.54 F254\n"
            "cut to 0 12.7 2.54 F100");
}

TEST(GcodeLines, LinuxCncReadsFeedsBeforeUnits) {
  EXPECT_EQ(moves_as(Dialect::kLinuxCnc, "G21 G0 X0 Y0 Z0\nG20 G1 X1 F100\nM2"),
            "\nrapid to 0 0 0\ncut to 25.4 0 0 F100");
  EXPECT_EQ(moves_as(Dialect::kGrbl, "G21 G0 X0 Y0 Z0\nG20 G1 X1 F100\nM2"),
            "\nrapid to 0 0 0\ncut to 25.4 0 0 F2540");
}

TEST(GcodeLines, FeedByTurnAndInverseTime) {
  EXPECT_EQ(from_origin("S1000 M3 G95 F0.1\nG1 X10\nG93 X20 F2\nG94 F50 X30"),
            std::string(kStart) + "\ncut to 10 0 5 F100\ncut to 20 0 5 F20\ncut to 30 0 5 F50");
}

TEST(GcodeArcs, CentreForm) {
  EXPECT_EQ(from_origin("G2 X10 Y0 I5\nG3 X20 Y0 I5 J0\nG90.1 G3 X30 Y0 I25 J0"),
            std::string(kStart) + "\ncut to 10 0 5 cw about 5 0 F100\ncut to 20 0 5 ccw about 15 0 F100" +
                "\ncut to 30 0 5 ccw about 25 0 F100");
}

TEST(GcodeArcs, RadiusForm) {
  EXPECT_EQ(from_origin("G3 X10 Y10 R10"), std::string(kStart) + "\ncut to 10 10 5 ccw about 0 10 F100");
  EXPECT_EQ(from_origin("G2 X10 Y10 R10"), std::string(kStart) + "\ncut to 10 10 5 cw about 10 0 F100");
}

TEST(GcodeArcs, LongArcsComeInTwoEdges) {
  EXPECT_EQ(from_origin("G3 X10 Y10 R-10"), std::string(kStart) + "\ncut to 10 10 5 ccw about 10 0 F100");
  EXPECT_EQ(from_origin("G2 I5"),
            std::string(kStart) + "\ncut to 10 0 5 cw about 5 0 F100\ncut to 0 0 5 cw about 5 0 F100");
}

TEST(GcodeArcs, HelixAndTurns) {
  EXPECT_EQ(from_origin("G3 Z3 I5"),
            std::string(kStart) + "\nramp to 10 0 4 ccw about 5 0 F100\nramp to 0 0 3 ccw about 5 0 F100");
  EXPECT_EQ(from_origin("G3 X10 Z2 I5 P2"),
            std::string(kStart) + "\nramp to 5 5 3.5 ccw about 5 0 F100\nramp to 10 0 2 ccw about 5 0 F100");
}

TEST(GcodeArcs, EndsOffTheCircleAreJoinedExactly) {
  const Program program = read_gcode("G0 X0 Y0 Z0\nG1 X0 F9\nG3 X10.004 Y0 I5 J0\nX20 I5\nM2", "t");
  const auto& moves = program.toolpath.sections[0].moves;
  Vec2 at = moves.front().path.from;
  for (const Move& move : moves) {
    EXPECT_EQ(move.path.from, at);
    if (move.path.is_arc()) {
      EXPECT_NEAR(distance(move.path.from, move.path.center), distance(move.path.to, move.path.center),
                  1e-12);
    }
    at = move.path.to;
  }
  EXPECT_EQ(at, (Vec2{20, 0}));
}

TEST(GcodeArcs, UprightArcsBecomeChords) {
  const Program program = read_gcode("G0 X0 Y0 Z0\nG18 G2 X10 Z10 I10 K0 F100\nM2", "t");
  const auto& moves = program.toolpath.sections[0].moves;
  EXPECT_GT(moves.size(), 100U);
  for (const Move& move : moves) {
    if (is_rapid(move.kind)) continue;
    EXPECT_NEAR(std::hypot(move.path.to.x - 10, move.z_to), 10, 1e-9);
  }
  EXPECT_EQ(moves.back().path.to, (Vec2{10, 0}));
  EXPECT_NEAR(moves.back().z_to, 10, 1e-12);
}

TEST(GcodeArcs, ImpossibleArcsAreRefused) {
  const std::string start = "G0 X0 Y0 Z0 F100\n";
  EXPECT_EQ(
      message_of(start + "G2 X10 Y0 I5.3"),
      "test.ngc:2: arc whose radius is 5.3 mm at its start and 4.7 mm at its end; controls refuse it, post "
      "with more decimals");
  EXPECT_THAT(message_of(start + "G2 X10 Y0 R4"), HasSubstr("test.ngc:2: arc of radius 4 mm cannot reach"));
  EXPECT_THAT(message_of(start + "G2 X0 Y0 R4"), HasSubstr("ends where it starts"));
  EXPECT_THAT(message_of(start + "G2 X10"), HasSubstr("arc without I, J or R"));
  EXPECT_THAT(message_of(start + "G2 X10 I0 J0"), HasSubstr("radius zero"));
  EXPECT_THAT(message_of(start + "G2 I10 P1.5"), HasSubstr("no number of turns"));
}

TEST(GcodeCycles, DrillingBecomesMoves) {
  EXPECT_EQ(from_origin("G98 G81 X1 Y2 Z-3 R2 F50\nX4\nG80"),
            std::string(kStart) + "\nrapid to 1 2 5\nrapid to 1 2 2\nplunge to 1 2 -3 F50\nrapid to 1 2 5" +
                "\nrapid to 4 2 5\nrapid to 4 2 2\nplunge to 4 2 -3 F50\nrapid to 4 2 5");
  EXPECT_EQ(from_origin("G99 G82 X1 Y2 Z-3 R2 P1\nX4\nG80"),
            std::string(kStart) + "\nrapid to 1 2 5\nrapid to 1 2 2\nplunge to 1 2 -3 F100\nrapid to 1 2 2" +
                "\nrapid to 4 2 2\nplunge to 4 2 -3 F100\nrapid to 4 2 2");
}

TEST(GcodeCycles, PecksAndFeedOut) {
  EXPECT_EQ(from_origin("G99 G83 X0 Y0 Z-2 R1 Q2"),
            std::string(kStart) +
                "\nrapid to 0 0 1\nplunge to 0 0 -1 F100\nrapid to 0 0 1\nrapid to 0 0 -0.746" +
                "\nplunge to 0 0 -2 F100\nrapid to 0 0 1");
  EXPECT_EQ(from_origin("G99 G73 X0 Y0 Z-2 R1 Q2"),
            std::string(kStart) + "\nrapid to 0 0 1\nplunge to 0 0 -1 F100\nrapid to 0 0 -0.746" +
                "\nplunge to 0 0 -2 F100\nrapid to 0 0 1");
  EXPECT_EQ(from_origin("G99 G85 X0 Y0 Z-2 R1"),
            std::string(kStart) + "\nrapid to 0 0 1\nplunge to 0 0 -2 F100\nretract to 0 0 1 F100");
}

TEST(GcodeCycles, IncrementalRepeats) {
  EXPECT_EQ(from_origin("G91 G99 G81 X1 Z-3 R-4 L2"),
            std::string(kStart) + "\nrapid to 1 0 5\nrapid to 1 0 1\nplunge to 1 0 -2 F100\nrapid to 1 0 1" +
                "\nrapid to 2 0 1\nplunge to 2 0 -2 F100\nrapid to 2 0 1");
}

/// LinuxCNC's interpreter takes the height before the cycles, 5 mm, for 5 inches.
TEST(GcodeCycles, UnitsThatChangeWithinOneAreReadAsTheControlDoes) {
  EXPECT_EQ(from_origin("G99 G91 G81 X1 Z-3 R-4\nG20\nG81 X1 Z-1 R-4"),
            std::string(kStart) + "\nrapid to 1 0 5\nrapid to 1 0 1\nplunge to 1 0 -2 F100\nrapid to 1 0 1" +
                "\nrapid to 26.4 0 25.4\nplunge to 26.4 0 0 F100\nrapid to 26.4 0 25.4");
}

TEST(GcodeCycles, MissingWordsAreRefused) {
  EXPECT_THAT(message_of("G0 X0 Y0 Z5\nG81 X1 Z-3"),
              HasSubstr("test.ngc:2: drilling cycle without its Z or R"));
  EXPECT_THAT(message_of("G0 X0 Y0 Z5\nG83 X1 Z-3 R1"), HasSubstr("needs a Q word"));
  EXPECT_THAT(message_of("G0 X0 Y0 Z5\nG83 X1 Z-3 R1 Q-1"), HasSubstr("needs a Q word"));
  EXPECT_THAT(message_of("G0 X0 Y0 Z5\nG83 X1 Z-3 R1 Q.00000001"), HasSubstr("needs a Q word"));
  EXPECT_THAT(message_of("G0 X0 Y0 Z5\nG81 X1 Z3 R1"), HasSubstr("R lies below its Z"));
}

TEST(GcodeFrames, MachinePlacesAreHigh) {
  EXPECT_EQ(from_origin("G1 X1\nG53 G0 Z0\nG0 X7"),
            std::string(kStart) + "\ncut to 1 0 5 F100\nrapid to 1 0 100\nrapid to 7 0 100");
  EXPECT_EQ(from_origin("G1 X1\nG91 G28 Z0\nG90 G0 X7"),
            std::string(kStart) + "\ncut to 1 0 5 F100\nrapid to 1 0 100\nrapid to 7 0 100");
  EXPECT_EQ(from_origin("G1 X1\nG28 Z-2"),
            std::string(kStart) + "\ncut to 1 0 5 F100\nrapid to 1 0 -2\nrapid to 1 0 100")
      << "an absolute intermediate point is gone through";
  EXPECT_EQ(conditions("G21 G0 X0 Y0 Z5\nG53 G0 Z0\nM2"), "g53@2");
}

TEST(GcodeFrames, OffsetsByG92AndG52) {
  EXPECT_EQ(from_origin("G1 X10\nG92 X0\nG1 X1\nG92.1\nG1 X1"),
            std::string(kStart) + "\ncut to 10 0 5 F100\ncut to 11 0 5 F100\ncut to 1 0 5 F100");
  EXPECT_EQ(from_origin("G52 X100\nG1 X1\nG52 X0\nX1"),
            std::string(kStart) + "\ncut to 101 0 5 F100\ncut to 1 0 5 F100");
  EXPECT_EQ(moves_of("G92 X0 Y0 Z0\nG1 X1 F100\nM2"), "from 0 0 0\ncut to 1 0 0 F100");
}

TEST(GcodeSections, ToolChangesAndOwnComments) {
  const Program program = read_gcode(
      "(OPERATION 2: POCKET A)\nT3 M6\nS5000 M3\nM8\nG0 X0 Y0 Z5\nG1 X1 F100\nT4 M6\nM4 S200 M9\nG1 X2\n"
      "(OPERATION: REST)\nG1 X3\n(A COMMENT)\nG1 X4\nM30",
      "t");
  ASSERT_EQ(program.toolpath.sections.size(), 3U);
  const Section& first = program.toolpath.sections[0];
  const Section& second = program.toolpath.sections[1];
  const Section& third = program.toolpath.sections[2];
  EXPECT_EQ(first.label, "POCKET A");
  EXPECT_EQ(first.workingstep, 1);
  EXPECT_EQ(first.tool_number, 3);
  EXPECT_EQ(first.spindle_rpm, 5000);
  EXPECT_TRUE(first.spindle_clockwise);
  EXPECT_EQ(first.coolant, Coolant::kFlood);
  EXPECT_EQ(second.tool_number, 4);
  EXPECT_EQ(second.spindle_rpm, 200);
  EXPECT_FALSE(second.spindle_clockwise);
  EXPECT_EQ(second.coolant, Coolant::kOff);
  EXPECT_EQ(third.label, "REST");
  EXPECT_EQ(third.workingstep, -1);
  EXPECT_EQ(third.moves.size(), 2U);
}

TEST(GcodeSections, ToolsByHandAtAPause) {
  const Program program =
      read_gcode("T1\nG0 X0 Y0 Z5\nG1 X1 F100\nT2\nG1 X2\nM0\nG1 X3\nM0\nG1 X4\nM30", "t");
  ASSERT_EQ(program.toolpath.sections.size(), 2U);
  EXPECT_EQ(program.toolpath.sections[0].tool_number, 1);
  EXPECT_EQ(program.toolpath.sections[1].tool_number, 2);
  EXPECT_EQ(program.toolpath.sections[1].moves.size(), 2U);
}

TEST(GcodeSections, AToolReadyForTheChangerIsNotLoadedByAPause) {
  const Program program = read_gcode("T1 M6\nT2\nG0 X0 Y0 Z5\nG1 X1 F100\nM1\nG1 X2\nM6\nG1 X3\nM30", "t");
  ASSERT_EQ(program.toolpath.sections.size(), 2U);
  EXPECT_EQ(program.toolpath.sections[0].tool_number, 1);
  EXPECT_EQ(program.toolpath.sections[0].moves.size(), 3U);
}

TEST(GcodeEnd, WhatFollowsTheEndIsNotRead) {
  EXPECT_TRUE(read_gcode("G0 X0\nM30\nthis is $ no code", "t").ended);
  EXPECT_TRUE(read_gcode("%\nO0001\nG0 X0\n%\n$$$", "t").ended);
  EXPECT_FALSE(read_gcode("G0 X0\n", "t").ended);
  EXPECT_THAT(noticed("G0 X0"), HasSubstr("no end word"));
  EXPECT_THAT(noticed("G0 X0\nM30\n(done)\n%"), Not(HasSubstr("is not run")));
  EXPECT_THAT(noticed("G0 X0\nM30\nG1 X5 F9"), HasSubstr("what follows the end word in line 2 is not run"));
  EXPECT_THAT(noticed("%\nO1\nG0 X0\nM30\n%\n%\nO2\nG0 X5\nM30\n%"),
              HasSubstr("what follows the end word in line 4 is not run"));
}

TEST(GcodeRefusals, EachNamesItsLineAndWhatToDo) {
  const std::string start = "G0 X0 Y0 Z5 F100\n";
  EXPECT_EQ(
      message_of(start + "G41 D1"),
      "test.ngc:2: cutter compensation by the radius of D1, and no tool T1 is given; add it by --tool, or "
      "state it in the job");
  EXPECT_THAT(message_of(start + "#1="), HasSubstr("test.ngc:2: a number is missing"));
  EXPECT_THAT(message_of(start + "G1 X[1+2"), HasSubstr("test.ngc:2: an expression lacks its ']'"));
  EXPECT_THAT(message_of(start + "G1 X#<a>"), HasSubstr("test.ngc:2: #<a> is read before anything sets it"));
  EXPECT_THAT(message_of(start + "o100 sub"), HasSubstr("test.ngc:2: o100 has no end"));
  EXPECT_THAT(message_of(start + "M98 P1000"), HasSubstr("test.ngc:2: subprogram O1000 is neither"));
  EXPECT_THAT(message_of(start + "G1 A90"), HasSubstr("test.ngc:2: axis word A"));
  EXPECT_THAT(message_of(start + "G1 X1 X2"), HasSubstr("test.ngc:2: two X words"));
  EXPECT_THAT(message_of(start + "G0 G1 X1"), HasSubstr("test.ngc:2: G1 contradicts"));
  EXPECT_THAT(message_of(start + "G1 X"), HasSubstr("test.ngc:2: X word without a number"));
  EXPECT_THAT(message_of(start + "G1 X--5"), HasSubstr("test.ngc:2: X word with '--5'"));
  EXPECT_THAT(message_of(start + "G1 X1e-05"), HasSubstr("test.ngc:2: X word with an exponent"));
  EXPECT_THAT(message_of(start + "G1 Xinf"), HasSubstr("test.ngc:2: "));
  EXPECT_THAT(message_of(start + "G1 X9999999999"),
              HasSubstr("test.ngc:2: X word with a number no machine takes"));
  EXPECT_THAT(message_of(start + "G1 X99999999"), HasSubstr("test.ngc:2: coordinate beyond any machine"));
  EXPECT_THAT(message_of(start + "(never closed"), HasSubstr("test.ngc:2: comment without its closing"));
  EXPECT_THAT(message_of(start + "(a (comment) in it)"), HasSubstr("test.ngc:2: comment within a comment"));
  EXPECT_THAT(message_of(start + "\x01"), HasSubstr("test.ngc:2: unexpected byte 1"));
  EXPECT_THAT(message_of(start + "G5 X1"), HasSubstr("test.ngc:2: G5 is not read"));
  EXPECT_THAT(message_of(start + "G80\nX1"), HasSubstr("test.ngc:3: axis words after G80"));
}

TEST(GcodeRefusals, RepeatsCannotFillTheMemory) {
  EXPECT_THAT(message_of("G0 X0 Y0 Z5 F1\nG2 I1 P9999999"), HasSubstr("no number of turns"));
  std::string program = "G0 X0 Y0 Z5 F1\n";
  for (int k = 0; k < 200; ++k) program += "G2 I1 P10000\n";
  EXPECT_THAT(message_of(program), HasSubstr("expand to over a million moves"));
}

// ----------------------------------------------------------------------------------------------------
// Klartext

std::string klartext(const std::string& blocks) {
  return "0 BEGIN PGM A MM\n1 TOOL CALL 2 Z S4000\n2 L X+0 Y+0 R0 FMAX M3\n3 L Z+5 R0 FMAX\n" + blocks +
         "\n9 END PGM A MM\n";
}

TEST(Klartext, LinesAndArcs) {
  EXPECT_EQ(moves_of(klartext(
                "4 L Z-1 F100\n5 CC X+5 Y+0\n6 C X+10 Y+0 DR- F200\n7 L IX+5 IY-1\n8 CR X+25 Y-1 R+5 DR+")),
            std::string(kStart) +
                "\nplunge to 0 0 -1 F100\ncut to 10 0 -1 cw about 5 0 F200\ncut to 15 -1 -1 F200" +
                "\ncut to 25 -1 -1 ccw about 20 -1 F200");
}

TEST(Klartext, PolarMoves) {
  EXPECT_EQ(moves_of(klartext("4 CC X+5 Y+0\n5 CP IPA+360 IZ-2 DR+ F100\n6 CP PA+0 DR- \n7 LP PR+20 PA+90")),
            std::string(kStart) + "\nramp to 10 0 4 ccw about 5 0 F100\nramp to 0 0 3 ccw about 5 0 F100" +
                "\ncut to 10 0 3 cw about 5 0 F100\ncut to 5 20 3 F100");
}

TEST(Klartext, InchFeedsCountTenths) {
  EXPECT_EQ(moves_of("BEGIN PGM A INCH\nL X+0 Y+0 Z+1 R0 FMAX\nL X+1 F100\nEND PGM A INCH"),
            "from 0 0 100\nrapid to 0 0 25.4\ncut to 25.4 0 25.4 F254");
}

TEST(Klartext, ToolsAndSpindle) {
  const Program program = read_gcode(klartext("4 ; OPERATION 3: POCKET\n5 L X+1 F100 M8"), "t.h");
  ASSERT_EQ(program.toolpath.sections.size(), 2U);
  const Section& section = program.toolpath.sections[1];
  EXPECT_EQ(section.label, "POCKET");
  EXPECT_EQ(section.workingstep, 2);
  EXPECT_EQ(section.tool_number, 2);
  EXPECT_EQ(section.spindle_rpm, 4000);
  EXPECT_EQ(section.coolant, Coolant::kFlood);
  EXPECT_TRUE(program.ended);
}

TEST(Klartext, LengthsAndDatumsAreConditions) {
  const std::string program =
      "BEGIN PGM A MM\nCYCL DEF 32.0 TOLERANCE\nCYCL DEF 32.1 T0.01\nTOOL CALL 1 Z S100 DL-1.0\n"
      "L X+0 Y+0 R0 FMAX\nL Z+5 R0 FMAX\nL Z-1 F9\nEND PGM A MM";
  EXPECT_EQ(moves_of(program), "from 0 0 100\nrapid to 0 0 4\nplunge to 0 0 -2 F9");
  EXPECT_EQ(conditions(program), "tool-length-dl@4 ends-low@8");
  EXPECT_EQ(conditions("BEGIN PGM A MM\nCYCL DEF 247 DATUM SETTING Q339=+2\nEND PGM A MM"), "datum-247@2");
  EXPECT_EQ(conditions("BEGIN PGM A MM\nL Z+0 R0 FMAX M91\nEND PGM A MM"), "m91@2");
  EXPECT_EQ(conditions(klartext("4 L X+1 F9 M107")), "m107@5 blending@5");
}

TEST(Klartext, WhatItCannotReadItRefuses) {
  EXPECT_THAT(message_of(klartext("4 L X+Q1")),
              HasSubstr("test.ngc:5: Q1 is read before the program sets it"));
  EXPECT_THAT(message_of(klartext("4 L X+1 RL")),
              HasSubstr("cutter compensation by the radius of the tool table, and no tool"));
  EXPECT_THAT(message_of(klartext("4 CYCL DEF 8.0 MIRROR IMAGE")), HasSubstr("cycle 8 is not read"));
  EXPECT_THAT(message_of(klartext("4 FL X+5")), HasSubstr("block 'FL' is not read"));
  EXPECT_THAT(message_of(klartext("4 CALL LBL 1")), HasSubstr("there is no LBL 1"));
  EXPECT_THAT(message_of(klartext("4 C X+1 DR+")), HasSubstr("arc without its centre"));
  EXPECT_THAT(message_of(klartext("4 CC X+5 Y+0\n5 CP IPA-90 DR+")), HasSubstr("disagree"));
}

}  // namespace
}  // namespace clearcut::read::gcode
