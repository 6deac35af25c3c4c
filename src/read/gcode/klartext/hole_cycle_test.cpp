// What Heidenhain's drilling cycles do, move by move.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "read/gcode/klartext/klartext.h"
#include "read/gcode/test_told_program.h"

namespace clearcut::read::gcode {
namespace {

using ::testing::HasSubstr;

/// At X10 Y20 Z50, with a spindle of 400 rpm.
std::string program(const std::string& blocks) {
  return "0 BEGIN PGM A MM\n1 CYCL DEF 32.0 TOLERANCE\n2 CYCL DEF 32.1 T0.001\n3 TOOL CALL 1 Z S400\n4 M3\n"
         "5 L X+10 Y+20 R0 FMAX\n6 L Z+50 R0 FMAX\n" +
         blocks + "90 M30\n91 END PGM A MM\n";
}

std::string drilling(const std::string& peck) {
  return "7 CYCL DEF 200 DRILLING ~\n  Q200=+2 ;SET-UP CLEARANCE ~\n  Q201=-10 ;DEPTH ~\n"
         "  Q206=+150 ;FEED RATE FOR PLNGNG ~\n  Q202=" +
         peck +
         " ;PLUNGING DEPTH ~\n  Q210=+0 ;DWELL TIME AT TOP ~\n  Q203=-3 ;SURFACE COORDINATE ~\n"
         "  Q204=+30 ;2ND SET-UP CLEARANCE ~\n  Q211=+0 ;DWELL TIME AT DEPTH\n";
}

const std::string kTap = "Q200=+2 Q201=-12 Q203=+0 Q204=+20";

/// The moves after the one to Z50.
std::string after_start(const std::string& blocks) {
  const std::string all = moves_of(program(blocks)), start = "rapid to 10 20 50";
  const std::size_t at = all.find(start);
  return at == std::string::npos ? all : all.substr(at + start.size());
}

TEST(HoleCycle, DrillsFromTheSurfaceDownAndGoesBackToTheSecondClearance) {
  EXPECT_EQ(after_start(drilling("+10") + "8 CYCL CALL\n"),
            "\nrapid to 10 20 -1\nplunge to 10 20 -13 F150\nrapid to 10 20 27");
}

TEST(HoleCycle, ACallAtAPlaceGoesThereAboveTheSurface) {
  EXPECT_EQ(after_start(drilling("+10") + "8 CYCL CALL POS X+30 Y+25 Z+0 FMAX M8\n"),
            "\nrapid to 30 25 50\nrapid to 30 25 -1\nplunge to 30 25 -13 F150\nrapid to 30 25 27");
  EXPECT_THAT(after_start(drilling("+10") + "8 CYCL CALL POS X+30 Y+25 Z+0 F900\n9 L X+0 F100\n"),
              HasSubstr("cut to 30 25 50 F900"));
  const auto refused = [](const std::string& call) { return message_of(program(drilling("+10") + call)); };
  EXPECT_THAT(refused("8 CYCL CALL POS X+30 Y+25 FMAX\n"), HasSubstr("asks for X, Y and Z"));
  EXPECT_THAT(refused("8 CYCL CALL POS X+30 Y+25 Z-5 FMAX\n"), HasSubstr("read as Z+0 alone"));
  EXPECT_THAT(refused("8 L Z-4 F100\n9 CYCL CALL POS X+30 Y+25 Z+0 FMAX\n"), HasSubstr("below the surface"));
  EXPECT_THAT(refused("8 CYCL CALL PAT FMAX\n"), HasSubstr("places of a pattern"));
}

TEST(HoleCycle, PecksCountFromTheSurfaceAndBeginTheClearanceAboveTheLastDepth) {
  EXPECT_EQ(after_start(drilling("+4") + "8 CYCL CALL M8\n"),
            "\nrapid to 10 20 -1\nplunge to 10 20 -7 F150\nrapid to 10 20 -1\nrapid to 10 20 -5\nplunge to "
            "10 20 -11 F150"
            "\nrapid to 10 20 -1\nrapid to 10 20 -9\nplunge to 10 20 -13 F150\nrapid to 10 20 27");
}

TEST(HoleCycle, UniversalDrillingBreaksChipsBeforeItComesOut) {
  const std::string cycle =
      "7 CYCL DEF 203 UNIVERSAL DRILLING ~\n Q200=+5 ~\n Q201=-10 ~\n Q206=FAUTO ~\n Q202=+4 ~\n Q210=+0 ~\n "
      "Q203=+0 ~\n Q204=+13 ~\n"
      " Q212=+1 ~\n Q213=+1 ~\n Q205=+2 ~\n Q211=+0 ~\n Q208= MAX ~\n Q256=+0.2\n";
  EXPECT_EQ(after_start("6 L F90\n" + cycle + "8 L FMAX M99\n"),
            "\nrapid to 10 20 5\nplunge to 10 20 -4 F90\nrapid to 10 20 -3.8\nplunge to 10 20 -7 F90\nrapid "
            "to 10 20 5"
            "\nrapid to 10 20 -2\nplunge to 10 20 -9 F90\nrapid to 10 20 -8.8\nplunge to 10 20 -10 "
            "F90\nrapid to 10 20 13");
  EXPECT_THAT(message_of(program(
                  "7 CYCL DEF 203 A Q200=1 Q201=-9 Q206=9 Q202=4 Q203=0 Q204=9 Q212=1\n8 CYCL CALL\n")),
              HasSubstr("Q205"));
}

/// With the clearance as the way back and no chips to break a deep hole is drilled as the universal cycle drills it.
TEST(HoleCycle, DeepHolesAreDrilledByPecksFromWhereTheyBegin) {
  const std::string common = " Q200=+2 Q201=-10 Q206=+90 Q202=+4 Q203=+0 Q204=+13 Q212=+1 Q205=+2 Q208=+300";
  EXPECT_EQ(after_start("7 CYCL DEF 205 DEEP" + common + " Q258=+2 Q259=+2 Q257=+0 Q256=+0.2\n8 CYCL CALL\n"),
            after_start("7 CYCL DEF 203 UNIVERSAL" + common + "\n8 CYCL CALL\n"));
  EXPECT_EQ(
      after_start("7 CYCL DEF 205 DEEP Q200=+2 Q201=-10 Q206=+90 Q202=+5 Q203=+0 Q204=+13 Q208= MAX Q257=+3 "
                  "Q256=+0.5 Q258=+0.2 Q259=+0.4 Q379=+2 Q253=+500\n8 CYCL CALL\n"),
      "\nrapid to 10 20 2\nplunge to 10 20 -2 F500\nplunge to 10 20 -5 F90\nretract to 10 20 -4.5 "
      "F90\nplunge "
      "to 10 20 -7 F90\nrapid to 10 20 2\nrapid to 10 20 -6.8\nplunge to 10 20 -10 F90\nrapid to 10 20 13");
  EXPECT_THAT(message_of(program(
                  "7 CYCL DEF 205 A Q200=1 Q201=-9 Q206=9 Q202=4 Q203=0 Q204=9 Q379=9\n8 CYCL CALL\n")),
              HasSubstr("begins no higher than it ends"));
}

TEST(HoleCycle, M99CallsItWhereItsBlockEnds) {
  EXPECT_EQ(after_start(drilling("+10") + "8 L X+30 R0 FMAX M99\n"),
            "\nrapid to 30 20 50\nrapid to 30 20 -1\nplunge to 30 20 -13 F150\nrapid to 30 20 27");
}

TEST(HoleCycle, AReamerComesOutAtItsFeed) {
  const std::string at_own =
      "7 CYCL DEF 201 REAMING Q200=1 Q201=-9 Q206=120 Q211=0 Q208=0 Q203=0 Q204=20\n8 CYCL CALL\n";
  EXPECT_THAT(after_start(at_own), HasSubstr("to 10 20 -9 F120\nretract to 10 20 1 F120\nrapid to 10 20 20"));
  const std::string faster =
      "7 CYCL DEF 201 REAMING Q200=1 Q201=-9 Q206=120 Q208=600 Q203=0 Q204=20\n8 CYCL CALL\n";
  EXPECT_THAT(after_start(faster), HasSubstr("retract to 10 20 1 F600"));
  const std::string rapid =
      "7 CYCL DEF 201 REAMING Q200=1 Q201=-9 Q206=120 Q208=99999 Q203=0 Q204=20\n8 CYCL CALL\n";
  EXPECT_THAT(after_start(rapid), HasSubstr("to 10 20 -9 F120\nrapid to 10 20 20")) << "as FMAX";
}

/// The feed follows from speed and pitch; the cycle turns the spindle and leaves it stopped.
TEST(HoleCycle, RigidTapsAreTiedToTheSpindle) {
  const std::string text = program("7 CYCL DEF 207 RIGID TAPPING NEW " + kTap + " Q239=-1.5\n8 CYCL CALL\n");
  EXPECT_THAT(moves_of(text), HasSubstr("to 10 20 -12 F600\nretract to 10 20 2 F600\nrapid to 10 20 20"));
  const Program read = read_gcode(text, "test.ngc");
  ASSERT_FALSE(read.control.events.empty());
  EXPECT_EQ(read.control.events.back().kind, ControlEventKind::kSpindleStop);
  bool turns_left = false;
  for (const ControlSpan& span : read.control.spans)
    turns_left |= span.state.spindle == SpindleState::kCounterClockwise;
  EXPECT_TRUE(turns_left);
}

TEST(HoleCycle, ABoringBarComesOutInTheMiddle) {
  const std::string cycle =
      "7 CYCL DEF 202 BORING Q200=+2 Q201=-8 Q206=+100 Q211=+0 Q208=+250 Q203=+0 Q204=+13 Q214=+";
  EXPECT_EQ(after_start(cycle + "0 Q336=+0\n8 CYCL CALL\n"),
            "\nrapid to 10 20 2\nplunge to 10 20 -8 F100\nretract to 10 20 2 F250\nrapid to 10 20 13");
  EXPECT_THAT(conditions(program(cycle + "1 Q336=+90\n8 CYCL CALL\n")), HasSubstr("oriented-retract"));
  EXPECT_THAT(message_of(program(cycle + "5\n8 CYCL CALL\n")), HasSubstr("to no side that Q214 numbers"));
}

/// 12 deep from the set-up clearance in turns of 4, about a tool of radius 3 in a hole of 10: three times round, once at the bottom.
TEST(HoleCycle, BoreMillingRunsDownAHelix) {
  ReadControllerOptions options;
  options.compensation.radii[1] = 3;
  const auto cycle = [](const std::string& more) {
    return "7 CYCL DEF 208 BORE MILLING Q200=+2 Q201=-10 Q206=+400 Q334=+4 Q203=+0 Q204=+13 " + more +
           "\n8 CYCL CALL\n";
  };
  const auto milled = [&](const std::string& more) {
    std::string text;
    const Program read = read_gcode(program(cycle(more)), "test.ngc", options);
    for (const Section& section : read.toolpath.sections)
      for (const Move& move : section.moves)
        if (move.path.is_arc() || move.kind == MoveKind::kPlunge) text += told(move) + "\n";
    return text;
  };
  const std::string ccw = milled("Q335=+10 Q342=+0 Q351=+1");
  EXPECT_THAT(ccw, HasSubstr("to 12 20 2 ccw about 11 20 F400"));
  EXPECT_THAT(ccw, HasSubstr("ramp to 10 18 -1 ccw about 10 20 F400\nramp to 8 20 -4 ccw"));
  EXPECT_THAT(ccw, HasSubstr("to 12 20 -10 ccw about 10 20 F400"));
  EXPECT_THAT(ccw, HasSubstr("to 8 20 -10 ccw about 10 20 F400"));
  EXPECT_THAT(ccw, HasSubstr("to 10 20 -10 ccw about 11 20 F400"));
  EXPECT_THAT(milled("Q335=+10 Q342=+0 Q351=-1"),
              HasSubstr("ramp to 10 22 -1 cw about 10 20 F400\nramp to 8 20 -4 cw"));
  EXPECT_EQ(milled("Q335=+6"), "plunge to 10 20 -10 F400\n") << "of the tool's size";
  const auto refused = [&](const std::string& more) {
    try {
      read_gcode(program(cycle(more)), "test.ngc", options);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("read");
  };
  EXPECT_THAT(refused("Q335=+5"), HasSubstr("smaller than the tool"));
  EXPECT_THAT(refused("Q335=+13"), HasSubstr("more than twice as wide"));
  EXPECT_EQ(refused("Q335=+13 Q342=+9"), "read");
  EXPECT_THAT(message_of(program(cycle("Q335=+10"))), HasSubstr("no tool T1 is given"));
}

TEST(HoleCycle, TapsBreakTheirChipsAndComeOutFaster) {
  const auto tapped = [](const std::string& more) {
    return after_start("7 CYCL DEF 209 TAPPING W/ CHIP BRKG " + kTap + " Q239=+1 " + more +
                       "\n8 CYCL CALL\n");
  };
  EXPECT_EQ(
      tapped("Q257=+5 Q256=+2"),
      "\nrapid to 10 20 2\nplunge to 10 20 -5 F400\nretract to 10 20 -3 F400\nplunge to 10 20 -10 F400"
      "\nretract to 10 20 -8 F400\nplunge to 10 20 -12 F400\nretract to 10 20 2 F400\nrapid to 10 20 20");
  EXPECT_EQ(tapped("Q257=+8 Q256=+0 Q336=+0 Q403=+2"),
            "\nrapid to 10 20 2\nplunge to 10 20 -8 F400\nretract to 10 20 2 F800\nplunge to 10 20 -12 F400"
            "\nretract to 10 20 2 F800\nrapid to 10 20 20");
  const Program read = read_gcode(
      program("7 CYCL DEF 209 A " + kTap + " Q239=+1 Q257=+8 Q256=+0 Q403=+2\n8 CYCL CALL\n"), "test.ngc");
  for (const ControlSpan& span : read.control.spans)
    EXPECT_TRUE(span.state.spindle_rpm == 400 || span.state.spindle_rpm == 800) << span.state.spindle_rpm;
  EXPECT_EQ(read.control.spans.back().state.spindle_rpm, 400);
}

TEST(HoleCycle, WhatCannotBeIsRefusedInOneLine) {
  const auto refusal = [](const std::string& blocks) { return message_of(program(blocks)); };
  EXPECT_THAT(refusal("7 CYCL CALL\n"), HasSubstr("called before one is defined"));
  EXPECT_THAT(refusal("7 CYCL DEF 207 RIGID TAPPING NEW " + kTap + "\n8 CYCL CALL\n"),
              HasSubstr("207 lacks Q239"));
  EXPECT_THAT(refusal("7 CYCL DEF 207 RIGID TAPPING NEW " + kTap + " Q239=0\n8 CYCL CALL\n"),
              HasSubstr("pitch Q239 of 0"));
  EXPECT_THAT(refusal("7 CYCL DEF 206 TAPPING NEW " + kTap + " Q206=400 Q336=9\n8 CYCL CALL\n"),
              HasSubstr("no parameter Q336"));
  EXPECT_THAT(refusal(drilling("+0") + "8 CYCL CALL\n"), HasSubstr("plunging depth Q202"));
  EXPECT_THAT(refusal(drilling("+Q5") + "8 CYCL CALL\n"), HasSubstr("Q5 is read before the program sets it"));
  EXPECT_THAT(refusal("7 CYCL DEF 201 REAMING Q200=1 Q201=+9 Q206=120 Q203=0 Q204=20\n8 CYCL CALL\n"),
              HasSubstr("negative depth"));
  EXPECT_THAT(refusal("7 CYCL DEF 204 BACK BORING Q200=1\n8 CYCL CALL\n"),
              HasSubstr("cycle 204 bores from below"));
}

}  // namespace
}  // namespace clearcut::read::gcode
