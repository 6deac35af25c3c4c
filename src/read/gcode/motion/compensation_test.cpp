// Contours with cutter compensation as each control runs them. tests/read/compensation_differential_test.cpp holds LinuxCNC's beside
// its own interpreter.
#include "read/gcode/motion/compensation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "read/gcode/test_told_program.h"

namespace clearcut::read::gcode {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// With T1 to T3 of 3 mm radius.
Program read_with_tools(Dialect dialect, const std::string& text, std::optional<double> wear = {}) {
  ReadControllerOptions options;
  options.dialect = dialect;
  for (int number = 1; number <= 3; ++number) options.compensation.radii[number] = 3;
  options.compensation.wear = wear;
  options.compensation.is_stated = true;
  return read_gcode(text, "test.ngc", options);
}

std::string told_of(const Program& program) {
  std::string text;
  for (const Section& section : program.toolpath.sections)
    for (const Move& move : section.moves)
      if (!is_rapid(move.kind)) text += (text.empty() ? "" : "\n") + told(move);
  return text;
}

std::string refusal(Dialect dialect, const std::string& text) {
  try {
    read_with_tools(dialect, text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

const std::string kStart = "G21 G17 G90 G94 G40\nT1 M6\nM3 S1000\nG0 X0 Y0 Z-1\nF100\n";
/// An inside corner, an outside corner, then out.
const std::string kContour = "G41 D1\nG1 X10.\nY20.\nX30.\nG40\nX40.\nG0 Z9.\nM30\n";

TEST(Compensation, LinuxCncEntersAcrossTheFirstMoveAndGoesRoundOutsideCornersByArcs) {
  EXPECT_EQ(told_of(read_with_tools(Dialect::kLinuxCnc, kStart + kContour)),
            "cut to 7 3 -1 F100\ncut to 7 20 -1 F100\ncut to 10 23 -1 cw about 10 20 F100\n"
            "cut to 30 23 -1 F100\ncut to 40 20 -1 F100");
  const std::string stated = "G41.1 D6\nG1 X10\nY20\nX30\nG40\nX40\nG0 Z9\nM2\n";
  EXPECT_EQ(told_of(read_with_tools(Dialect::kLinuxCnc, kStart + stated)),
            told_of(read_with_tools(Dialect::kLinuxCnc, kStart + kContour)));
}

TEST(Compensation, FanucEntersAcrossTheSecondMoveAndJoinsOutsideCornersByLines) {
  const std::string wanted =
      "cut to 7 0 -1 F100\ncut to 7 23 -1 F100\ncut to 30 23 -1 F100\ncut to 40 20 -1 F100";
  for (const Dialect dialect : {Dialect::kFanuc, Dialect::kHaas, Dialect::kMazak})
    EXPECT_EQ(told_of(read_with_tools(dialect, kStart + kContour)), wanted);
  EXPECT_THAT(names_of(read_with_tools(Dialect::kFanuc, kStart + kContour)),
              HasSubstr("compensation-corners"));
}

TEST(Compensation, SharpOutsideCornersHaveALineAcross) {
  const std::string sharp = "G41 D1\nG1 Y10.\nX20.\nX0. Y0.\nG40\nX-20.\nG0 Z9.\nM30\n";
  EXPECT_THAT(told_of(read_with_tools(Dialect::kFanuc, kStart + sharp)),
              HasSubstr("cut to 23 13 -1 F100\ncut to 24.0249 8.6584 -1 F100\n"));
}

TEST(Compensation, SinumerikAndKlartextGoRoundByArcs) {
  const std::string wanted =
      "cut to 7 0 -1 F100\ncut to 7 20 -1 F100\ncut to 10 23 -1 cw about 10 20 F100\n"
      "cut to 30 23 -1 F100\ncut to 40 20 -1 F100";
  EXPECT_EQ(
      told_of(read_with_tools(
          Dialect::kSiemens,
          "G710 G17 G90 G94 G40 G450\nT1 M6\nD1\nM3 S1000\nG0 X0 Y0 Z-1\nF100\nG41 G1 X10\nY20\nX30\nG40 "
          "X40\nG0 Z9\nM30\n")),
      wanted);
  EXPECT_EQ(told_of(read_with_tools(Dialect::kHeidenhain,
                                    "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S1000\n2 L X+0 Y+0 Z-1 R0 FMAX M3\n"
                                    "3 L X+10 RL F100\n4 L Y+20\n5 L X+30\n6 L X+40 R0\n7 L Z+9 FMAX M30\n"
                                    "8 END PGM A MM\n")),
            wanted);
}

TEST(Compensation, SinumerikJoinsByLinesBehindG451) {
  EXPECT_EQ(
      told_of(read_with_tools(
          Dialect::kSiemens,
          "G710 G17 G90 G94 G40 G451\nT1 M6\nD1\nM3 S1000\nG0 X0 Y0 Z-1\nF100\nG41 G1 X10\nY20\nX30\nG40 "
          "X40\nG0 Z9\nM30\n")),
      "cut to 7 0 -1 F100\ncut to 7 23 -1 F100\ncut to 30 23 -1 F100\ncut to 40 20 -1 F100");
}

TEST(Compensation, DrOfTheToolCallMakesTheToolLarger) {
  EXPECT_THAT(
      told_of(read_with_tools(Dialect::kHeidenhain,
                              "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S1000 DR+1\n2 L X+0 Y+0 Z-1 R0 FMAX M3\n"
                              "3 L X+10 RL F100\n4 L Y+20\n5 L X+40 R0\n6 L Z+9 FMAX M30\n7 END PGM A MM\n")),
      HasSubstr("cut to 6 0 -1 F100\ncut to 6 20 -1 F100"));
}

TEST(Compensation, ArcsInsideShrinkAndArcsOutsideGrow) {
  const std::string arcs =
      "G41 D1\nG1 X10.\nG3 X20. Y10. I0. J10.\nG2 X30. Y20. I10. J0.\nG40\nG1 X40.\nG0 Z9.\nM30\n";
  EXPECT_THAT(told_of(read_with_tools(Dialect::kFanuc, kStart + arcs)),
              HasSubstr("cut to 10 3 -1 F100\ncut to 17 10 -1 ccw about 10 10 F100\n"
                        "cut to 30 23 -1 cw about 30 10 F100"));
}

TEST(Compensation, WearMovesThePathOfTheCentreByWhatDHolds) {
  EXPECT_EQ(told_of(read_with_tools(Dialect::kFanuc, kStart + kContour, 0)),
            "cut to 10 0 -1 F100\ncut to 10 20 -1 F100\ncut to 30 20 -1 F100\ncut to 40 20 -1 F100");
  EXPECT_EQ(told_of(read_with_tools(Dialect::kFanuc, kStart + kContour, 0.1)),
            "cut to 9.9 0 -1 F100\ncut to 9.9 20.1 -1 F100\ncut to 30 20.1 -1 F100\ncut to 40 20 -1 F100");
  EXPECT_EQ(told_of(read_with_tools(Dialect::kFanuc, kStart + kContour, -0.1)),
            "cut to 10.1 0 -1 F100\ncut to 10.1 19.9 -1 F100\ncut to 30 19.9 -1 F100\ncut to 40 20 -1 F100");
}

TEST(Compensation, HeightsBetweenStandInTheCorner) {
  const std::string down = "G41 D1\nG1 X10.\nZ-2.\nY20.\nG40\nX40.\nG0 Z9.\nM30\n";
  EXPECT_EQ(told_of(read_with_tools(Dialect::kFanuc, kStart + down)),
            "cut to 7 0 -1 F100\nplunge to 7 0 -2 F100\ncut to 7 20 -2 F100\ncut to 40 20 -2 F100");
}

TEST(Compensation, WhatAControlStopsAtIsRefusedInOneLine) {
  const auto at_line_6 = [](const std::string& what) { return "test.ngc:6: " + what; };
  EXPECT_THAT(refusal(Dialect::kLinuxCnc, kStart + "G41 D1\nG1 X2\nM2\n"),
              HasSubstr("test.ngc:7: the first move of cutter compensation is 2 mm long"));
  EXPECT_THAT(refusal(Dialect::kFanuc, kStart + "G41 D1\nG3 X10. Y10. R10.\nM30\n"),
              HasSubstr("test.ngc:7: cutter compensation begins with an arc"));
  EXPECT_THAT(refusal(Dialect::kFanuc, kStart + "G41 D1\nG1 X10.\nG3 X12. Y2. I0. J2.\nG40 G1 X0.\nM30\n"),
              HasSubstr("test.ngc:8: the arc's radius, 2 mm, is not larger than that of the tool"));
  EXPECT_THAT(refusal(Dialect::kFanuc, kStart + "G41 D1\nG1 X10.\nY2.\nX-10.\nG40 X0.\nM30\n"),
              HasSubstr("cannot be followed by the compensated tool"));
  EXPECT_THAT(refusal(Dialect::kFanuc, kStart + "G18\nG41 D1\nG1 X10.\nM30\n"),
              HasSubstr("test.ngc:7: G41 outside the XY plane"));
  EXPECT_THAT(refusal(Dialect::kFanuc, kStart + "G41 D1\nG18\nG1 X10.\nM30\n"),
              HasSubstr("test.ngc:7: G18 while cutter compensation is on"));
  EXPECT_THAT(refusal(Dialect::kFanuc, kStart + "G41 D1\nG1 X10.\nG28 Z0.\nM30\n"),
              HasSubstr("test.ngc:8: G28 while cutter compensation is on"));
  EXPECT_THAT(refusal(Dialect::kHaas, kStart + "G41 D1\nG1 X10.\nT2 M6\nM30\n"),
              HasSubstr("test.ngc:8: the tool is changed while cutter compensation is on"));
  EXPECT_THAT(refusal(Dialect::kHaas, kStart + "G41 D1\nG1 X10.\nG42\nM30\n"),
              HasSubstr("test.ngc:8: G42 while cutter compensation is on already"));
  EXPECT_THAT(refusal(Dialect::kHaas, kStart + "G41 D1\nG1 X10.\nG81 X20. Z-3. R1.\nM30\n"),
              HasSubstr("test.ngc:8: G81 while cutter compensation is on"));
  EXPECT_THAT(refusal(Dialect::kHaas, kStart + "G41 D1\nG1 X10.\nY9.\nM30\n"),
              HasSubstr("the program ends while cutter compensation is on"));
  EXPECT_THAT(refusal(Dialect::kHaas, kStart + "G41\nG1 X10.\nM30\n"),
              HasSubstr(at_line_6("G41 without a D word")));
  EXPECT_THAT(refusal(Dialect::kFanuc, kStart + "G41 D7\nG1 X10.\nM30\n"),
              HasSubstr(at_line_6("cutter compensation by the radius of D7, and no tool T7 is given")));
  EXPECT_THAT(refusal(Dialect::kGrbl, "G90 G21\nG41 D1\n"), HasSubstr("test.ngc:2: G41 is no word of grbl"));
  EXPECT_THAT(refusal(Dialect::kMarlin, "G90 G21\nG41 D1\n"),
              HasSubstr("test.ngc:2: G41 is no word of marlin"));
  EXPECT_THAT(refusal(Dialect::kFanuc, kStart + "G41.1 D6.\n"), HasSubstr("G41.1 is no word of fanuc"));
}

/// Of an arc that begins 0.6 degrees early LinuxCNC's interpreter takes the contour in mm and stops at it in inches.
TEST(Compensation, LinuxCncComparesSweepsInTheUnitOfTheProgram) {
  const auto contour = [](const std::string& word, double unit) {
    const double places[][2] = {
        {-1.1927, -19.0868}, {-5.7116, -10.93}, {-10.8533, -10.1057}, {-21.541, -12.1477}, {-33.747, 2.6161}};
    const auto place = [&](int k) {
      return "X" + trimmed(places[k][0] / unit, 7) + " Y" + trimmed(places[k][1] / unit, 7);
    };
    const auto center = [&](double i, double j) {
      return " I" + trimmed(i / unit, 7) + " J" + trimmed(j / unit, 7) + "\n";
    };
    return word + " G17 G90 G91.1 G94 G61 F90\nT1 M6\nG0 X0 Y0 Z1\nG41\nG1 " + place(0) + "\n" + place(1) +
           "\nG3 " + place(2) + center(-2.8939, -1.6032) + "G2 " + place(3) + center(-7.1651, 8.5113) +
           "G40\nG1 " + place(4) + "\nM2\n";
  };
  ReadControllerOptions options;
  options.dialect = Dialect::kLinuxCnc;
  options.compensation.only_radius = 3.175;
  EXPECT_NO_THROW(read_gcode(contour("G21", 1), "test.ngc", options));
  try {
    read_gcode(contour("G20", 25.4), "test.ngc", options);
    ADD_FAILURE() << "taken in inches";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("the arc up to an inside corner"));
  }
}

TEST(Compensation, HaasMillsACircleFromItsCentre) {
  EXPECT_EQ(told_of(read_with_tools(Dialect::kHaas, kStart + "G13 I8. D1 Z-2. F50.\nG0 Z9.\nM30\n")),
            "plunge to 0 0 -2 F50\ncut to 5 0 -2 ccw about 2.5 0 F50\ncut to -5 0 -2 ccw about 0 0 F50\n"
            "cut to 5 0 -2 ccw about 0 0 F50\ncut to 0 0 -2 ccw about 2.5 0 F50");
  EXPECT_THAT(told_of(read_with_tools(Dialect::kHaas, kStart + "G12 I8. F50.\nG0 Z9.\nM30\n")),
              HasSubstr("cut to 8 0 -1 cw about 4 0 F50"));
  EXPECT_THAT(refusal(Dialect::kHaas, kStart + "G13 I3. D1\nM30\n"), HasSubstr("not larger than the tool"));
  EXPECT_THAT(refusal(Dialect::kHaas, kStart + "G13 I4. K9. D1\nM30\n"), HasSubstr("one of K and Q"));
  EXPECT_THAT(refusal(Dialect::kHaas, kStart + "G13 I4. K3.5 Q1. D1\nM30\n"),
              HasSubstr("smaller than its first one"));
  EXPECT_THAT(refusal(Dialect::kHaas, kStart + "G13 I4. K9. Q0 D1\nM30\n"), HasSubstr("step Q"));
  EXPECT_THAT(refusal(Dialect::kHaas, kStart + "G13 I4. L1.5\nM30\n"), HasSubstr("number of depths L"));
  EXPECT_THAT(refusal(Dialect::kFanuc, kStart + "G13 I3.\nM30\n"), HasSubstr("G13 is not read"));
  EXPECT_THAT(refusal(Dialect::kHaas, kStart + "G150 P1\nM30\n"), HasSubstr("G150 is not read"));
}

TEST(Compensation, HaasMillsCirclesOutwardsAndDeeper) {
  EXPECT_EQ(told_of(read_with_tools(Dialect::kHaas,
                                    kStart + "G91 G13 I4. K8. Q2.5 D1 Z-1. L2 F50.\nG90 G0 Z9.\nM30\n")),
            [] {
              std::string both;
              for (const std::string z : {"-2", "-3"})
                both += (both.empty() ? "" : "\n") + ("plunge to 0 0 " + z + " F50\ncut to 1 0 ") + z +
                        " ccw about 0.5 0 F50\ncut to -1 0 " + z + " ccw about 0 0 F50\ncut to 1 0 " + z +
                        " ccw about 0 0 F50\ncut to 3.5 0 " + z + " F50\ncut to -3.5 0 " + z +
                        " ccw about 0 0 F50\ncut to 3.5 0 " + z + " ccw about 0 0 F50\ncut to 5 0 " + z +
                        " F50\ncut to -5 0 " + z + " ccw about 0 0 F50\ncut to 5 0 " + z +
                        " ccw about 0 0 F50\ncut to 0 0 " + z + " ccw about 2.5 0 F50";
              return both;
            }());
}

TEST(Compensation, WhatDHoldsIsACondition) {
  ReadControllerOptions options;
  options.dialect = Dialect::kFanuc;
  options.compensation.radii[1] = 3;
  EXPECT_THAT(names_of(read_gcode(kStart + kContour, "test.ngc", options)), HasSubstr("compensation-d1@6"));
  options.compensation.is_stated = true;
  EXPECT_THAT(names_of(read_gcode(kStart + kContour, "test.ngc", options)),
              Not(HasSubstr("compensation-d1")));
}

}  // namespace
}  // namespace clearcut::read::gcode
