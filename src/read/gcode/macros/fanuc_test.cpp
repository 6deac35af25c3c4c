// Habits of Fanuc's and Haas's programs that compute, jump and call.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "read/gcode/macros/macro_line.h"
#include "read/gcode/test_told_program.h"

namespace clearcut::read::gcode {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::string kHead = "%\nO0001\nG21 G17 G90 G61\nG0 X0. Y0.\nZ5.\nF100.\n";

std::string ends_as(Dialect dialect, const std::string& text) {
  std::string told;
  const Program read = read_as(dialect, text);
  for (const Section& section : read.toolpath.sections)
    for (const Move& move : section.moves)
      if (!is_rapid(move.kind)) told += "|" + trimmed(move.path.to.x, 3) + " " + trimmed(move.path.to.y, 3);
  return told;
}
std::string ends(const std::string& text) {
  return ends_as(Dialect::kFanuc, kHead + text);
}
std::string refusal_as(Dialect dialect, const std::string& text) {
  try {
    read_as(dialect, text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "read";
}

TEST(FanucMacros, VariablesAndFunctions) {
  EXPECT_EQ(ends("#1 = 3.\n#2 = #1 + 2. * 4.\nG1 X#1 Y[#2 - 1.]\nX[SQRT[16.]]\nM30\n%\n"), "|3 10|4 10");
}

TEST(FanucMacros, JumpsAndLoops) {
  EXPECT_EQ(ends("#1 = 1\nN10 G1 X#1\n#1 = #1 + 1\nIF [#1 LE 3] GOTO 10\nM30\n%\n"), "|1 0|2 0|3 0");
  EXPECT_EQ(ends("#1 = 0\nWHILE [#1 LT 2] DO1\n#1 = #1 + 1\nG1 Y#1\nEND1\nGOTO 99\nG1 X9.\nN99 M30\n%\n"),
            "|0 1|0 2");
  EXPECT_EQ(ends("#1 = 5\nIF [[#1 EQ 5] AND [#1 GT 2]] THEN #2 = 7\nG1 X#2\nM30\n%\n"), "|7 0");
}

TEST(FanucMacros, SubprogramsInOneFile) {
  EXPECT_EQ(ends("M98 P0021000\nG1 Y9.\nM30\nO1000\nG91 G1 X1.\nG90\nM99\n%\n"), "|1 0|2 0|2 9");
  EXPECT_EQ(ends("M98 P1000 L3\nM30\nO1000\nG91 G1 X1.\nG90\nM99\n%\n"), "|1 0|2 0|3 0");
  EXPECT_EQ(ends_as(Dialect::kHaas, kHead + "M97 P200 L2\nM30\nN200 G91 G1 X1.\nG90\nM99\n%\n"), "|1 0|2 0");
  EXPECT_EQ(ends_as(Dialect::kMach3, kHead + "M98 P1000 L2\nM30\nO1000\nG91 G1 X1.\nG90\nM99\n%\n"),
            "|1 0|2 0");
}

TEST(FanucMacros, ArgumentsOfG65) {
  EXPECT_EQ(ends("G65 P9000 A1. B2. X4.\nG65 P9000 A2. B3.\nM30\nO9000\nG1 X#1 Y#2\n"
                 "IF [#24 EQ #0] GOTO 5\nX#24\nN5 M99\n%\n"),
            "|1 2|4 2|2 3");
  EXPECT_EQ(ends("G65 P9000 I1. J2. I3.\nM30\nO9000\nG1 X#4 Y#7\nM99\n%\n"), "|1 3");
}

TEST(FanucMacros, VacantVariablesLeaveTheirWordOut) {
  const Program read = read_as(Dialect::kFanuc, kHead + "G1 X4. Y#101\nM30\n%\n");
  EXPECT_THAT(names_of(read), HasSubstr("parameter-101@7"));
  EXPECT_EQ(ends("G1 X4. Y#101\nM30\n%\n"), "|4 0");
}

TEST(FanucMacros, RotationMirrorAndPolarPlaces) {
  EXPECT_EQ(ends("G68 X0. Y0. R90.\nG1 X10.\nY5.\nG69\nX1.\nM30\n%\n"), "|0 10|-5 10|1 10");
  EXPECT_EQ(ends("G51.1 X0.\nG1 X10. Y1.\nG50.1 X0.\nX3.\nM30\n%\n"), "|-10 1|3 1");
  EXPECT_EQ(ends("G16\nG1 X10. Y90.\nY0.\nG15\nX1.\nM30\n%\n"), "|0 10|10 0|1 0");
}

TEST(FanucMacros, MirroredArcsTurnTheOtherWay) {
  const std::string text = kHead + "G51.1 X0.\nG1 X10. Y0.\nG3 X0. Y10. I-10. J0.\nM30\n%\n";
  EXPECT_THAT(moves_as(Dialect::kFanuc, text), HasSubstr("cut to 0 10 5 cw about 0 0"));
}

/// G51 scales about the place that it states, or about where the axis is; G50 ends it.
TEST(FanucMacros, ScalesPlacesArcsAndHeights) {
  EXPECT_EQ(ends("G51 X10. Y0. I2000 J2000\nG1 X20. Y5.\nG91 X1.\nG90 G50\nX3.\nM30\n%\n"),
            "|30 10|32 10|3 10");
  EXPECT_EQ(ends_as(Dialect::kHaas, kHead + "G51 X10. Y0. Z0. P2\nG1 X20. Y5.\nG50\nX3.\nM30\n%\n"),
            "|30 10|3 10");
  EXPECT_EQ(ends_as(Dialect::kMach3,
                    "G21 G17 G90 G61 G91.1\nG0 X0 Y0\nZ5\nF100\nG51 X2 Y3\nG1 X2 Y1\nG50\nX3\nM30\n"),
            "|4 3|3 3");
  const std::string arc =
      "G51 X0. Y0. Z5. P0.5\nG1 X10. Y0. Z3.\nG3 X0. Y10. I-10. J0.\nX-10. Y0. R10.\nM30\n%\n";
  EXPECT_THAT(moves_as(Dialect::kHaas, kHead + arc),
              HasSubstr("cut to 0 5 4 ccw about 0 0 F100\ncut to -5 0 4 ccw about 0 0 F100"));
  EXPECT_THAT(names_of(read_as(Dialect::kFanuc, kHead + "G51 X0. Y0. P2000\nG1 X1.\nM30\n%\n")),
              HasSubstr("scaling@7"));
  EXPECT_THAT(
      moves_as(Dialect::kFanuc, kHead + "G51 X0. Y0. I-1. J1.\nG1 X10. Y0.\nG3 X0. Y10. I-10. J0.\nM30\n%\n"),
      HasSubstr("cut to 0 10 5 cw about 0 0"));
}

TEST(FanucMacros, ScalingIsRefusedWhereItMeansNothingSure) {
  const auto refused = [](const std::string& text) { return refusal_as(Dialect::kFanuc, kHead + text); };
  EXPECT_THAT(refused("G51 X0. Y0.\nM30\n"), HasSubstr("without its factor P"));
  EXPECT_THAT(refused("G51 X0. Y0. P0\nM30\n"), HasSubstr("impossible factor P"));
  EXPECT_THAT(refused("G68 X0. Y0. R30.\nG51 X0. Y0. P2.\nM30\n"), HasSubstr("G51 while G68 is in force"));
  EXPECT_THAT(refused("G51 X0. Y0. P2.\nG68 X0. Y0. R30.\nM30\n"), HasSubstr("G68 while G51 is in force"));
  EXPECT_THAT(refused("G51 X0. Y0. P2.\nG81 X1. Z-2. R1.\nM30\n"), HasSubstr("G51 scales heights"));
  EXPECT_THAT(refused("G51 X0. Y0. I2. J3.\nG2 X5. Y5. I5. J0.\nM30\n"),
              HasSubstr("scales X and Y differently"));
  EXPECT_THAT(refusal_as(Dialect::kMach4, "G21 G90\nG0 X1\nG51 P2\nM30\n"), HasSubstr("G51 is not read"));
  EXPECT_THAT(refusal_as(Dialect::kLinuxCnc, "G21 G90\nG0 X1\nG51 P2\nM2\n"),
              HasSubstr("G51 is no word of linuxcnc"));
  EXPECT_EQ(ends("G51.1 X0.\nG69\nG1 X1.\nM30\n%\n"), "|-1 0") << "G69 ends rotations alone";
}

/// The bar goes aside before it comes out, or the operator takes it out: the path is that of the hole.
TEST(FanucMacros, BoringCyclesComeOutAsTheyAreSaidTo) {
  const std::string hole = "X10. Z-12. R2. Q0.2 F100.\nG80\nM30\n%\n";
  const std::string bored = "\nrapid to 10 0 5\nrapid to 10 0 2\nplunge to 10 0 -12 F100\nrapid to 10 0 5";
  for (const Dialect dialect : {Dialect::kFanuc, Dialect::kHaas, Dialect::kMazak}) {
    SCOPED_TRACE(name_of(dialect));
    const std::string fine = kHead + "G98 G76 " + hole, by_hand = kHead + "G98 G88 " + hole;
    EXPECT_THAT(moves_as(dialect, fine), HasSubstr(bored));
    EXPECT_THAT(conditions_as(dialect, fine), HasSubstr("oriented-retract@7"));
    EXPECT_THAT(moves_as(dialect, by_hand), HasSubstr(bored));
    EXPECT_THAT(conditions_as(dialect, by_hand), HasSubstr("manual-retract@7"));
  }
  EXPECT_THAT(refusal_as(Dialect::kFanuc, kHead + "G87 " + hole), HasSubstr("G87 bores from below"));
  EXPECT_THAT(refusal_as(Dialect::kHaas, kHead + "G77 " + hole), HasSubstr("G77 bores from below"));
  EXPECT_THAT(conditions_as(Dialect::kHaas, kHead + "G98 G87 " + hole), HasSubstr("manual-retract@7"));
  EXPECT_THAT(refusal_as(Dialect::kLinuxCnc, "G21 G90\nG0 X0 Y0\nZ5\nG88 X1 Z-2 R1 P1\nM2\n"),
              HasSubstr("G88 does nothing that LinuxCNC states"));
}

TEST(FanucMacros, PeckTappingTurnsBackAtEachDepth) {
  const std::string text = kHead + "M29 S500\nG98 G84 X10. Z-6. R2. Q4. F500.\nG80\nM30\n%\n";
  EXPECT_THAT(
      moves_as(Dialect::kFanuc, text),
      HasSubstr(
          "plunge to 10 0 -2 F500\nretract to 10 0 2 F500\nplunge to 10 0 -6 F500\nretract to 10 0 2 F500"));
  const Program read = read_as(Dialect::kFanuc, text);
  EXPECT_EQ(
      std::count_if(read.control.events.begin(), read.control.events.end(),
                    [](const ControlEvent& event) { return event.kind == ControlEventKind::kTapTurnsBack; }),
      2);
}

TEST(FanucMacros, ReturnsToAStatedBlock) {
  EXPECT_EQ(ends("M98 P1000\nG1 X5.\nN20 G1 Y3.\nM30\nO1000\nM99 P20\n%\n"), "|0 3");
}

TEST(FanucMacros, MeasuredMovesAndModes) {
  const std::string text = kHead + "G31 Z-10. F50.\n#110 = #4003\nG91 G1 X1.\nG#110\nG1 X9.\nM30\n%\n";
  EXPECT_THAT(names_of(read_as(Dialect::kFanuc, text)), HasSubstr("measured-move@7"));
  EXPECT_EQ(ends_as(Dialect::kFanuc, text), "|1 0|9 0");
}

TEST(FanucMacros, AnglesOfTwoSidesInBothForms) {
  EXPECT_EQ(ends("#1 = ATAN[3.,-3.]\nG1 X#1 Y[ATAN[3.]/[-3.]]\nX[ATAN[1.]]\nM30\n%\n"), "|135 135|45 135");
  const std::string below = kHead + "G1 X[ATAN[-3.]/[-3.]]\nM30\n%\n";
  EXPECT_EQ(ends_as(Dialect::kFanuc, below), "|225 0");
  EXPECT_EQ(ends_as(Dialect::kHaas, below), "|-135 0");
  EXPECT_THAT(names_of(read_as(Dialect::kFanuc, below)), HasSubstr("atan-range@7"));
  EXPECT_THAT(refusal_as(Dialect::kFanuc, kHead + "#1 = ATAN[3.,\nM30\n"), HasSubstr("a number is missing"));
  EXPECT_THAT(refusal_as(Dialect::kLinuxCnc, "G21 G90\n#1 = atan[3,4]\nM2\n"),
              HasSubstr("ATAN asks for two brackets"));
}

TEST(FanucMacros, PrintingMovesNothing) {
  const std::string text =
      "POPEN\nN20 DPRNT[HOLE*X#101[34]*Y#102[34]]\nG1 X3.\nBPRNT[A#101[0]]\nPCLOS\nM30\n%\n";
  EXPECT_EQ(ends(text), "|3 0");
  EXPECT_EQ(ends_as(Dialect::kHaas, kHead + text), "|3 0");
  EXPECT_THAT(refusal_as(Dialect::kMach3, "G21 G90\nG0 X1\nPOPEN\nM30\n"),
              HasSubstr("POPEN is no word of Mach3"));
}

TEST(FanucMacros, RefusalsSayWhatToDo) {
  const auto refused = [](const std::string& text) { return refusal_as(Dialect::kFanuc, kHead + text); };
  EXPECT_THAT(refused("GOTO 77\nM30\n"), HasSubstr("test.ngc:7: there is no block N77 in this program"));
  EXPECT_THAT(refused("G66 P9000 A1.\nM30\n"), HasSubstr("G66 calls a macro after every move"));
  EXPECT_THAT(refused("G1 X#530\nM30\n"), HasSubstr("#530 keeps a value in the control"));
  EXPECT_THAT(refused("#5221 = 3.\nM30\n"), HasSubstr("set offsets by G10"));
  EXPECT_THAT(refused("IF [#1 EQ 1 AND #2 EQ 2] GOTO 1\nN1 M30\n"),
              HasSubstr("two comparisons in one bracket"));
  EXPECT_THAT(refused("M98 P1000\nM30\nO1000\nG1 X1.\n%\n"), HasSubstr("the subprogram has no M99"));
  EXPECT_THAT(refusal_as(Dialect::kGrbl, "G21 G90\nG0 X#1\n"), HasSubstr("are no words of the control"));
}

TEST(FanucMacros, SwitchesOfBlockDeleteAreOneCondition) {
  const std::string text = kHead + "/2 G1 X3.\n#1 = 2\n/3 G1 X5.\nM30\n%\n";
  EXPECT_EQ(ends_as(Dialect::kHaas, text), "|3 0|5 0");
  EXPECT_THAT(names_of(read_as(Dialect::kFanuc, text)), HasSubstr("block-delete@7"));
  EXPECT_THAT(refusal_as(Dialect::kLinuxCnc, "G21 G90\n/2 G0 X1\nM2\n"), HasSubstr("'/2' names a switch"));
  EXPECT_THAT(refusal_as(Dialect::kFanuc, kHead + "M97 P5\nM30\nN5 M99\n"),
              HasSubstr("M97 is a word of Haas's"));
}

TEST(FirstMacroLine, IsThatOfTheFirstWordThatComputesOrCalls) {
  EXPECT_EQ(first_macro_line("G0 X1\nG1 X2 F100\nM30\n"), 0);
  EXPECT_EQ(first_macro_line("G0 X1\nG1 X#2 F100\n"), 2);
  EXPECT_EQ(first_macro_line("G0 X1\n\nM98 P100\n"), 3);
  EXPECT_EQ(first_macro_line("o100 sub\n"), 1);
}

TEST(FanucMacros, RecognisedByTheirWords) {
  EXPECT_EQ(read_gcode("G21 G90 G0 X0. Y0.\n#1=1\nN1 IF [#1 GT 3] GOTO 9\nN9 M30\n", "t").dialect,
            Dialect::kFanuc);
  EXPECT_EQ(read_gcode("G21 G90 G0 X0. Y0.\nM97 P5\nM30\nN5 M99\n", "t").dialect, Dialect::kHaas);
  EXPECT_EQ(read_gcode("G21 G90 G0 X0 Y0\no1 if [1]\no1 endif\nM2\n", "t").dialect, Dialect::kLinuxCnc);
}

}  // namespace
}  // namespace clearcut::read::gcode
