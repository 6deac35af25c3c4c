// What the machine must hold, what each control does with the same words, and what is kept beside the moves.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "read/gcode/recognise.h"
#include "read/gcode/test_told_program.h"

namespace clearcut::read::gcode {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string refusal(Dialect dialect, const std::string& text) {
  try {
    read_as(dialect, text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(GcodeConditions, UnknownWordsAreOnesByName) {
  EXPECT_EQ(conditions("G21 M55\nM55\nG64\nG0 X0 Y0 Z1\nG1 X5 F9\nM2"), "m55@1 blending@5");
}

TEST(GcodeConditions, WordsThatTheControlStopsAt) {
  const std::string start = "G21 G61 G17 G90 G0 X0. Y0. Z5.\n";
  EXPECT_EQ(conditions(start + "M10\nM9\nM11\nM2"), "m10@2 m11@4");
  EXPECT_EQ(conditions(start + "M150\nM2"), "m150@2") << "one of the user's own";
  EXPECT_EQ(conditions(start + "M48\nM50 P1\nM62 P0\nM2"), "");
  EXPECT_EQ(conditions_as(Dialect::kFanuc, start + "M10\nM30"), "");
  EXPECT_EQ(conditions_as(Dialect::kMarlin, start + "M48\n"), "m48@2");
}

TEST(GcodeConditions, SpindleAndFloodAtOnceIsAWordOfFewControls) {
  const std::string program = "G21 G61 G17 G90 S9000 M13\nG0 X0. Y0. Z5.\nG1 X5. F9.\nM30";
  const auto spindle = [&](Dialect dialect) {
    return read_as(dialect, program).control.spans.back().state.spindle;
  };
  EXPECT_EQ(spindle(Dialect::kFanuc), SpindleState::kClockwise);
  EXPECT_EQ(conditions_as(Dialect::kFanuc, program), "m13@1");
  for (const Dialect dialect : {Dialect::kLinuxCnc, Dialect::kGrbl, Dialect::kHaas, Dialect::kMach3,
                                Dialect::kMach4, Dialect::kMarlin}) {
    EXPECT_EQ(spindle(dialect), SpindleState::kOff) << name_of(dialect);
    EXPECT_THAT(conditions_as(dialect, program), HasSubstr("m13@1")) << name_of(dialect);
  }
}

TEST(GcodeConditions, DwellsThatNobodyMeans) {
  const std::string start = "G21 G61 G17 G90 G0 X0. Y0. Z5.\n";
  EXPECT_EQ(conditions(start + "G4 P5000\nM2"), "dwell@2") << "seconds";
  EXPECT_EQ(conditions(start + "G4 P0\nG4 P0.01\nG4 P2\nG4 P60\nM2"), "");
  EXPECT_EQ(conditions_as(Dialect::kFanuc, start + "G4 P0.5\nM30"), "dwell@2") << "milliseconds";
  EXPECT_EQ(conditions_as(Dialect::kFanuc, start + "G4 P5000\nG4 X2.\nG4 P0\nM30"), "");
  EXPECT_EQ(conditions_as(Dialect::kHaas, start + "G4 P2\nM30"), "dwell@2");
  EXPECT_EQ(conditions_as(Dialect::kHaas, start + "G4 P2.\nG4 P2000\nM30"), "");
  EXPECT_EQ(conditions_as(Dialect::kHaas, start + "G4 P2000.\nM30"), "dwell@2");
  EXPECT_EQ(conditions_as(Dialect::kMarlin, start + "G4 S2\nG4 P2000\n"), "");
  EXPECT_EQ(conditions(start + "F9\nG98 G82 X1 Y1 R1 Z-1 P500\nG80\nM2"), "dwell@3");
  EXPECT_EQ(conditions(start + "F9\nG98 G82 X1 Y1 R1 Z-1 P0.5\nG80\nM2"), "");
}

TEST(GcodeConditions, WordsThatLostWhatUsesThem) {
  const std::string start = "G21 G61 G17 G90 G0 X0 Y0 Z5 F9 S100\n";
  EXPECT_EQ(conditions(start + "G1 X5 J2\nM2"), "stray-word@2");
  EXPECT_EQ(conditions(start + "G98 G81 X1 Y1 R1 Z-1 K3\nG80\nM2"), "stray-word@2");
  EXPECT_EQ(conditions(start + "G98 G81 X1 Y1 R1 Z-1\nG84\nG80\nM2"), "stray-word@3");
  EXPECT_EQ(conditions(start + "M7 M8\nM2"), "stray-word@2");
  EXPECT_EQ(
      conditions(start + "G2 X2 Y2 I1 J1 K0\nX0 Y0 R3\nG64 P0.01 Q0\nG4 P1\nG10 L2 P0 R0\nM62 P1\nM3 M8\nM2"),
      "g10@6");
  EXPECT_EQ(conditions(start + "G98 G83 X1 Y1 R1 Z-1 Q1\nX2 L2\nG82 X1 Y1 R1 Z-1 P1\nG80\nM2"), "");
  EXPECT_EQ(conditions_as(Dialect::kGrbl, start + "G1 X5 P2\n"), "stray-word@2");
  EXPECT_EQ(conditions_as(Dialect::kGrbl, start + "G4 P2\nG10 L2 P1 X0\nG2 X2 Y2 I1 J1\n"), "g10@3");
  EXPECT_EQ(conditions_as(Dialect::kHaas, "G21 G61 G17 G90 G0 X0. Y0. Z5. F9.\nG1 X5. J2.\nM30"), "")
      << "takes no notice";
}

TEST(GcodeConditions, WordsThatTheControlStopsAtWithoutAPlace) {
  const std::string start = "G21 G61 G17 G90 G0 X0 Y0 Z5 F9 S100\n";
  for (const char* word :
       {"G2", "G3", "G33", "G33.1", "G38.2", "G52", "G53", "G76", "G87", "G88", "G92", "M62", "M65"})
    EXPECT_EQ(conditions(start + word + "\nG1 X5\nM2"), "stray-word@2") << word;
  for (const char* word : {"G2 I1", "G0", "G1", "G2 X2 I1", "G53 G0 X0"})
    EXPECT_THAT(conditions(start + word + "\nG1 X5\nM2"), Not(HasSubstr("stray-word"))) << word;
  for (const char* word : {"G2", "G38.2", "G92"})
    EXPECT_EQ(conditions_as(Dialect::kGrbl, start + word + "\nG1 X5\n"), "stray-word@2") << word;
  EXPECT_EQ(conditions_as(Dialect::kFanuc, "G21 G61 G17 G90 G0 X0. Y0. Z5. F9.\nG2\nG1 X5.\nM30"), "");
}

TEST(GcodeConditions, WordsThatLinuxCncDoesNotTakeTogether) {
  const std::string start = "G21 G61 G17 G90 G0 X0 Y0 Z5 F9 S100\n";
  for (const char* words : {"M3 M73", "M70 M72", "M6 M61 Q0", "M62 M64 P1", "M3 M8 M48 M0 M6",
                            "G4 P1 G53 G0 X0", "G43 G49", "G4 P1 G2 X2 I1"})
    EXPECT_THAT(conditions(start + words + "\nM2"), HasSubstr("stray-word@2")) << words;
  for (const char* words :
       {"M3 M8 M48", "M6 M3", "M0 M70", "G53 G0 X0", "G2 X2 I1 P1", "G2 X0 I1 P2", "G90 G91.1"})
    EXPECT_THAT(conditions(start + words + "\nM2"), Not(HasSubstr("stray-word"))) << words;
  EXPECT_EQ(conditions("G21 G61 G17 G90 G0 X0 Y0 Z5\nG1\nX5 F9\nM2"), "stray-word@2");
  EXPECT_EQ(conditions("G21 G61 G17 G90 G0 X0 Y0 Z5\nG1 F9\nX5\nM2"), "");
}

TEST(GcodeConditions, WordsThatLinuxCncDoesNotHave) {
  for (const char* word : {"G9", "G15", "G50", "G69"}) {
    EXPECT_THAT(refusal(Dialect::kLinuxCnc, word), HasSubstr("is no word of linuxcnc")) << word;
    EXPECT_EQ(refusal(Dialect::kHaas, word), "") << word;
    EXPECT_EQ(recognised("G90 G17\n" + std::string(word) + "\nG0 X1.\nM30\n", "").dialect, Dialect::kFanuc)
        << word;
  }
  EXPECT_EQ(conditions("G21 G61 G17 G90 G0 X0 Y0 Z5\nM117\nM2"), "m117@2");
}

TEST(GcodeDialects, CommentsNameTheControl) {
  const auto control = [](const std::string& text) { return recognised(text, "").dialect; };
  const std::string cut = "\nG21 G90\nM3 S5000\nG0 X1. Y1.\nG1 Z-1. F100.\nM30\n";
  EXPECT_EQ(control("(plate)" + cut), Dialect::kLinuxCnc);
  EXPECT_EQ(control("(Post processor: Mach3.post)" + cut), Dialect::kMach3);
  EXPECT_EQ(control("( for Mach2/3 from Vectric )" + cut), Dialect::kMach3);
  EXPECT_EQ(control("; Post processor: grbl" + cut), Dialect::kGrbl);
  EXPECT_EQ(control("(Post Processor: grbl_post)" + cut), Dialect::kGrbl);
  EXPECT_EQ(control("; GRBL device profile, absolute coords" + cut), Dialect::kGrbl);
  EXPECT_EQ(control("%\nO0001 (PLATE)\n(HAAS VF2)" + cut), Dialect::kHaas);
  EXPECT_EQ(control("%\nO0001 (PLATE)\n(MAZAK)" + cut), Dialect::kMazak);
  EXPECT_EQ(control("(grblHAL 1.1f)\nT1 M6\nG81 X1. Y1. Z-1. R1. F100.\nG80" + cut), Dialect::kGrblHal);
  EXPECT_EQ(control("(FOR GRBLHAL)\nT1 M6" + cut), Dialect::kGrblHal);
  // Two names, words that Grbl has not, and words of one control are stronger.
  EXPECT_EQ(control("%\nO0001 (FROM HAAS TO MAZAK)" + cut), Dialect::kFanuc);
  EXPECT_EQ(control("; grbl\nG81 X1. Y1. Z-1. R1. F100.\nG80" + cut), Dialect::kLinuxCnc);
  EXPECT_EQ(control("(mach3)\nG64 P0.01" + cut), Dialect::kLinuxCnc);
}

TEST(GcodeDialects, PathPilotsPostsSwitchScalesOff) {
  const auto begin = [](const std::string& words) {
    return recognised(
               "G90 G54 " + words + " G17 G40 G80 G94 G91.1 G49\nG21\nG30\nT1 G43 H1 M6\nS5000 M3\nM30\n", "")
        .dialect;
  };
  EXPECT_EQ(begin("G64 G50"), Dialect::kTormach);
  EXPECT_EQ(begin("G64 P0.01 G50"), Dialect::kTormach);
  EXPECT_EQ(begin("G64 P0.01"), Dialect::kLinuxCnc);
}

/// LinuxCNC stops at the next feed move without F, although the mode is the one that was in force.
TEST(GcodeDialects, TheWordOfAFeedModeEndsTheFeed) {
  const auto feed = [](Dialect dialect, const std::string& end) {
    const std::string start = "G21 G61 G17 G90 G94 G0 X0. Y0. Z5.\nG1 X5. F9.\nG94\n";
    return read_as(dialect, start + end + "\nM30").toolpath.sections.back().moves.back().feed.mm_per_min();
  };
  for (const Dialect dialect : {Dialect::kLinuxCnc, Dialect::kTormach}) {
    EXPECT_EQ(feed(dialect, "X9."), 0) << name_of(dialect);
    EXPECT_EQ(feed(dialect, "X9. F9."), 9) << name_of(dialect);
  }
  for (const Dialect dialect : {Dialect::kGrbl, Dialect::kFanuc, Dialect::kHaas, Dialect::kMach3})
    EXPECT_EQ(feed(dialect, "X9."), 9) << name_of(dialect);
}

/// In a hole, below R: Fanuc, Haas and Mazak go to the next one at this height, NIST's interpreter goes up before.
TEST(GcodeDialects, ACycleBegunBelowItsR) {
  const auto first_height = [](Dialect dialect) {
    const Program read =
        read_as(dialect, "G21 G61 G17 G90 G94 G98 G0 X0. Y0. Z-1.\nG81 X9. Z-3. R1. F9.\nG80\nM30");
    const std::vector<Move>& moves = read.toolpath.sections.back().moves;
    const auto over =
        std::find_if(moves.begin(), moves.end(), [](const Move& move) { return move.path.to.x == 9; });
    return over->z_from;
  };
  for (const Dialect dialect : {Dialect::kFanuc, Dialect::kHaas, Dialect::kMazak})
    EXPECT_EQ(first_height(dialect), -1) << name_of(dialect);
  for (const Dialect dialect : {Dialect::kLinuxCnc, Dialect::kMach3, Dialect::kMach4})
    EXPECT_EQ(first_height(dialect), 1) << name_of(dialect);
}

TEST(GcodeConditions, RepeatsOfACycleAreNoLength) {
  const std::string start = "G21 G61 G17 G90 G94 G98 G0 X0. Y0. Z5. F9.\n";
  EXPECT_EQ(conditions_as(Dialect::kFanuc, start + "G91 G81 X9. Z-8. R-4. K3\nG80\nM30"), "");
  EXPECT_EQ(conditions_as(Dialect::kFanuc, start + "G91 G81 X9. Z-8 R-4. K3\nG80\nM30"), "decimal-point@2");
}

TEST(GcodeConditions, ACutterThatStaysInTheWork) {
  const std::string start = "G21 G61 G17 G90 G0 X0. Y0. Z5. F9.\nG1 Z-1.\n";
  EXPECT_EQ(conditions(start + "M2"), "ends-low@3");
  EXPECT_EQ(conditions(start + "G0 Z5\nM2"), "");
  EXPECT_EQ(conditions_as(Dialect::kFanuc, start + "G91 G28 Z0.\nM30"), "");
}

TEST(GcodeState, LengthsWithoutANumberAreThoseBeforeOnFanucAndHaas) {
  const std::string program = "G21 G61 G17 G90 T2 M6\nG0 X0. Y0.\nG43 H1 Z5.\nG49\nG43 Z5.\nG1 X1. F9.\nM30";
  const auto length = [&](Dialect dialect) {
    const ToolLength last = read_as(dialect, program).control.spans.back().state.length;
    return last.kind == LengthKind::kOff ? 0 : last.h;
  };
  EXPECT_EQ(length(Dialect::kFanuc), 1);
  EXPECT_EQ(length(Dialect::kHaas), 1);
  EXPECT_EQ(length(Dialect::kLinuxCnc), 2) << "that of the tool";
}

TEST(GcodeConditions, WhatTheMachineHoldsIsNamed) {
  const std::string start = "G21 G61 G90 G0 X0 Y0 Z5\n";
  EXPECT_EQ(conditions(start + "M2"), "");
  EXPECT_EQ(conditions("G61 G90 G0 X0 Y0 Z5\nM2"), "units@1");
  EXPECT_EQ(conditions(start + "G55 X1\nG56\nG54\nM2"), "g55@2 g56@3");
  EXPECT_EQ(conditions(start + "G92 X5\nM2"), "g92@2");
  EXPECT_EQ(conditions(start + "G52 X5\nG52 X0\nM2"), "g52@2");
  EXPECT_EQ(conditions(start + "G10 L2 P1 X3\nM2"), "g10@2");
  EXPECT_EQ(conditions(start + "/G0 X9\nM2"), "block-delete@2");
  EXPECT_EQ(conditions(start + "G28\nM2"), "g28-home@2");
  EXPECT_EQ(conditions(start + "G30 Z9\nM2"), "g30-home@2");
  EXPECT_EQ(conditions(start + "G43.1 Z1\nG1 X5 F1\nM2"), "tool-length-g43.1@2");
  EXPECT_EQ(conditions(start + "G43 H1\nG43.2 H9\nG1 X5 F1\nM2"), "tool-length-g43.2@3");
  EXPECT_EQ(conditions(start + "G43 H1\nG43.2 Z0.25\nG1 X5 F1\nM2"), "");
  EXPECT_THAT(message_of(start + "G43.2\nM2"), HasSubstr("give one of them"));
  EXPECT_THAT(message_of(start + "G43.2 X1 Z1\nM2"), HasSubstr("G43.2 with X or Y"));
  EXPECT_EQ(conditions(start + "T1 M6\nG43 H5\nG1 X5 F1\nM2"), "tool-length-h5@4");
  EXPECT_EQ(conditions(start + "T1 M6\nG43 H1\nG1 X5 F1\nG49\nX2\nM2"), "tool-length-off@6");
  EXPECT_EQ(conditions_as(Dialect::kFanuc, start + "G54.1 P2\nM2"), "decimal-point@1 g54.1-p2@2");
  EXPECT_EQ(conditions(start + "T1\nG1 X5 F1\nT2 M6\nM2"), "tool-in-spindle@3");
  EXPECT_EQ(conditions(start + "T1\nG1 X5 F1\nM2"), "") << "put in by hand";
  EXPECT_EQ(conditions(start + "T1\nM0\nG1 X5 F1\nM2"), "");
  EXPECT_EQ(conditions_as(Dialect::kGrbl, start + "T1\nG1 X5 F1\n"), "");
  EXPECT_EQ(conditions(start + "G0 Z1\n"), "program-end@2");
  EXPECT_EQ(conditions(start + "M99\n"), "m99@2");
  EXPECT_THAT(message_of(start + "M99 P3\n"), HasSubstr("test.ngc:2: M99 P jumps"));
}

TEST(GcodeConditions, InchesOfMarlinNeedFirmwareThatHasThem) {
  const std::string start = "G90 G0 X0 Y0 Z1\n";
  EXPECT_EQ(conditions_as(Dialect::kMarlin, "G20\n" + start), "g20@1");
  EXPECT_EQ(conditions_as(Dialect::kMarlin, "G21\n" + start), "");
  EXPECT_EQ(conditions_as(Dialect::kGrbl, "G20\n" + start), "");
}

TEST(GcodeConditions, HomeIsNoneWhereItIsTheTopOfTheTravel) {
  const std::string start = "G21 G61 G17 G90 G0 X0. Y0. Z5.\nG1 X5. F9.\n";
  EXPECT_EQ(conditions_as(Dialect::kFanuc, start + "G91 G28 Z0.\nG90\nM30"), "");
  EXPECT_EQ(conditions_as(Dialect::kHaas, start + "G53 G0 Z0.\nM30"), "");
  EXPECT_EQ(conditions_as(Dialect::kHaas, start + "G53 G0 Z-9.\nM30"), "g53@3");
  EXPECT_EQ(conditions_as(Dialect::kHaas, start + "G53 G0 Z0.\nG53 G0 X0. Y0.\nM30"), "");
  EXPECT_EQ(conditions_as(Dialect::kHaas, start + "G53 G0 X0. Y0.\nM30"), "g53@3");
  EXPECT_EQ(conditions_as(Dialect::kHaas, start + "G53 G0 Z0.\nG53 G0 X0. Y0.\nG90 G0 Z1.\nM30"), "g53@5");
  EXPECT_EQ(conditions_as(Dialect::kFanuc, start + "G91 G28 X0. Y0. Z0.\nM30"), "g28-home@3");
  EXPECT_EQ(conditions_as(Dialect::kFanuc, start + "G91 G28 Z0.\nG28 X0. Y0.\nM30"), "");
  EXPECT_EQ(conditions_as(Dialect::kFanuc, start + "G91 G28 Z0.\nG28 X0. Y0.\nG90 G0 Z1.\nM30"),
            "g28-home@5");
}

TEST(GcodeConditions, OffsetsThatAreCalledByANumber) {
  const std::string start = "G21 G61 G17 G90 G0 X0. Y0. Z5.\n";
  EXPECT_EQ(conditions_as(Dialect::kHaas, start + "G154 P7\nG110\nG129\nM30"),
            "g154-p7@2 g154-p1@3 g154-p20@4");
  EXPECT_EQ(conditions_as(Dialect::kMach4, "G91.1\n" + start + "G54.1 P248\nM30"), "g54.1-p248@3");
  EXPECT_EQ(conditions_as(Dialect::kMach3, "G91.1\n" + start + "G59 P2\nG59 P20\nG59\nM30"),
            "g55@3 g59-p20@4 g59@5");
  EXPECT_EQ(conditions_as(Dialect::kLinuxCnc, start + "G59.1\nM2"), "g59.1@2");
  EXPECT_EQ(conditions_as(Dialect::kFanuc, start + "G54 P12\nG54 G4 P500\nM30"), "g54.1-p12@2");
  EXPECT_THAT(refusal(Dialect::kFanuc, start + "G54.1 P301\nM30"),
              HasSubstr("G54.1 P301: the control has P1 to P300"));
  EXPECT_THAT(refusal(Dialect::kHaas, start + "G154 P1.5\nM30"),
              HasSubstr("G154 P1.5: the control has P1 to P99"));
  EXPECT_THAT(refusal(Dialect::kFanuc, start + "G54.1\nM30"), HasSubstr("without its P word"));
  EXPECT_THAT(refusal(Dialect::kFanuc, start + "G59.1\nM30"), HasSubstr("test.ngc:2: G59.1"));
  EXPECT_THAT(refusal(Dialect::kFanuc, start + "G110\nM30"), HasSubstr("test.ngc:2: G110"));
}

/// Where the machine states its offsets, those beyond them still lie where the work is, whatever was in use before.
TEST(GcodeConditions, NumberedOffsetsLieAtTheWorkBesideStatedOnes) {
  ReadControllerOptions options;
  options.dialect = Dialect::kFanuc;
  options.places = MachinePlaces{};
  options.places->origins[1] = {100, 0, 0};
  const Program program =
      read_gcode("G21 G61 G17 G90 G94 G0 X0. Y0. Z5.\nG55\nG1 X1. F9.\nG54.1 P2\nX2.\nM30\n", "t", options);
  std::vector<double> xs;
  for (const Move& move : program.toolpath.sections.back().moves)
    if (!is_rapid(move.kind)) xs.push_back(move.path.to.x);
  EXPECT_EQ(xs, (std::vector<double>{101, 2}));
}

TEST(GcodeDialects, MeanWhatTheirControlDoes) {
  const std::string start = "G21 G61 G17 G90 G0 X0. Y0.\nZ5.\n";
  EXPECT_EQ(moves_as(Dialect::kLinuxCnc, start + "F9 G81 X1. Z-1. R2.\nM2"),
            "\nrapid to 0 0 5\nrapid to 1 0 5\nrapid to 1 0 2\nplunge to 1 0 -1 F9\nrapid to 1 0 2");
  EXPECT_EQ(moves_as(Dialect::kFanuc, start + "F9. G81 X1. Z-1. R2.\nM30"),
            "\nrapid to 0 0 5\nrapid to 1 0 5\nrapid to 1 0 2\nplunge to 1 0 -1 F9\nrapid to 1 0 5");
  EXPECT_EQ(moves_as(Dialect::kLinuxCnc, start + "G1 F9 G4 P0.1 X4.\nM2"),
            "\nrapid to 0 0 5\ncut to 4 0 5 F9");
  EXPECT_EQ(moves_as(Dialect::kFanuc, start + "G1 F9. G4 X4.\nM30"), "\nrapid to 0 0 5");
  EXPECT_EQ(moves_as(Dialect::kLinuxCnc, start + "G18 G99 F9 G81 X4. Y-3. R2. Z5.\nM2"),
            "\nrapid to 0 0 5\nrapid to 0 2 5\nrapid to 4 2 5\ncut to 4 -3 5 F9\nrapid to 4 2 5");
  EXPECT_EQ(moves_as(Dialect::kLinuxCnc, start + "G1 F9 G43.1 Z1.\nX4.\nZ5.\nM2"),
            "\nrapid to 0 0 5\ncut to 4 0 5 F9\nretract to 4 0 6 F9");
  EXPECT_EQ(moves_as(Dialect::kLinuxCnc, start + "M70\nG91 G20\nM72\nX4.\nM2"),
            "\nrapid to 0 0 5\nrapid to 4 0 5");
}

TEST(GcodeDialects, WhereTwoWouldMoveDifferentlyItIsACondition) {
  const std::string start = "G21 G61 G17 G90 G0 X0 Y0\nZ5\nF9\n";
  EXPECT_EQ(conditions(start + "G81 X1 Z-1 R2\nM2"), "g99@4 dialect@4");
  EXPECT_EQ(conditions(start + "G98 G81 X1 Z-1 R2\nM2"), "");
  EXPECT_EQ(conditions(start + "G1 G4 P0.1 X3\nM2"), "dialect@4");
  EXPECT_EQ(conditions(start + "G98 G89 X1 Z-1 R2 P1\nM2"), "dialect@4");
}

TEST(GcodeDialects, AreRecognised) {
  const auto dialect = [](const std::string& text) {
    return std::string(name_of(read_gcode(text, "t").dialect));
  };
  EXPECT_EQ(dialect("G0 X0\nM2"), "linuxcnc");
  EXPECT_EQ(dialect("%\nO1234\nG0 X0.\nM30\n%"), "fanuc");
  EXPECT_EQ(dialect("%\nO01234 (A)\nG0 X0.\nM30\n%"), "haas");
  EXPECT_EQ(dialect("(A)\nG91.1 G0 X0\nM30"), "grbl");
  EXPECT_EQ(dialect("; A\nG90\nG0 X0\n; end"), "marlin");
  EXPECT_EQ(dialect("G64\nT1 M6\nG43 H1\nG0 X0\nM30"), "mach3");
  EXPECT_EQ(dialect("BEGIN PGM A MM\nEND PGM A MM"), "heidenhain");
}

/// Comments behind semicolons are Grbl's too: where it would wait or move otherwise, both are named.
TEST(GcodeDialects, GrblOrMarlinIsACondition) {
  const auto read = [](const std::string& text) { return read_gcode("G21 ; mm\nG90\n" + text, "t"); };
  const auto names = [&](const std::string& text) {
    const Program program = read(text);
    return std::string(name_of(program.dialect)) + " " + names_of(program);
  };
  const std::string cut = "G0 X0 Y0 F900\nG0 Z5\nG1 Z-1 F100\nG0 Z5\nM5\n";
  EXPECT_EQ(names("M3 S12000\nG4 P3\n" + cut), "grbl dialect@4");
  EXPECT_EQ(names("M3 S200\nG4 P3000\n" + cut), "marlin dialect@4");
  EXPECT_EQ(names("M3 S200\nG4 S3\n" + cut), "marlin ");
  EXPECT_EQ(names("M3 S200\n" + cut), "marlin ") << "both do the same";
  EXPECT_THAT(read("M3 S12000\nG4 P3\n" + cut).conditions.front().text, HasSubstr("marlin"));
}

TEST(GcodeDialects, UnitsOfVectricsPostsAreMachs) {
  const std::string text =
      "G00G20G17G90G40G49G80\nG70G91.1\nG61\nT1M06\nG00G43Z0.8H1\nM3 S9000\nG0X1Y1\nG1Z-1F9\nM30\n";
  EXPECT_EQ(name_of(read_gcode(text, "t").dialect), "mach3");
  EXPECT_THAT(refusal(Dialect::kLinuxCnc, "G70"), HasSubstr("--dialect mach3"));
  EXPECT_THAT(refusal(Dialect::kGrbl, "G71"), HasSubstr("post G21"));
}

TEST(GcodeDialects, PolarWordsAreLinuxCncs) {
  EXPECT_EQ(refusal(Dialect::kLinuxCnc, "G1 @5 ^60"), "");
  EXPECT_THAT(refusal(Dialect::kMach3, "G1 @5 ^60"), HasSubstr("are LinuxCNC's words for polar coordinates"));
}

/// A machine file states offsets, and no shift that ran on from another program.
TEST(GcodeConditions, AShiftFromOutsideIsRefusedWithAMachineFileToo) {
  ReadControllerOptions options;
  options.dialect = Dialect::kLinuxCnc;
  options.places = MachinePlaces{};
  const auto read = [&](const std::string& text) {
    return read_gcode("G21 G90\n" + text + "\nM2\n", "t", options);
  };
  EXPECT_THROW(read("G92.3\nG0 X1"), InputError);
  EXPECT_NO_THROW(read("G92 X5\nG92.2\nG92.3\nG0 X1"));
  options.places->stated_origins = 6;
  EXPECT_EQ(names_of(read("G61 G17 G55\nG0 X1")), "");
  EXPECT_EQ(names_of(read("G61 G17 G59.1\nG0 X1")), "g59.1@2") << "that offset is not stated";
}

TEST(GcodeDialects, AWordThatOneControlAloneHasLeavesNoDoubt) {
  const auto asks = [](const std::string& blend) {
    const auto program = read_gcode(
        blend + "G21\nT1 M6\nG43 H1\nM3 S400\nG0 X0 Y0\nZ5\nG98 G84 X0 Y0 Z-5 R2 F400\nG80\nM2", "t");
    return std::any_of(program.conditions.begin(), program.conditions.end(),
                       [](const auto& one) { return one.name == "dialect"; });
  };
  EXPECT_TRUE(asks(""));
  EXPECT_FALSE(asks("G64 P0.001 Q0\n"));
}

TEST(GcodeDialects, WordsOfOthersAreRefused) {
  EXPECT_THAT(refusal(Dialect::kGrbl, "G81 X1 Z-1 R1"), HasSubstr("test.ngc:1: G81 is no word of grbl"));
  EXPECT_THAT(refusal(Dialect::kMarlin, "G43 H1"), HasSubstr("G43 is no word of marlin"));
  EXPECT_THAT(refusal(Dialect::kLinuxCnc, "G54.1 P2"), HasSubstr("G54.1 is no word of linuxcnc"));
  EXPECT_THAT(refusal(Dialect::kHeidenhain, "G0 X1"), HasSubstr("no Klartext"));
  EXPECT_THAT(refusal(Dialect::kGrbl, "BEGIN PGM A MM\n"), HasSubstr("heidenhain"));
}

TEST(GcodeDialects, TextBehindAPauseIsMarlins) {
  const std::string start = "G90\nG0 X0 Y0 Z5\n", rest = "\nG1 X5 F9\nM2";
  for (const char* pause : {"M0 INSERT T3, TOUCH OFF Z", "M1 change the tool"})
    EXPECT_EQ(read_as(Dialect::kMarlin, start + pause + rest).toolpath.sections.back().moves.back().path.to,
              (Vec2{5, 0}));
  EXPECT_THAT(refusal(Dialect::kLinuxCnc, start + "M0 INSERT T3" + rest),
              HasSubstr("test.ngc:3: text behind a pause"));
}

TEST(GcodeDialects, DwellsWithoutATimeAreRefused) {
  for (const Dialect dialect : {Dialect::kLinuxCnc, Dialect::kGrbl, Dialect::kMach3, Dialect::kMach4})
    EXPECT_THAT(refusal(dialect, "G21 G4 X2\n"), HasSubstr("G4 without its P word")) << name_of(dialect);
  EXPECT_EQ(refusal(Dialect::kMarlin, "G21\nG4 S2\n"), "");
}

TEST(GcodeState, IsKeptForEachMove) {
  const Program program = read_gcode(
      "G21 G90\nT3 M6\nG43 H3\nG64 P0.02 Q0.01\nM3 S5000\nG4 P2\nG0 X0 Y0 Z5\nG1 Z-1 F9\nM5\nX3\nG61 "
      "G49\nX4\nM2",
      "t");
  ASSERT_EQ(program.toolpath.sections.size(), 2U);
  const ControlState& first = *program.control.at(1);
  EXPECT_EQ(first.tool, 3);
  EXPECT_EQ(first.spindle, SpindleState::kClockwise);
  EXPECT_EQ(first.spindle_rpm, 5000);
  EXPECT_EQ(first.length, (ToolLength{LengthKind::kNumbered, 3, 0}));
  EXPECT_EQ(first.path, (PathControl{PathMode::kTolerance, 0.02, 0.01}));
  const ControlState& stopped = *program.control.at(2);
  EXPECT_EQ(stopped.spindle, SpindleState::kOff);
  EXPECT_EQ(stopped.spindle_rpm, 5000);
  EXPECT_EQ(program.control.at(3)->path.mode, PathMode::kExactPath);
  EXPECT_EQ(program.control.at(3)->length.kind, LengthKind::kOff);
  ASSERT_EQ(program.control.events.size(), 4U);
  EXPECT_EQ(program.control.events[0].kind, ControlEventKind::kToolChange);
  EXPECT_EQ(program.control.events[0].tool, 3);
  EXPECT_EQ(program.control.events[1].kind, ControlEventKind::kSpindleStart);
  EXPECT_EQ(program.control.events[2].seconds, 2);
  EXPECT_EQ(program.control.events[3].kind, ControlEventKind::kSpindleStop);
  EXPECT_EQ(program.control.events[3].before_move, 2U);
}

TEST(GcodeConditions, AToleranceOfNothingIsNone) {
  const std::string head = "G21 G90\nG0 X0 Y0 Z1\n";
  EXPECT_EQ(conditions(head + "G64 P0 Q0\nG1 X5 F9\nM2"), conditions(head + "G64\nG1 X5 F9\nM2"));
  EXPECT_EQ(conditions(head + "G64 P0.01 Q0\nG1 X5 F9\nM2"), "");
  const auto said = [](Dialect dialect, const std::string& word) {
    return conditions_as(dialect,
                         "G21 G90 G17 G94 G54\nG0 X0. Y0. Z5.\n" + word + "\nG1 X5. F100.\nG0 Z5.\nM30\n");
  };
  for (const char* none : {"G187 P2", "G187 P2 E0.", "G187 E0", "G187 E-0.01"})
    EXPECT_EQ(said(Dialect::kHaas, none), "blending@4") << none;
  EXPECT_EQ(said(Dialect::kHaas, "G187 P2 E0.01"), "");
  for (const Dialect mach : {Dialect::kMach3, Dialect::kMach4})
    EXPECT_EQ(said(mach, "G64 P0.01"), said(mach, "G64 P0")) << "P means nothing there";
  EXPECT_EQ(said(Dialect::kFanuc, "G61\nG5.1 Q1"), "blending@4");
  EXPECT_EQ(said(Dialect::kFanuc, "G61\nG5.1 Q0"), "") << "it ends the smoothing";
  EXPECT_THAT(refusal(Dialect::kFanuc, "G21 G90 G17\nG0 X0. Y0. Z5.\nG05 P0\nM30\n"),
              HasSubstr("G5 is not read"));
}

TEST(Dialects, SmoothingOfOneControlIsASplineOfAnother) {
  const std::string head = "G21 G90 G17\nG0 X0 Y0 Z5\n";
  EXPECT_THAT(message_of(head + "G5.1 X10 Y10 I3 J3 F100\nM2\n"), HasSubstr("G5.1 is a spline"));
  EXPECT_EQ(conditions_as(Dialect::kFanuc, "G21 G90 G17 G94 G54\nG0 X0. Y0. Z5.\nG05.1 Q1\nM30\n"),
            "blending@3");
}

TEST(Dialects, AxesThatSmoothingNamesDoNotMove) {
  EXPECT_THAT(
      moves_as(Dialect::kFanuc,
               "G21 G90 G17 G94 G54\nG0 X0. Y0. Z5.\nG1 X10. F100.\nG05.1 Q2 X0 Y0 Z0\nG1 Y10.\nM30\n"),
      ::testing::EndsWith("\ncut to 10 0 5 F100\ncut to 10 10 5 F100"));
}

TEST(Dialects, ToolsAreStatedByM61) {
  const Program read =
      read_as(Dialect::kLinuxCnc, "G21 G90 G17 G64 P0.01\nT1 M6\nG0 X0 Y0 Z50\nM61 Q3\nG1 X5 F100\nM2\n");
  ASSERT_FALSE(read.toolpath.sections.empty());
  EXPECT_EQ(read.toolpath.sections.back().tool_number, 3);
  EXPECT_THAT(names_of(read), HasSubstr("m61@4"));
}

TEST(Dialects, SubprogramsOfOtherDevicesAreRefused) {
  EXPECT_THAT(refusal(Dialect::kFanuc, "G21 G90 G17\nG0 X0. Y0. Z5.\nM198 P100\nM30\n"),
              HasSubstr("M198 calls a subprogram from another device"));
}

TEST(Okuma, IsToldByItsWords) {
  const auto control = [](const std::string& text) { return name_of(recognised(text, "p").dialect); };
  EXPECT_EQ(control("$PART.MIN%\nG21 G90 G0 X0.\nM2"), "okuma");
  EXPECT_EQ(control("O0001\nG21 G90 G15 H1\nG0 X0.\nM2"), "okuma");
  EXPECT_EQ(control("G21 G90\nG56 Z5. H1\nM2"), "okuma");
  EXPECT_EQ(control("%\n(OSP-P300)\nG21 G90 G0 X0.\nM2"), "okuma");
  EXPECT_EQ(control("%\nO1\nG21 G90 G56 G43 H1 Z5.\nM30\n%"), "fanuc") << "the third offset beside a length";
}

TEST(Okuma, MovesByItsOwnWords) {
  const std::string start = "G21 G17 G90 G94 G61\nG15 H1 S900 M3\nG0 X0. Y0.\nG56 H1 Z15.\n";
  const auto told_as = [](const std::string& text) {
    std::string found;
    for (const Section& section : read_as(Dialect::kOkuma, text).toolpath.sections)
      for (const Move& move : section.moves) found += (found.empty() ? "" : "; ") + told(move);
    return found;
  };
  EXPECT_EQ(told_as(start + "G71 Z15.\nG81 X5. Y0. Z-2. R1. F100. M53\nX7.\nG0 Z15.\nM2"),
            told_as(start + "X5.\nZ1.\nG1 Z-2. F100.\nG0 Z15.\nX7.\nZ1.\nG1 Z-2. F100.\nG0 Z15.\nM2"));
  EXPECT_EQ(conditions_as(Dialect::kOkuma, start + "G0 Z20.\nG53\nM2"), "");
  EXPECT_EQ(conditions_as(Dialect::kOkuma, start + "G53\nG0 Z5.\nG1 Z1. F100.\nM2"), "tool-length-off@7");
  const Program waits = read_as(Dialect::kOkuma, start + "G1 Z1. F100.\nG4 F1.5\nX5.\nM2");
  EXPECT_TRUE(waits.conditions.empty());
  EXPECT_EQ(waits.toolpath.sections.back().moves.back().feed, MmPerMin::of(100)) << "F of G4 is no feed";
}

TEST(Okuma, RefusesWhatIsNotKnown) {
  const std::string start = "G21 G17 G90 G94 G61\nG15 H1 S900 M3\nG0 X0. Y0.\nG56 H1 Z15.\n";
  for (const char* words : {"G15",
                            "G15 H0",
                            "G15 H1.5",
                            "G15 H201",
                            "G15 H-1",
                            "G15 H1 G56",
                            "G16 H2 Z0.",
                            "G16 H0 G53 Z0.",
                            "G56",
                            "G54 H1",
                            "G55 H1",
                            "G59",
                            "G43 H1",
                            "G49",
                            "G4 P2.",
                            "G4",
                            "G71",
                            "G71 X1. Z5.",
                            "G91 G71 Z5.",
                            "G10 L2 P1 X1.",
                            "G11 X1. Y1.",
                            "G81 X1. Z-1. R1. F9. M53",
                            "G73 X1. Z-1. R1. F9.",
                            "G76",
                            "G87 X1.",
                            "G41 D1 X1.",
                            "G8 P1",
                            "G131",
                            "G98",
                            "G93",
                            "NOEX G0 X1.",
                            "NCYL",
                            "RTS",
                            "V1=2",
                            "VC1=2",
                            "VZOFX[1]=0.",
                            "F=PF1",
                            "X=VC1"})
    EXPECT_THAT(refusal(Dialect::kOkuma, start + words + "\nM2"), HasSubstr("test.ngc:5: ")) << words;
  EXPECT_THAT(refusal(Dialect::kFanuc, "OPART\nG0 X1.\nM30"), HasSubstr("Okuma"));
}

}  // namespace
}  // namespace clearcut::read::gcode
