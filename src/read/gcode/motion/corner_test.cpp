// Corners that a program rounds or chamfers by words of their own.
#include "read/gcode/motion/corner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "read/gcode/test_told_program.h"

namespace clearcut::read::gcode {
namespace {

using ::testing::HasSubstr;

std::string words(Dialect dialect, const std::string& blocks) {
  const std::string modes = dialect == Dialect::kSiemens ? "G710 G17 G90 G94 G60" : "G17 G21 G90 G94 G61";
  return moves_as(dialect, modes + "\nG0 X0. Y0. Z5.\nF100.\n" + blocks + "\nM30")
      .substr(std::string("\nrapid to 0 0 5").size());
}
std::string refused(Dialect dialect, const std::string& blocks) {
  try {
    words(dialect, blocks);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}
std::string klartext(const std::string& blocks) {
  return moves_as(Dialect::kHeidenhain,
                  "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S1000\n2 L X+0 Y+0 Z+5 R0 FMAX M3\n" + blocks +
                      "\n99 END PGM A MM\n")
      .substr(std::string("\nrapid to 0 0 5").size());
}
std::string klartext_refused(const std::string& blocks) {
  try {
    klartext(blocks);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

const std::string kRounded = "\ncut to 15 0 5 F100\ncut to 20 5 5 ccw about 15 5 F100\ncut to 20 20 5 F100";
const std::string kChamfered = "\ncut to 15 0 5 F100\ncut to 20 5 5 F100\ncut to 20 20 5 F100";

TEST(Corner, LinesAreRoundedAndChamfered) {
  EXPECT_EQ(words(Dialect::kFanuc, "G1 X20.,R5.\nY20."), kRounded);
  EXPECT_EQ(words(Dialect::kHaas, "G1 X20. , C5.\nY20."), kChamfered);
  EXPECT_EQ(words(Dialect::kFanuc, "#1=5.\nG1 X20.,R#1\nY20."), kRounded);
  EXPECT_EQ(klartext("L X+20 F100\nRND R5\nL Y+20"), kRounded);
  EXPECT_EQ(klartext("FN 0: Q1 = +5\nL X+20 F100\n; between\nCHF Q1\nL Y+20"), kChamfered);
  EXPECT_EQ(words(Dialect::kSiemens, "G1 X20 RND=5\nY20"), kRounded);
  EXPECT_EQ(words(Dialect::kSiemens, "G1 X20 CHR=5\nY20"), kChamfered);
  EXPECT_EQ(words(Dialect::kSiemens, "R1=SQRT(50)\nG1 X20 CHF=R1\nY20"), kChamfered);
}

TEST(Corner, TheCornerMayHaveAFeedOfItsOwn) {
  EXPECT_EQ(klartext("L X+20 F100\nRND R5 F50\nL Y+20 F200"),
            "\ncut to 15 0 5 F100\ncut to 20 5 5 ccw about 15 5 F50\ncut to 20 20 5 F200");
  EXPECT_EQ(words(Dialect::kSiemens, "G1 X20 RND=5 FRC=50\nY20 F200"),
            "\ncut to 15 0 5 F100\ncut to 20 5 5 ccw about 15 5 F50\ncut to 20 20 5 F200");
  EXPECT_EQ(words(Dialect::kSiemens, "G1 X20 RND=5\nY20 F200"),
            "\ncut to 15 0 5 F100\ncut to 20 5 5 ccw about 15 5 F200\ncut to 20 20 5 F200");
}

TEST(Corner, CornersFollowEachOtherAndUseAMoveUp) {
  EXPECT_EQ(words(Dialect::kFanuc, "G1 X20.,R5.\nY10.,R5.\nX0."),
            "\ncut to 15 0 5 F100\ncut to 20 5 5 ccw about 15 5 F100\ncut to 15 10 5 ccw about 15 5 "
            "F100\ncut to 0 10 5 F100");
  EXPECT_EQ(klartext("L X+20 F100\nRND R5\nL Y+5\nL X+30"),
            "\ncut to 15 0 5 F100\ncut to 20 5 5 ccw about 15 5 F100\ncut to 30 5 5 F100");
}

TEST(Corner, ArcsAreRounded) {
  // An arc about 20 0 from 10 0: the rounding touches it from outside, 2 mm beside the line.
  const std::string told = words(Dialect::kFanuc, "G1 X10.,R2.\nG2 X30. Y0. I10. J0.");
  EXPECT_THAT(told, HasSubstr("ccw about"));
  EXPECT_THAT(told, HasSubstr("\ncut to 30 0 5 cw about 20 0 F100"));
}

TEST(Corner, CompensationFollowsTheRoundedContour) {
  ReadControllerOptions options;
  options.dialect = Dialect::kHeidenhain;
  options.compensation = {{{1, 2}}, std::nullopt, std::nullopt, true};
  const Program read = read_gcode(
      "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S1000\n2 L X-10 Y+0 Z+5 R0 FMAX M3\n3 L X+0 RL F100\n4 L X+20\n5 "
      "RND "
      "R5\n6 L Y+20\n7 L X+40 R0\n99 END PGM A MM\n",
      "test.h", options);
  std::string told_moves;
  for (const Section& section : read.toolpath.sections)
    for (const Move& move : section.moves) told_moves += "\n" + told(move);
  EXPECT_THAT(told_moves,
              HasSubstr("\ncut to 15 2 5 F100\ncut to 18 5 5 ccw about 15 5 F100\ncut to 18 20 5"));
}

TEST(Corner, WhatMakesNoCornerIsRefused) {
  EXPECT_THAT(refused(Dialect::kFanuc, "G1 X20.,R5.\nG0 Y20."), HasSubstr("no level line or arc"));
  EXPECT_THAT(refused(Dialect::kFanuc, "G1 X20.,R5.\nZ-1."), HasSubstr("no level line or arc"));
  EXPECT_THAT(refused(Dialect::kFanuc, "G1 X20.,R5.\nG4 X1.\nY20."), HasSubstr("stands at a corner"));
  EXPECT_THAT(refused(Dialect::kFanuc, "G1 X20.,R5."), HasSubstr("the end of the program"));
  EXPECT_THAT(refused(Dialect::kFanuc, "G1 X20.,R25.\nY20."), HasSubstr("cannot be rounded"));
  EXPECT_THAT(refused(Dialect::kFanuc, "G1 X20.,R5.\nX40."), HasSubstr("cannot be rounded"));
  EXPECT_THAT(refused(Dialect::kFanuc, "G1 X10.,C2.\nG2 X30. Y0. I10. J0."),
              HasSubstr("an arc has a chamfer"));
  EXPECT_THAT(refused(Dialect::kFanuc, "G0 X20.,R5.\nG1 Y20."), HasSubstr("cuts no line or arc"));
  EXPECT_THAT(refused(Dialect::kFanuc, "G1 X20.,R0.\nY20."), HasSubstr("no size above 0"));
  EXPECT_THAT(refused(Dialect::kFanuc, "G1 X20.,A30."), HasSubstr("',A' states a line by its angle"));
  EXPECT_THAT(refused(Dialect::kFanuc, "G1 X20.,B3."), HasSubstr("',B' is no word"));
  EXPECT_THAT(refused(Dialect::kFanuc, "G1 X20.,R3.,C3.\nY20."), HasSubstr("keep one"));
  EXPECT_THAT(refused(Dialect::kFanuc, "G1 X20.,"), HasSubstr("comma without a letter"));
  EXPECT_THAT(refused(Dialect::kGrbl, "G1 X20.,R3.\nY20."), HasSubstr("',R' is no word of grbl"));
  EXPECT_THAT(klartext_refused("RND R5\nL X+20 F100"), HasSubstr("cuts no line or arc"));
  EXPECT_THAT(klartext_refused("L X+20 F100\nRND R5\nL Z+20"), HasSubstr("no level line or arc"));
  EXPECT_THAT(klartext_refused("L X+20 F100\nRND R5\nCT X+30 Y+10"), HasSubstr("CT without an element"));
  EXPECT_THAT(klartext_refused("L X+20 F100\nRND\nL Y+20"), HasSubstr("no size above 0"));
  EXPECT_THAT(refused(Dialect::kSiemens, "G1 X20 RNDM=5\nY20"), HasSubstr("RNDM is not read"));
  EXPECT_THAT(refused(Dialect::kSiemens, "G1 X20 FRC=5\nY20"), HasSubstr("FRC without"));
}

TEST(Corner, WhatTheControlMayLackIsACondition) {
  const std::string program = "G17 G21 G90 G94 G61\nG0 X0. Y0. Z5.\nG1 X20.,R5. F100.\nY20.\nM30";
  EXPECT_THAT(conditions_as(Dialect::kFanuc, program), HasSubstr("corner-words@3"));
  EXPECT_THAT(conditions_as(Dialect::kHaas, program), ::testing::Not(HasSubstr("corner-words")));
  const std::string bare = "G17 G21 G90 G94 G61\nG0 X0. Y0. Z5.\nG1 X20. R5. F100.\nY20.\nM30";
  EXPECT_THAT(conditions_as(Dialect::kFanuc, bare), HasSubstr("stray-word@3"));
  EXPECT_THAT(conditions_as(Dialect::kHaas, bare), HasSubstr("stray-word@3"));
}

Edge random_edge(Random& random, Vec2 from) {
  const Vec2 to = from + direction_of(random.between(0, 2 * kPi)) * random.between(5, 30);
  if (random.unit() < 0.5) return Edge::line(from, to);
  const double bulge = random.between(-0.9, 0.9);
  return Edge::from_bulge(from, to, bulge);
}

TEST(Corner, RoundingsAreTangentToBothMoves) {
  Random random(7);
  int rounded = 0;
  for (int k = 0; k < 2000; ++k) {
    const Edge before = random_edge(random, {0, 0});
    const Edge after = random_edge(random, before.to);
    const Corner corner{CornerKind::kRounding, random.between(0.2, 5), std::nullopt, false, 1};
    const auto joined = joined_corner(before, after, corner);
    if (!joined) continue;
    ++rounded;
    EXPECT_NEAR(joined->between.radius(), corner.size, 1e-7);
    EXPECT_LE(std::abs(joined->between.sweep()), kPi * 1.9);
    if (joined->before) {
      EXPECT_EQ(joined->before->from, before.from);
      EXPECT_NEAR(distance(before, joined->before->to), 0, 1e-7);
      EXPECT_LE(joined->before->length(), before.length() + 1e-7);
      EXPECT_NEAR(distance(joined->before->tangent_at(1), joined->between.tangent_at(0)), 0, 1e-6) << k;
    }
    if (joined->after) {
      EXPECT_EQ(joined->after->to, after.to);
      EXPECT_NEAR(distance(after, joined->after->from), 0, 1e-7);
      EXPECT_LE(joined->after->length(), after.length() + 1e-7);
      EXPECT_NEAR(distance(joined->between.tangent_at(1), joined->after->tangent_at(0)), 0, 1e-6) << k;
    }
  }
  EXPECT_GT(rounded, 1000);
}

}  // namespace
}  // namespace clearcut::read::gcode
