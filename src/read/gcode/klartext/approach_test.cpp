// How Klartext comes to contours and leaves them: APPR, DEP.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "read/gcode/test_told_program.h"

namespace clearcut::read::gcode {
namespace {

using ::testing::HasSubstr;

constexpr double kToolRadius = 3;

Program program_of(const std::string& start, const std::string& blocks) {
  ReadControllerOptions options;
  options.dialect = Dialect::kHeidenhain;
  options.compensation.radii = {{1, kToolRadius}};
  options.compensation.is_stated = true;
  return read_gcode(
      "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S1000\nCYCL DEF 32.0 TOLERANCE\nCYCL DEF 32.1 T0.01\nL " + start +
          " Z-1 R0 FMAX M3\nL IX+0 IY+0 F200\n" + blocks + "\nL Z+50 R0 FMAX M30\n99 END PGM A MM\n",
      "test.h", options);
}
std::string moves(const std::string& start, const std::string& blocks) {
  std::string text;
  for (const Section& section : program_of(start, blocks).toolpath.sections)
    for (const Move& move : section.moves)
      if (!is_rapid(move.kind)) text += told(move) + "\n";
  return text;
}
std::string refused(const std::string& blocks) {
  try {
    program_of("X-10 Y-2", blocks);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(KlartextApproach, AlongTheContour) {
  EXPECT_EQ(moves("X+0 Y-30", "APPR LT X+10 Y+0 LEN5 RL F100\nL Y+20\nDEP LT LEN4 F150"),
            "cut to 7 -5 -1 F200\ncut to 7 0 -1 F100\ncut to 7 20 -1 F100\ncut to 7 24 -1 F150\n");
  EXPECT_EQ(moves("X+20 Y-30", "APPR LT X+10 Y+0 LEN5 R0 F100\nL Y+20\nDEP LT LEN4"),
            "cut to 10 -5 -1 F200\ncut to 10 0 -1 F100\ncut to 10 20 -1 F100\ncut to 10 24 -1 F100\n");
}

TEST(KlartextApproach, AcrossTheContour) {
  EXPECT_EQ(moves("X+0 Y-30", "APPR LN X+10 Y+0 LEN4 RL F100\nL Y+20\nDEP LN LEN4"),
            "cut to 3 0 -1 F200\ncut to 7 0 -1 F100\ncut to 7 20 -1 F100\ncut to 3 20 -1 F100\n");
  EXPECT_EQ(moves("X+40 Y-30", "APPR LN X+10 Y+0 LEN4 RR F100\nL Y+20\nDEP LN LEN4"),
            "cut to 17 0 -1 F200\ncut to 13 0 -1 F100\ncut to 13 20 -1 F100\ncut to 17 20 -1 F100\n");
}

TEST(KlartextApproach, ByAnArc) {
  EXPECT_EQ(moves("X-10 Y-30", "APPR CT X+10 Y+0 CCA90 R+5 RL F100\nL Y+20\nDEP CT CCA90 R+5"),
            "cut to 5 -2 -1 F200\ncut to 7 0 -1 ccw about 5 0 F100\ncut to 7 20 -1 F100\n"
            "cut to 5 22 -1 ccw about 5 20 F100\n");
  EXPECT_EQ(moves("X-10 Y-30", "APPR CT X+10 Y+0 CCA90 R-5 RL F100\nL Y+20\nDEP CT CCA90 R-5"),
            "cut to 15 -8 -1 F200\ncut to 7 0 -1 cw about 15 0 F100\ncut to 7 20 -1 F100\n"
            "cut to 15 28 -1 cw about 15 20 F100\n");
}

TEST(KlartextApproach, ByALineAndAnArc) {
  EXPECT_EQ(moves("X-10 Y-2", "APPR LCT X+10 Y+0 R5 RL F100\nL Y+20\nDEP LCT X-10 Y+22 R5"),
            "cut to 5 -2 -1 F100\ncut to 7 0 -1 ccw about 5 0 F100\ncut to 7 20 -1 F100\n"
            "cut to 5 22 -1 ccw about 5 20 F100\ncut to -10 22 -1 F100\n");
  EXPECT_EQ(moves("X+30 Y-2", "APPR LCT X+10 Y+0 R5 RR F100\nL Y+20\nDEP LCT X+30 Y+22 R5"),
            "cut to 15 -2 -1 F100\ncut to 13 0 -1 cw about 15 0 F100\ncut to 13 20 -1 F100\n"
            "cut to 15 22 -1 cw about 15 20 F100\ncut to 30 22 -1 F100\n");
}

TEST(KlartextApproach, OfAnArcAndInPolarCoordinates) {
  EXPECT_EQ(
      moves("X-20 Y-30", "CC X+0 Y+0\nAPPR PLT PR+20 PA+0 LEN5 RL F100\nCP IPA+90 DR+\nDEP LT LEN4"),
      "cut to 17 -5 -1 F200\ncut to 17 0 -1 F100\ncut to 0 17 -1 ccw about 0 0 F100\ncut to -4 17 -1 F100\n");
}

TEST(KlartextApproach, GoesOnFromWhereItEnds) {
  EXPECT_EQ(moves("X-10 Y-30", "APPR LT X+10 Y+0 LEN5 RL F100\nL Y+20\nDEP LT LEN4\nL IX-5\nL Y+0"),
            "cut to 7 -5 -1 F200\ncut to 7 0 -1 F100\ncut to 7 20 -1 F100\ncut to 7 24 -1 F100\n"
            "cut to 2 24 -1 F100\ncut to 2 0 -1 F100\n");
}

TEST(KlartextApproach, FirstInThePlaneThenInHeight) {
  const Program read = program_of("X+0 Y-30", "APPR LT X+10 Y+0 Z-4 LEN5 RL F100\nL Y+20\nDEP LT LEN4");
  EXPECT_EQ(moves("X+0 Y-30", "APPR LT X+10 Y+0 Z-4 LEN5 RL F100\nL Y+20\nDEP LT LEN4"),
            "cut to 7 -5 -1 F200\nplunge to 7 -5 -4 F200\ncut to 7 0 -4 F100\ncut to 7 20 -4 F100\ncut to 7 "
            "24 -4 F100\n");
  EXPECT_THAT(names_of(read), HasSubstr("approach-height@7"));
}

TEST(KlartextApproach, IsARapidBehindARapid) {
  const Program read =
      program_of("X+0 Y-30", "L Y-31 FMAX\nAPPR LT X+10 Y+0 LEN5 RL F100\nL Y+20\nDEP LT LEN4");
  std::string rapids;
  for (const Section& section : read.toolpath.sections)
    for (const Move& move : section.moves)
      if (is_rapid(move.kind)) rapids += "|" + point(move.path.to, move.z_to);
  EXPECT_THAT(rapids, HasSubstr("|7 -5 -1"));
}

struct ApproachAndDeparture {
  std::string approach, departure;
};

/// Moves by feeds below 300 of a contour in axes that are turned and shifted.
std::vector<Move> turned_moves(const ApproachAndDeparture& by, double degrees, Vec2 zero) {
  const std::string axes = "TRANS DATUM AXIS X" + trimmed(zero.x, 3) + " Y" + trimmed(zero.y, 3) +
                           "\nCYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+" + trimmed(degrees, 3) + "\n";
  const Program read = program_of("X+0 Y+0", axes + "L X-20 Y-7 F300\nAPPR " + by.approach +
                                                 " RL F100\nCC X+0 Y+0\nCP IPA+60 DR+\nCT X-20 Y+20\nDEP " +
                                                 by.departure + "\nL IX+1 IY+2");
  std::vector<Move> moves;
  for (const Section& section : read.toolpath.sections)
    for (const Move& move : section.moves)
      if (!is_rapid(move.kind) && move.feed.mm_per_min() < 300) moves.push_back(move);
  return moves;
}

TEST(KlartextApproach, TurnsWithTheAxes) {
  const Vec2 zero{3, -2};
  for (const ApproachAndDeparture& by : {ApproachAndDeparture{"LT X+15 Y+0 LEN5", "LT LEN5"},
                                         {"LN X+15 Y+0 LEN5", "LN LEN5"},
                                         {"CT X+15 Y+0 CCA70 R+6", "CT CCA70 R+6"},
                                         {"CT X+15 Y+0 CCA200 R-4", "CT CCA200 R-4"},
                                         {"LCT X+15 Y+0 R7", "LCT X-40 Y+9 R7"}}) {
    SCOPED_TRACE(by.approach);
    const std::vector<Move> plain = turned_moves(by, 0, {});
    ASSERT_GE(plain.size(), 5U);
    for (const double degrees : {30.0, 137.0, 260.0}) {
      const std::vector<Move> turned = turned_moves(by, degrees, zero);
      const auto moved = [&](Vec2 place) {
        return zero + rotated(place, Radians::of_degrees(degrees).radians());
      };
      ASSERT_EQ(turned.size(), plain.size());
      for (std::size_t k = 0; k < plain.size(); ++k) {
        EXPECT_LT(distance(turned[k].path.to, moved(plain[k].path.to)), 1e-6) << k;
        ASSERT_EQ(turned[k].path.is_arc(), plain[k].path.is_arc());
        if (!plain[k].path.is_arc()) continue;
        EXPECT_LT(distance(turned[k].path.center, moved(plain[k].path.center)), 1e-6) << k;
      }
    }
  }
}

TEST(KlartextTangentArc, GoesOnAsTheElementBefore) {
  EXPECT_EQ(moves("X+0 Y+0", "L X+10 F100\nCT X+15 Y+5\nCT X+20 Y+10"),
            "cut to 10 0 -1 F100\ncut to 15 5 -1 ccw about 10 5 F100\ncut to 20 10 -1 cw about 20 5 F100\n");
  EXPECT_EQ(moves("X+0 Y+0", "L X+10 F100\nCC X+10 Y-5\nCTP PR+5 PA-90"),
            "cut to 10 0 -1 F100\ncut to 10 -10 -1 cw about 10 -5 F100\n");
  EXPECT_EQ(moves("X+0 Y-30", "APPR LT X+10 Y+0 LEN5 RL F100\nL Y+20\nCT X+0 Y+30\nDEP LT LEN4"),
            "cut to 7 -5 -1 F200\ncut to 7 0 -1 F100\ncut to 7 20 -1 F100\n"
            "cut to 0 27 -1 ccw about 0 20 F100\ncut to -4 27 -1 F100\n");
}

TEST(KlartextTangentArc, IsRefusedWhereItIsNone) {
  EXPECT_THAT(refused("CT X+15 Y+5 F100"), HasSubstr("CT without an element before it"));
  EXPECT_THAT(refused("L X+10 F100\nCT X+15"), HasSubstr("on the line of the element before it"));
  EXPECT_THAT(refused("APPR LT X+10 Y+0 LEN5 RL F100\nCT Y+20"),
              HasSubstr("CT without an element before it"));
}

TEST(KlartextApproach, IsRefusedWhereItIsNotWhole) {
  EXPECT_THAT(refused("APPR LT X+10 Y+0 LEN5 RL F100\nL Z-3"),
              HasSubstr("is not followed by the first element"));
  EXPECT_THAT(refused("APPR LT X+10 Y+0 LEN5 RL F100\nTOOL CALL 2 Z S100"), HasSubstr("APPR in line 7"));
  EXPECT_THAT(refused("APPR LT X+10 Y+0 RL F100\nL Y+20"), HasSubstr("without LEN"));
  EXPECT_THAT(refused("APPR CT X+10 Y+0 CCA400 R5 RL F100\nL Y+20"), HasSubstr("CCA"));
  EXPECT_THAT(refused("APPR CT X+10 Y+0 CCA90 R2 RL F100\nL Y+20"),
              HasSubstr("not larger than that of the tool"));
  EXPECT_THAT(refused("APPR LCT X+10 Y+0 R30 RL F100\nL Y+20"), HasSubstr("within the circle"));
  EXPECT_THAT(refused("APPR LN X+10 Y+0 LEN4 F100\nL Y+20"), HasSubstr("with RL or RR alone"));
  EXPECT_THAT(refused("APPR XX X+10"), HasSubstr("block 'APPR XX' is not read"));
  EXPECT_THAT(refused("DEP LN LEN4"), HasSubstr("DEP"));
  EXPECT_THAT(refused("APPR LT X+10 Y+0 LEN5 RL F100\nL Y+20 RR"), HasSubstr("another than that of APPR"));
}

/// TOOL DEF states what the control compensates by, and from where heights count.
TEST(KlartextTools, DefinitionsAreHeldBesideTheToolsGiven) {
  const auto read = [](const std::string& definition) {
    ReadControllerOptions options;
    options.dialect = Dialect::kHeidenhain;
    options.compensation.radii = {{1, kToolRadius}};
    options.compensation.is_stated = true;
    const std::string program = "0 BEGIN PGM A MM\n" + definition +
                                "\nTOOL CALL 1 Z S1000\nCYCL DEF 32.0 TOLERANCE\nCYCL DEF 32.1 T0.01\n"
                                "L X+0 Y+0 Z-1 R0 FMAX M3\nL X+10 RL F200\nL X+30\nL Z+50 R0 FMAX M30\n"
                                "END PGM A MM\n";
    try {
      std::string names;
      for (const Condition& one : read_gcode(program, "test.h", options).conditions)
        names += one.name + " " + one.text + "\n";
      return names;
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_THAT(read("TOOL DEF 1 L+12.5 R+3"), HasSubstr("tool-length-def TOOL DEF in line 2"));
  EXPECT_THAT(read("TOOL DEF 1 L+12.5 R+3"), HasSubstr("12.5 mm"));
  EXPECT_THAT(read("TOOL DEF 1 R+4"), HasSubstr("states a radius of 4 mm for T1"));
  EXPECT_THAT(read("TOOL DEF 1 L+0 R+3 X5"), HasSubstr("TOOL DEF with 'X5'"));
  for (const char* none : {"TOOL DEF 1", "TOOL DEF 1 R+3", "TOOL DEF 2 L+7 R+4"})
    EXPECT_THAT(read(none), ::testing::Not(HasSubstr("TOOL DEF"))) << none;
}

}  // namespace
}  // namespace clearcut::read::gcode
