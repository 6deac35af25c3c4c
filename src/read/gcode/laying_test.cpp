// Programs that lay a line: which moves lay, and what is refused.
#include "read/gcode/laying.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"

namespace clearcut::read::gcode {
namespace {

using ::testing::HasSubstr;

TEST(Laying, FilamentIsFedAlongTheMovesThatLay) {
  const auto program = read_laying(
      "; A\nG21\nG90\nM83\nG0 Z0.2 F6000\nG0 X1 Y1\nG1 X5 Y1 E0.132 F1200\nG1 X5 Y3 E0.066\nG1 X9 Y3\nM2\n",
      "a.gcode");
  EXPECT_EQ(program.word, LayingWord::kExtruded);
  ASSERT_EQ(program.moves.size(), 3U);
  EXPECT_TRUE(program.moves[0].lays);
  EXPECT_DOUBLE_EQ(program.moves[0].word, 0.132);
  EXPECT_DOUBLE_EQ(program.moves[0].z, 0.2);
  EXPECT_DOUBLE_EQ(program.moves[1].feed.mm_per_min(), 1200);
  EXPECT_FALSE(program.moves[2].lays);
}

TEST(Laying, ABeamHasPowerOnlyInFeedMovesWithAnSAbove0) {
  const auto program = read_laying(
      "G21\nG90\nM4 S0\nG0 X1 Y1\nG1 X5 Y1 S500\nG0 X9 Y1\nG1 X9 Y5\nG1 X1 Y5 S0\nM5\nG1 X1 Y9 S500\n",
      "a.nc");
  EXPECT_EQ(program.word, LayingWord::kPower);
  std::vector<bool> lays;
  for (const LaidMove& move : program.moves) lays.push_back(move.lays);
  EXPECT_EQ(lays, (std::vector<bool>{true, false, true, false, false}));
}

std::string refusal_of(const std::string& text) {
  try {
    read_laying(text, "a.nc");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Laying, OtherWordsAreRefusedWithTheirLine) {
  EXPECT_THAT(refusal_of("G0 X1 Y1\nG2 X5 Y1 I2 J0 E1\n"), HasSubstr("a.nc:2: G2 is no word"));
  EXPECT_THAT(refusal_of("M82\n"), HasSubstr("a.nc:1: M82 is no word"));
  EXPECT_THAT(refusal_of("G91\n"), HasSubstr("G91 is no word"));
  EXPECT_THAT(refusal_of("G0 X1 Y1\nG1 X2 A3 E1\n"), HasSubstr("A is no word"));
  EXPECT_THAT(refusal_of("G0 X1 Y1\nG1 X2 Z1 E1\n"), HasSubstr("changes its height"));
  EXPECT_THAT(refusal_of("G0 X1 Y1\nM3 S5\nG1 X2 E1\n"), HasSubstr("not both"));
  EXPECT_THAT(refusal_of("G1 X1 Y1 E1\n"), HasSubstr("before any place"));
  EXPECT_THAT(refusal_of("M4 S300\nG1 X9 F1200\n"), HasSubstr("a.nc:2: lays before any place"));
  EXPECT_THAT(refusal_of("M4 S300\nG0 X9\nG0 Y9\nG1 X5\n"), HasSubstr("a.nc:4: lays before any place"));
  EXPECT_THAT(refusal_of("X1 Y1\n"), HasSubstr("without G0 or G1"));
}

}  // namespace
}  // namespace clearcut::read::gcode
