// What a Sinumerik does with its own words, and which of them are refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "read/gcode/sinumerik/words.h"
#include "read/gcode/test_told_program.h"

namespace clearcut::read::gcode {
namespace {

using ::testing::HasSubstr;

constexpr Dialect kSiemens = Dialect::kSiemens;
const std::string kStart = "G710 G17 G90 G94 G60\nG0 X0 Y0 Z5\nF100\n";

/// All moves but the one to the start.
std::string moves(const std::string& program) {
  return moves_as(kSiemens, kStart + program + "\nM30").substr(std::string("\nrapid to 0 0 5").size());
}
std::string named(const std::string& program) {
  return conditions_as(kSiemens, kStart + program + "\nM30");
}
std::string refusal(const std::string& program) {
  try {
    read_as(kSiemens, kStart + program + "\nM30");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}
PathControl path_after(const std::string& words) {
  return read_as(kSiemens, "G710 G17 G90\nG0 X0 Y0 Z5\n" + words + "\nG1 X5 F100\nM30")
      .control.spans.back()
      .state.path;
}

TEST(Sinumerik, WordsOfSeveralLettersAndOnesBehindAnEqualsSign) {
  EXPECT_EQ(moves("G1 X10 y=20.5"), "\ncut to 10 20.5 5 F100");
  EXPECT_EQ(moves("N20 G1 X=10 Y=+2 F=250 ; to X99"), "\ncut to 10 2 5 F250");
  EXPECT_EQ(moves("START: G1 X1\n:30 X2\n/3 X4"),
            "\ncut to 1 0 5 F100\ncut to 2 0 5 F100\ncut to 4 0 5 F100");
  EXPECT_EQ(moves("MSG(\"G1 X50 ; not read\")\nSTOPRE\nFFWON SOFT\nG1 X1"), "\ncut to 1 0 5 F100");
}

TEST(Sinumerik, PlacesCountAsTheirWordSays) {
  EXPECT_EQ(moves("G1 X10\nX=IC(5)\nG91 X1\nX=AC(3) Y1"),
            "\ncut to 10 0 5 F100\ncut to 15 0 5 F100\ncut to 16 0 5 F100\ncut to 3 1 5 F100");
}

TEST(Sinumerik, ArcsByCentreRadiusAndTurns) {
  EXPECT_EQ(moves("G1 X10\nG3 X10 Y10 I0 J5"), "\ncut to 10 0 5 F100\ncut to 10 10 5 ccw about 10 5 F100");
  EXPECT_EQ(moves("G1 X10\nG3 X10 Y10 I=AC(10) J=AC(5)"),
            "\ncut to 10 0 5 F100\ncut to 10 10 5 ccw about 10 5 F100");
  EXPECT_EQ(moves("G2 X10 Y10 CR=10"), "\ncut to 10 10 5 cw about 10 0 F100");
  EXPECT_EQ(moves("G2 X10 Y10 CR=-10"), "\ncut to 10 10 5 cw about 0 10 F100");
  const Program helix = read_as(kSiemens, kStart + "G3 X0 Y0 Z-4 I5 J0 TURN=1\nM30");
  double sweep = 0;
  for (const Section& section : helix.toolpath.sections)
    for (const Move& move : section.moves)
      if (move.path.is_arc()) sweep += move.path.sweep();
  EXPECT_NEAR(sweep, 4 * kPi, 1e-6) << "one turn to the end and one more";
  EXPECT_THAT(refusal("G3 X0 Y0 I5 J0 TURN=1.5"), HasSubstr("test.ngc:4: TURN= is no number of turns"));
  EXPECT_THAT(refusal("G3 X5 Y5 I=AC(5) J0"), HasSubstr("one centre word with AC()"));
}

TEST(Sinumerik, UnitsOfLengthsAndFeeds) {
  EXPECT_EQ(moves_as(kSiemens, "G700 G17 G90 G60\nG0 X0 Y0 Z1\nG1 X1 F10\nM30"),
            "\nrapid to 0 0 25.4\ncut to 25.4 0 25.4 F254");
}

TEST(Sinumerik, CornersAreRoundedAsStated) {
  EXPECT_EQ(path_after("").mode, PathMode::kUnstated);
  EXPECT_EQ(path_after("G60").mode, PathMode::kExactStop);
  EXPECT_EQ(path_after("G64").mode, PathMode::kContinuous);
  EXPECT_EQ(path_after("G642 CTOL=0.02").tolerance_mm, 0.02);
  EXPECT_EQ(path_after("CTOL=0.02\nG645").tolerance_mm, 0.02);
  EXPECT_EQ(path_after("G642").mode, PathMode::kSmoothness);
  EXPECT_EQ(path_after("G641 ADIS=0.3").tolerance_mm, 0.3);
  EXPECT_EQ(path_after("G641").mode, PathMode::kContinuous);
  EXPECT_EQ(path_after("CYCLE832(0.05,1,1)").tolerance_mm, 0.05);
  EXPECT_EQ(path_after("CYCLE832(0.1,_ROUGH,1)").tolerance_mm, 0.1);
  EXPECT_EQ(path_after("CYCLE832(0.1,_ROUGH,1)\nCYCLE832(0,_OFF,1)").mode, PathMode::kUnstated);
  EXPECT_EQ(path_after("CYCLE832(0.1,3)\nCYCLE832()").mode, PathMode::kUnstated);
  for (const char* nothing : {"CYCLE832(0,_FINISH,1)", "CYCLE832(,1)", "G642 CTOL=0"})
    EXPECT_EQ(path_after(nothing).mode, PathMode::kSmoothness) << nothing;
  EXPECT_EQ(path_after("CYCLE832(0.1,1)\nCTOL=0").mode, PathMode::kSmoothness);
  EXPECT_EQ(path_after("G641 ADIS=0").mode, PathMode::kContinuous);
  EXPECT_EQ(named("G64\nG1 X5"), "blending@5");
  EXPECT_EQ(named("G642\nG1 X5"), "blending@5");
  EXPECT_EQ(named("G642 CTOL=0.01\nG9 G1 X5\nG601"), "");
  EXPECT_EQ(named("COMPCAD\nG1 X5"), "compressor@5");
  EXPECT_EQ(named("COMPCAD G642 CTOL=0.01\nG1 X5\nCOMPOF"), "");
}

TEST(Sinumerik, ToolsByNumberAndName) {
  const auto tools = [](const std::string& program) {
    std::vector<int> numbers;
    for (const Section& section : read_as(kSiemens, kStart + program + "\nM30").toolpath.sections)
      if (feed_length(section) > 0) numbers.push_back(section.tool_number);
    return numbers;
  };
  EXPECT_EQ(tools("T3 M6\nD1\nG1 X5\nT=4 M6 D1\nG1 X6"), (std::vector<int>{3, 4}));
  EXPECT_EQ(tools("T=\"MILL 6\" M6\nD1\nG1 X5\nT=\"DRILL\"\nM6\nD1\nG1 X6\nT=\"MILL 6\" M6 D1\nG1 X7"),
            (std::vector<int>{1, 2, 1}));
  EXPECT_EQ(named("T=\"MILL;6\" M6 D1\nG1 X5"), "tool-name-1@4");
  EXPECT_EQ(tools("T=\"7\" M6 D1\nG1 X5"), (std::vector<int>{7}));
}

TEST(Sinumerik, TheEdgeHoldsFromTheToolChangeOn) {
  EXPECT_EQ(named("T1 M6\nD1\nG1 X5"), "");
  EXPECT_EQ(named("T1 M6\nG1 X5"), "d1@5") << "by itself, as it is delivered";
  EXPECT_EQ(named("T1 M6 D1\nG1 X5\nD0\nG1 X6"), "tool-length-off@7");
  EXPECT_EQ(named("T1 M6 D2\nG1 X5"), "d2@4");
}

TEST(Sinumerik, PlacesOfTheMachine) {
  EXPECT_EQ(named("SUPA G0 Z0 D0\nSUPA G0 X0 Y0"), "");
  EXPECT_EQ(named("G53 G0 Z0 D0\nG153 X0 Y0"), "");
  EXPECT_EQ(named("T1 M6 D1\nSUPA G0 Z0"), "d0@5") << "the tip and not the nose";
  EXPECT_EQ(named("SUPA G0 X0 Y0 D0"), "g53@4");
  EXPECT_EQ(named("G505\nG1 X1\nG54\nX2"), "g505@4");
  EXPECT_EQ(named("G500"), "g500@4");
  EXPECT_THAT(refusal("G58 X10"), HasSubstr("shifts single axes on a Sinumerik"));
}

TEST(Sinumerik, ProgrammedShifts) {
  EXPECT_EQ(moves("TRANS X10 Y5\nG1 X1\nATRANS X1\nX1\nTRANS Z2\nX1 Z5\nTRANS\nX2"),
            "\ncut to 11 0 5 F100\ncut to 12 0 5 F100\ncut to 1 0 7 F100\ncut to 2 0 7 F100");
  EXPECT_EQ(moves("ROT\nSCALE\nMIRROR\nG1 X1"), "\ncut to 1 0 5 F100");
}

TEST(Sinumerik, AxesAreTurnedMirroredAndScaled) {
  EXPECT_EQ(moves("ROT RPL=90\nG1 X10\nG3 X0 Y10 I-10 J0\nROT\nG1 X1"),
            "\ncut to 0 10 5 F100\ncut to -10 0 5 ccw about 0 0 F100\ncut to 1 0 5 F100");
  EXPECT_EQ(moves("TRANS X10\nAROT Z90\nATRANS X5\nG1 X0 Y2"), "\ncut to 8 5 5 F100");
  EXPECT_EQ(moves("MIRROR X0\nG1 X10\nG3 X0 Y10 I-10 J0"),
            "\ncut to -10 0 5 F100\ncut to 0 10 5 cw about 0 0 F100");
  EXPECT_EQ(moves("SCALE X2 Y2\nG1 X10 Y1\nG91 X1\nG90 G2 X13 Y3 CR=2"),
            "\ncut to 20 2 5 F100\ncut to 22 2 5 F100\ncut to 26 6 5 cw about 26 2 F100");
  EXPECT_EQ(moves("ROT Z90\nG1 X=IC(5)\nX=IC(5)\nG3 X0 Y10 I=AC(0) J=AC(0)"),
            "\ncut to 0 5 5 F100\ncut to 0 10 5 F100\ncut to -10 0 5 ccw about 0 0 F100");
  EXPECT_THAT(refusal("ROT X30"), HasSubstr("ROT about X or Y tilts the plane"));
  EXPECT_THAT(refusal("ROTS X30 Y10"), HasSubstr("ROTS turns in space"));
  EXPECT_THAT(refusal("SCALE X2"), HasSubstr("SCALE is read with one factor"));
  EXPECT_THAT(refusal("MIRROR Z0"), HasSubstr("a mirrored Z is not read"));
  EXPECT_THAT(refusal("G1 X5 RPL=45"), HasSubstr("RPL belongs to ROT and AROT"));
}

TEST(Sinumerik, WaitsInSecondsAndTurns) {
  const Program program = read_as(kSiemens, kStart + "M3 S600\nG4 F2\nG4 S30\nG1 X1\nM30");
  std::vector<double> waits;
  for (const ControlEvent& event : program.control.events)
    if (event.kind == ControlEventKind::kDwell) waits.push_back(event.seconds);
  EXPECT_EQ(waits, (std::vector<double>{2, 3}));
  EXPECT_EQ(program.toolpath.sections.back().moves.back().feed, MmPerMin::of(100));
  EXPECT_THAT(refusal("G4"), HasSubstr("G4 without F"));
}

TEST(SinumerikHoles, AtOnceAndModally) {
  const std::string hole = "\nrapid to 0 0 2\nplunge to 0 0 -5 F100\nrapid to 0 0 10";
  EXPECT_EQ(moves("CYCLE81(10,0,2,-5)"), hole);
  EXPECT_EQ(moves("CYCLE81(10,0,2,,5)"), hole);
  EXPECT_EQ(moves("CYCLE81(10,0,2,-5,,0,0,10)"), hole) << "with mode words";
  EXPECT_EQ(moves("MCALL CYCLE81(10,2,0,-5)\nX10\nY5\nMCALL\nX1"),
            "\nrapid to 10 0 5\nrapid to 10 0 2\nplunge to 10 0 -5 F100\nrapid to 10 0 10"
            "\nrapid to 10 5 10\nrapid to 10 5 2\nplunge to 10 5 -5 F100\nrapid to 10 5 10\nrapid to 1 5 10");
}

TEST(SinumerikHoles, PecksClearOrBreakChips) {
  EXPECT_EQ(
      moves("CYCLE83(5,0,1,-5,,-2,,0,,,1,1,,2,,,0.5)"),
      "\nrapid to 0 0 1\nplunge to 0 0 -2 F100\nrapid to 0 0 1\nrapid to 0 0 -1.5\nplunge to 0 0 -4 F100"
      "\nrapid to 0 0 1\nrapid to 0 0 -3.5\nplunge to 0 0 -5 F100\nrapid to 0 0 5");
  EXPECT_EQ(moves("CYCLE83(5,0,1,-3,,,2,0,,,0.5,0,,,0.4)"),
            "\nrapid to 0 0 1\nplunge to 0 0 -2 F50\nretract to 0 0 -1.6 F100\nplunge to 0 0 -3 F100\nrapid "
            "to 0 0 5")
      << "the first depth at half the feed, chips broken at the feed";
  EXPECT_EQ(
      moves("CYCLE83(5,0,1,-10,,-5,,2,,,1,1,,,,,0.5)"),
      "\nrapid to 0 0 1\nplunge to 0 0 -5 F100\nrapid to 0 0 1\nrapid to 0 0 -4.5\nplunge to 0 0 -8 F100"
      "\nrapid to 0 0 1\nrapid to 0 0 -7.5\nplunge to 0 0 -10 F100\nrapid to 0 0 5")
      << "less by 2 mm each time";
}

TEST(SinumerikHoles, ReamedAndTapped) {
  EXPECT_EQ(moves("CYCLE85(5,0,1,-3,,,80,200)"),
            "\nrapid to 0 0 1\nplunge to 0 0 -3 F80\nretract to 0 0 1 F200\nrapid to 0 0 5");
  const std::string tapped = "\nrapid to 0 0 1\nplunge to 0 0 -3 F500\nretract to 0 0 1 F500\nrapid to 0 0 5";
  EXPECT_EQ(moves("M3 S500\nCYCLE84(5,0,1,-3,,,3,,1,0,500,500)"), tapped);
  EXPECT_EQ(moves("M3 S500\nCYCLE84(5,0,1,-3,,,3,6)"), tapped) << "M6 by its size";
  EXPECT_EQ(moves("M3 S500 F500\nCYCLE840(5,0,1,-3,,,4,3,1)"), tapped);
  const auto tap = [](const std::string& call) {
    const Program program = read_as(kSiemens, kStart + "M3 S500 F500\n" + call + "\nM30");
    for (const ControlEvent& event : program.control.events)
      if (event.kind == ControlEventKind::kTapTurnsBack) return event.tap;
    return TapCycle{};
  };
  EXPECT_EQ(tap("CYCLE84(5,0,1,-3,,,3,,-1,0,500,500)").left_hand, std::optional(true));
  EXPECT_TRUE(tap("CYCLE84(5,0,1,-3,,,3,,1,0,500,500)").is_tied);
  EXPECT_FALSE(tap("CYCLE840(5,0,1,-3,,,4,3,1)").is_tied);
}

TEST(SinumerikHoles, ATapThatIsStatedToTurnAsBeforeDoesNotTurnBack) {
  const auto turns_back = [](const std::string& call) {
    const Program program = read_as(kSiemens, kStart + call + "\nM30");
    return std::any_of(program.control.events.begin(), program.control.events.end(),
                       [](const ControlEvent& e) { return e.kind == ControlEventKind::kTapTurnsBack; });
  };
  EXPECT_FALSE(turns_back("M3 S500 F500\nCYCLE840(5,0,1,-3,,,3,3,1)")) << "M3 down and up";
  EXPECT_TRUE(turns_back("M3 S500 F500\nCYCLE840(5,0,1,-3,,,4,3,1)"));
  EXPECT_TRUE(turns_back("M3 S500 F500\nCYCLE840(5,0,1,-3,,,0,3,1)")) << "0 reverses";
  EXPECT_TRUE(turns_back("M4 S500 F500\nCYCLE840(5,0,1,-3,,,3,4,1)")) << "a left-hand tap";
}

TEST(SinumerikHoles, CallsThatCannotBeUnderstoodAreNamed) {
  EXPECT_THAT(refusal("CYCLE81(10,0,2)"), HasSubstr("test.ngc:4: CYCLE81 states no depth"));
  EXPECT_THAT(refusal("MCALL CYCLE81(10)"), HasSubstr("CYCLE81 needs RTP and RFP"));
  EXPECT_THAT(refusal("CYCLE81(10,0,2,-5,4)"), HasSubstr("two depths"));
  EXPECT_THAT(refusal("CYCLE81(0,0,2,-5)"), HasSubstr("return plane RTP below"));
  EXPECT_THAT(refusal("CYCLE81(10,0,2,R1)"), HasSubstr("R1 is taken before the program sets it"));
  EXPECT_THAT(refusal("CYCLE81(10,0,2,-5,,0,0,11)"), HasSubstr("_AMODE"));
  EXPECT_THAT(refusal("CYCLE83(10,0,2,-5)"), HasSubstr("states no first depth"));
  EXPECT_THAT(refusal("CYCLE84(10,0,2,-5)"), HasSubstr("needs the pitch PIT"));
  EXPECT_THAT(refusal("POCKET3(10,0,2,-5)"), HasSubstr("POCKET3 is a cycle that is not read"));
  EXPECT_THAT(refusal("CYCLE800(1,\"\",0,57,0,0,0,0,30,0,0,0,0,-1)"),
              HasSubstr("CYCLE800 swivels the plane"));
  EXPECT_EQ(named("CYCLE800()"), "cycle800@4");
}

TEST(Sinumerik, WhatLeavesThePlaneIsRefusedInOneLine) {
  EXPECT_THAT(refusal("G41 X5"), HasSubstr("cutter compensation by the radius of the tool table"));
  EXPECT_THAT(refusal("D=\"SHORT\""), HasSubstr("D word with an impossible edge"));
  EXPECT_THAT(refusal("G1 A30"), HasSubstr("axis word A"));
  EXPECT_THAT(refusal("TRAORI"), HasSubstr("TRAORI is not read"));
  EXPECT_THAT(refusal("G1 X5 RNDM=2"), HasSubstr("RNDM is not read"));
  EXPECT_THAT(refusal("G111 X0 Y0"), HasSubstr("polar coordinates"));
  EXPECT_THAT(refusal("(a comment)"), HasSubstr("no comment on a Sinumerik"));
  EXPECT_THAT(refusal("G1 X1EX-3"), HasSubstr("exponent"));
  EXPECT_THAT(refusal("G1 X1 X2"), HasSubstr("two X words"));
  EXPECT_THAT(refusal("G0 G1 X1"), HasSubstr("contradicts another G word"));
  EXPECT_THAT(refusal("MSG(\"open"), HasSubstr("closing ')'"));
}

TEST(Sinumerik, IsRecognisedByItsWords) {
  for (const char* line : {"G710", "N10 G642 CTOL=0.01", "MCALL CYCLE81(1,0,0,-1)", "T=\"MILL\" M6",
                           "SUPA G0 Z0", "G2 X1 Y1 CR=5", "%_N_PLATE_MPF", "MSG(\"CUT\")", "IF R1<5 GOTOB AA",
                           "DEF REAL DOWN=2", "ROT RPL=45"})
    EXPECT_TRUE(is_sinumerik(std::string("G90\n") + line + "\n")) << line;
  for (const char* line :
       {"(T1 D=6 CR=0 - ZMIN=-5)", "; CR=5", "#1=5", "G71", "G64 P0.01", "(MSG, G710)", "X=3", "G1 X10 Y5",
        "O100 CALL [1]", "O100 ENDWHILE", "O<TRANS> CALL", "IF [#1 EQ 2] GOTO 10"})
    EXPECT_FALSE(is_sinumerik(std::string("G90\n") + line + "\n")) << line;
  EXPECT_EQ(read_gcode("G710 G17 G90 G60\nG0 X0 Y0 Z5\nM30\n", "part.mpf").dialect, kSiemens);
}

TEST(Sinumerik, EndsAndWhatFollows) {
  EXPECT_TRUE(read_as(kSiemens, kStart + "M17").ended);
  EXPECT_TRUE(read_as(kSiemens, kStart + "RET").ended);
  EXPECT_EQ(names_of(read_as(kSiemens, kStart + "G0 X1")), "program-end@4");
  const Program program = read_as(kSiemens, kStart + "M30\nG1 X5\n");
  ASSERT_EQ(program.diagnostics.items().size(), 1U);
  EXPECT_THAT(program.diagnostics.items()[0].what, HasSubstr("is not run"));
}

}  // namespace
}  // namespace clearcut::read::gcode
