// Random programs beside other readers of the same words: LinuxCNC's own interpreter, and Grbl's rules.
#include <gtest/gtest.h>

#include <array>

#include "base/error.h"
#include "base/random.h"
#include "read/gcode/gcode.h"
#include "support/independent/grbl.h"
#include "support/independent/rs274.h"
#include "support/random/random_programs.h"

namespace clearcut {
namespace {

constexpr std::uint64_t kProgramsPerShard = 250;
/// mm; the interpreter prints four decimals in program units, and places add up to four of its numbers.
constexpr double kPrintedMm = 4e-4, kPrintedInch = 8e-3;

Program read_as(Dialect dialect, const std::string& text, bool at_zero) {
  read::gcode::ReadControllerOptions options;
  options.dialect = dialect;
  if (at_zero) options.places = read::gcode::MachinePlaces{};
  return read::gcode::read_gcode(text, "random", options);
}

class BesideLinuxCnc : public ::testing::TestWithParam<int> {};

TEST_P(BesideLinuxCnc, EveryRandomProgramMovesAlike) {
  CLEARCUT_SKIP_WITHOUT_RS274();
  const std::uint64_t first = 1 + static_cast<std::uint64_t>(GetParam()) * kProgramsPerShard;
  for (std::uint64_t seed = first; seed < first + kProgramsPerShard; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::string text = test_support::random_program(seed, 5 + static_cast<int>(seed % 40));
    const test_support::CanonProgram canon = test_support::run_rs274(text);
    ASSERT_TRUE(canon.accepted) << canon.message << text;
    const double tolerance = text.find("G20") == std::string::npos ? kPrintedMm : kPrintedInch;
    const Program program = read_as(Dialect::kLinuxCnc, text, true);
    ASSERT_EQ(test_support::difference_of_motion(canon.canon, program.toolpath, tolerance), "") << text;
  }
}

INSTANTIATE_TEST_SUITE_P(Shards, BesideLinuxCnc, ::testing::Range(0, 8));

TEST(BesideLinuxCnc, AWrongMoveIsSeen) {
  CLEARCUT_SKIP_WITHOUT_RS274();
  const std::string text = "N1 G21 G90 G0 X1 Y2 Z3\nN2 G1 X5 F100\nN3 G2 X9 I2 J0\nN4 M2\n";
  const std::string canon = test_support::run_rs274(text).canon;
  const auto difference = [&](const std::string& other) {
    return test_support::difference_of_motion(canon, read_as(Dialect::kLinuxCnc, other, true).toolpath,
                                              kPrintedMm);
  };
  EXPECT_EQ(difference(text), "");
  EXPECT_NE(difference("N1 G21 G90 G0 X1 Y2 Z3\nN2 G1 X5.01 F100\nN3 G2 X9.01 I2 J0\nN4 M2\n"), "");
  EXPECT_NE(difference("N1 G21 G90 G0 X1 Y2 Z3\nN2 G1 X5 F100\nN3 G3 X9 I2 J0\nN4 M2\n"), "");
  EXPECT_NE(difference("N1 G21 G90 G0 X1 Y2 Z3\nN2 G0 X5 F100\nN3 G2 X9 I2 J0\nN4 M2\n"), "");
  EXPECT_NE(difference("N1 G21 G90 G0 X1 Y2 Z3\nN2 G1 X5 F100\nN4 M2\n"), "");
}

/// Words of Grbl and of others, as they meet in programs.
std::string random_block(Random& random) {
  constexpr std::array<const char*, 33> kBlocks{"G0 X1",
                                                "G1 Y2 F100",
                                                "G2 X4 Y0 I2 J0",
                                                "G3 X1 Y1 R5",
                                                "G4 P0.1",
                                                "G10 L2 P1 X3",
                                                "G17",
                                                "G20",
                                                "G21",
                                                "G28",
                                                "G28.1",
                                                "G40",
                                                "G43.1 Z1",
                                                "G49",
                                                "G53 G0 Z0",
                                                "G54",
                                                "G59",
                                                "G61",
                                                "G80",
                                                "G90",
                                                "G91",
                                                "G91.1",
                                                "G92 X0",
                                                "G92.1",
                                                "G94",
                                                "M3 S100",
                                                "M8",
                                                "G43 H1",
                                                "G81 X1 Z-1 R1 F9",
                                                "G64 P0.01",
                                                "G98",
                                                "G73 X1 Z-1 R1 Q1",
                                                "G59.1"};
  return kBlocks[random.below(kBlocks.size())];
}

TEST(BesideGrbl, WhatItTakesIsReadAndWhatItHasNoWordForIsRefused) {
  Random random(274);
  int read = 0, refused = 0;
  for (int n = 0; n < 3000; ++n) {
    std::string text = "G21 G90 G0 X0 Y0 Z5\n";
    for (std::uint64_t k = 1 + random.below(5); k > 0; --k) text += random_block(random) + "\n";
    bool unsupported = false, faulty = false;
    for (const auto& fault : test_support::grbl_faults(text)) {
      faulty = true;
      unsupported = unsupported || fault.error == 20;
    }
    try {
      read_as(Dialect::kGrbl, text, false);
      EXPECT_FALSE(unsupported) << text;
      ++read;
    } catch (const InputError& error) {
      EXPECT_TRUE(faulty) << text << error.what();
      ++refused;
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(read, 300);
  EXPECT_GT(refused, 300);
}

}  // namespace
}  // namespace clearcut
