// What other systems' Klartext programs do besides path blocks: retracts along the tool, headings.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "read/gcode/test_told_program.h"

namespace clearcut::read::gcode {
namespace {

using ::testing::HasSubstr;

std::string program(const std::string& blocks) {
  return "0 BEGIN PGM A MM\n1 CYCL DEF 32.0 TOLERANCE\n2 CYCL DEF 32.1 T0.001\n3 TOOL CALL 1 Z S400\n4 M3\n"
         "5 L X+10 Y+20 R0 FMAX\n6 L Z+50 R0 FMAX\n" +
         blocks + "90 M30\n91 END PGM A MM\n";
}

TEST(KlartextRetract, GoesUpAlongTheToolBySoMuchOrToTheEndOfTheTravel) {
  EXPECT_THAT(moves_of(program("7 L Z+5 FMAX\n8 L Z-1 F100\n9 L M140 MB30\n")),
              HasSubstr("to 10 20 -1 F100\nrapid to 10 20 29"));
  EXPECT_THAT(moves_of(program("7 L Z+5 FMAX\n8 L Z-1 F100\n9 L M140 MB MAX\n10 L X+0 Y+0 FMAX\n")),
              HasSubstr("to 10 20 -1 F100\nrapid to 10 20 100\nrapid to 0 0 100"));
  EXPECT_EQ(conditions(program("7 L Z-1 F100\n8 L M140 MB MAX FMAX\n")), "");
  EXPECT_THAT(message_of(program("7 L M140 MBQ5\n")), HasSubstr("Q5 is read before the program sets it"));
}

TEST(KlartextRetract, HeadingsOfTheStructureMoveNothing) {
  EXPECT_EQ(moves_of(program("7 * - POCKET (2)\n8 L Z-1 F100\n")), moves_of(program("8 L Z-1 F100\n")));
}

}  // namespace
}  // namespace clearcut::read::gcode
