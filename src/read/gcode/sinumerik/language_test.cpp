// Siemens' own language: parameters, jumps, loops, subprograms, executed as the control does.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "base/file.h"
#include "base/random.h"
#include "read/gcode/sinumerik/words.h"
#include "read/gcode/test_told_program.h"

namespace clearcut::read::gcode {
namespace {

using ::testing::HasSubstr;

const std::string kBegin = "G710 G17 G90 G94 G60\nG0 X0 Y0 Z5\nF100\n";
using Files = std::map<std::string, std::string>;

Program read_with(const std::string& program, const Files& files = {}) {
  ReadControllerOptions options;
  options.dialect = Dialect::kSiemens;
  options.most_lines = 3000;
  options.subprograms = [files](const std::string& name) {
    const auto found = files.find(name);
    return found == files.end() ? std::nullopt : std::optional(found->second);
  };
  return read_gcode(program, "test.mpf", options);
}

/// Places of all cuts behind the start, "10 0|20 0".
std::string places(const std::string& lines, const Files& files = {}) {
  std::string text;
  for (const Section& section : read_with(kBegin + lines + "\nM30", files).toolpath.sections)
    for (const Move& move : section.moves)
      if (!is_rapid(move.kind))
        text += (text.empty() ? "" : "|") + trimmed(move.path.to.x, 4) + " " + trimmed(move.path.to.y, 4);
  return text;
}

std::string why_refused(const std::string& lines, const Files& files = {}) {
  try {
    read_with(kBegin + lines + "\nM30", files);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(SinumerikLanguage, ParametersAndExpressions) {
  EXPECT_EQ(places("R1=5 R2=R1*2+1\nG1 X=R1 Y=-R2\nX=IC(R1/2) Y=AC((R1+1)*2)"), "5 -11|7.5 12");
  EXPECT_EQ(places("R1=7 DIV 2 R2=7 MOD 4 R3=7/2\nG1 X=R1 Y=R2\nX=R3 Y0"), "3 3|3.5 0");
  EXPECT_EQ(places("G1 X=SIN(30)*10 Y=COS(60)\nX=SQRT(16) Y=POT(3)\nX=ATAN2(1,1) Y=ABS(-2)"),
            "5 0.5|4 9|45 2");
  EXPECT_EQ(places("G1 X=TRUNC(2.7) Y=ROUND(2.5)\nX=MINVAL(3,2) Y=BOUND(0,5,9)\nX=1.5EX1 Y=2EX-1"),
            "2 3|2 5|15 0.2");
  EXPECT_EQ(places("R[2+1]=4\nG1 X=R3 Y=R[3]"), "4 4");
  EXPECT_EQ(places("R1=3\nG1 X=(R1>2)+1 Y=(R1>5) OR (R1==3)"), "2 1");
  EXPECT_EQ(places("G1 X=2+3*4 Y=10-2-3"), "14 5");
  EXPECT_EQ(places("r1=5\ng1 x=r1 y1"), "5 1");
}

TEST(SinumerikLanguage, VariablesHaveTypes) {
  EXPECT_EQ(places("DEF REAL DOWN=1.25, UP\nDEF INT COUNT=2.6\nUP=DOWN*2\nG1 X=UP Y=COUNT"), "2.5 3");
  EXPECT_EQ(places("DEF REAL AT[3]\nAT[1]=4\nG1 X=AT[1] Y=AT[2]"), "4 0");
  EXPECT_EQ(places("DEF BOOL GO=TRUE\nIF GO GOTOF AA\nG1 X9\nAA: G1 X1"), "1 0");
  EXPECT_EQ(places("DEF STRING[8] NAME=\"LEFT\"\nIF NAME==\"LEFT\"\nG1 X1\nENDIF"), "1 0");
}

TEST(SinumerikLanguage, BranchesAndLoops) {
  EXPECT_EQ(places("R1=1\nIF R1==1\nG1 X1\nIF R1>5\nX9\nELSE\nX2\nENDIF\nELSE\nX8\nENDIF\nX3"),
            "1 0|2 0|3 0");
  EXPECT_EQ(places("R1=0\nWHILE R1<3\nR1=R1+1\nG1 X=R1\nENDWHILE"), "1 0|2 0|3 0");
  EXPECT_EQ(places("FOR R1=1 TO 3\nG1 X=R1\nENDFOR"), "1 0|2 0|3 0");
  EXPECT_EQ(places("FOR R1=4 TO 3\nG1 X=R1\nENDFOR\nG1 X7"), "7 0");
  EXPECT_EQ(places("R1=0\nREPEAT\nR1=R1+1\nG1 X=R1\nUNTIL R1>=2"), "1 0|2 0");
  EXPECT_EQ(places("R1=0\nLOOP\nR1=R1+1\nIF R1>2 GOTOF DONE\nG1 X=R1\nENDLOOP\nDONE: X9"), "1 0|2 0|9 0");
  EXPECT_EQ(places("R1=0\nBACK: R1=R1+1\nG1 X=R1\nIF R1<3 GOTOB BACK"), "1 0|2 0|3 0");
  EXPECT_EQ(places("GOTOF N50\nG1 X9\nN50 G1 X1"), "1 0");
  EXPECT_EQ(
      places("R1=2\nCASE R1 OF 1 GOTOF ONE 2 GOTOF TWO DEFAULT GOTOF REST\nONE: G1 X1\nTWO: G1 X2\nREST: "
             "G1 X3"),
      "2 0|3 0");
  EXPECT_EQ(places("GOTOC NOWHERE\nG1 X1"), "1 0");
}

TEST(SinumerikLanguage, SectionsAreRepeated) {
  EXPECT_EQ(places("R1=0\nTOP: R1=R1+1\nG1 X=R1\nREPEAT TOP P=2\nX9"), "1 0|2 0|3 0|9 0");
  EXPECT_EQ(places("R1=0\nGOTOF PAST\nTOP: R1=R1+1\nBOTTOM: G1 X=R1\nPAST: REPEAT TOP BOTTOM P=2\nX9"),
            "1 0|2 0|9 0");
  EXPECT_EQ(places("R1=0\nTOP: R1=R1+5\nG1 X=R1\nREPEATB TOP P=2\nX=R1"), "5 0|15 0");
}

TEST(SinumerikLanguage, SubprogramsInTheFileAndBesideIt) {
  EXPECT_EQ(places("R1=0\nL10 P3\nL20", {{"L10.SPF", "R1=R1+1\nG1 X=R1\nM17"}, {"l20.spf", "G1 Y7\nRET"}}),
            "1 0|2 0|3 0|3 7");
  EXPECT_EQ(places("SLOT(5,)\nSLOT(1,2) P2\nCALL \"SLOT_END\"",
                   {{"SLOT.SPF", "PROC SLOT(REAL AT, REAL UP=4) DISPLOF\nG1 X=AT Y=UP\nM17"},
                    {"SLOT_END.SPF", "G1 X0\nM17"}}),
            "5 4|1 2|0 2")
      << "the second time at the same place";
  EXPECT_EQ(places("L1\nM30\n%_N_L1_SPF\n;$PATH=/_N_WKS_DIR\nG1 X3\nM17"), "3 0");
  EXPECT_EQ(places("R1=1\nDEF REAL OWN=5\nL1\nG1 X=OWN Y=R1", {{"L1.SPF", "DEF REAL OWN=9\nR1=OWN\nM17"}}),
            "5 9")
      << "variables are of their program, R parameters of all";
  const Program program = read_with(kBegin + "L10\nM30", {{"L10.SPF", "G1 X1\nM17"}});
  EXPECT_EQ(names_of(program), "subprogram-1@4");
  ASSERT_EQ(program.control.calls.size(), 1U);
  const std::size_t cut = program.control.calls[0].first_move;
  ASSERT_NE(program.control.calls_at(cut), nullptr);
  EXPECT_EQ(*program.control.calls_at(cut), "L10.SPF:1, L10 called in test.mpf:4");
  EXPECT_EQ(cut == 0 ? nullptr : program.control.calls_at(cut - 1), nullptr);
}

TEST(SinumerikLanguage, CyclesTakeValues) {
  EXPECT_EQ(moves_as(Dialect::kSiemens, kBegin + "R1=-5\nCYCLE81(10,0,R1+7,R1)\nM30"),
            moves_as(Dialect::kSiemens, kBegin + "CYCLE81(10,0,2,-5)\nM30"));
  EXPECT_EQ(moves_as(Dialect::kSiemens, kBegin + "R1=3\nMCALL CYCLE82(10,0,2,,R1,)\nX10\nMCALL\nM30"),
            moves_as(Dialect::kSiemens, kBegin + "MCALL CYCLE82(10,0,2,,3,)\nX10\nMCALL\nM30"));
}

TEST(SinumerikLanguage, WhatTheControlWouldNotTakeIsRefusedWithItsPlace) {
  EXPECT_THAT(why_refused("G1 X=R5"), HasSubstr("test.mpf:4: R5 is taken before the program sets it"));
  EXPECT_THAT(why_refused("G1 X=DEPTH"), HasSubstr("DEPTH is no variable that the program defines"));
  EXPECT_THAT(why_refused("R1=5 G1 X1"), HasSubstr("stands in a block of its own"));
  EXPECT_THAT(why_refused("G1 X1 R1=5"), HasSubstr("stands in a block of its own"));
  EXPECT_THAT(why_refused("R1=1/0"), HasSubstr("division by zero"));
  EXPECT_THAT(why_refused("R1=1\nIF R1==1 AND R1==2\nENDIF"),
              HasSubstr("put each comparison in parentheses"));
  EXPECT_THAT(why_refused("$AC_TIMER[1]=0"), HasSubstr("$AC_TIMER is a value of the control"));
  EXPECT_THAT(why_refused("R1=$AA_IW[X]"), HasSubstr("$AA_IW is a value of the control"));
  EXPECT_THAT(why_refused("GOTOF NOWHERE"), HasSubstr("there is no NOWHERE where GOTOF looks for it"));
  EXPECT_THAT(why_refused("AA: G1 X1\nGOTOF AA"), HasSubstr("there is no AA"));
  EXPECT_THAT(why_refused("LOOP\nENDLOOP"), HasSubstr("over 3000 lines"));
  EXPECT_THAT(why_refused("GOTOS"), HasSubstr("over 3000 lines"));
  EXPECT_THAT(why_refused("WHILE TRUE\nG1 X1"), HasSubstr("a structure lacks its ENDWHILE"));
  EXPECT_THAT(why_refused("ELSE"), HasSubstr("ELSE without its IF"));
  EXPECT_THAT(why_refused("L99"), HasSubstr("L99 is neither a word that is read nor a subprogram"));
  EXPECT_THAT(why_refused("TRAORI"), HasSubstr("TRAORI is not read"));
  EXPECT_THAT(why_refused("L1", {{"L1.SPF", "L1\nM17"}}), HasSubstr("over 11 calls within each other"));
  EXPECT_THAT(why_refused("L1", {{"L1.SPF", "G1 X1"}}), HasSubstr("the subprogram has no M17 or RET"));
  EXPECT_THAT(why_refused("L1", {{"L1.SPF", "G1 X1\nM30"}}), HasSubstr("M2 or M30 ends a subprogram"));
  EXPECT_THAT(why_refused("L1", {{"L1.SPF", "\nG1 X1 X2\nM17"}}),
              HasSubstr("L1.SPF:2: two X words in one block; split it (L1 called in test.mpf:4)"));
  EXPECT_THAT(why_refused("AB(1,2)", {{"AB.SPF", "PROC AB(REAL WIDE)\nM17"}}),
              HasSubstr("more values than PROC"));
  EXPECT_THAT(why_refused("AB", {{"AB.SPF", "PROC AB(REAL WIDE)\nM17"}}), HasSubstr("no value for WIDE"));
  EXPECT_THAT(why_refused("SETAL(65000)"), HasSubstr("SETAL is reached"));
  EXPECT_THAT(why_refused("DEF FRAME THERE"), HasSubstr("FRAME is no type of variables that is read"));
}

TEST(SinumerikLanguage, IsToldFromPlainBlocks) {
  EXPECT_EQ(first_language_line("G710\nG1 X5 F100\nMCALL CYCLE81(1,0,2,-3)\nM30\n"), 0);
  EXPECT_EQ(first_language_line("G710\nG1 X=R1\n"), 2);
  EXPECT_EQ(first_language_line("G710\n\nN30 IF R1==2 GOTOF AA\n"), 3);
}

TEST(SinumerikLanguage, AProgramInAFileIsReadAsItStands) {
  const std::string path = CLEARCUT_SOURCE_DIR "/tests/corpus/macro/steps.mpf";
  const Program program = read_gcode(read_file(path), "steps.mpf");
  EXPECT_EQ(program.dialect, Dialect::kSiemens);
  EXPECT_TRUE(program.ended);
  double lowest = 0, cut = 0;
  for (const Section& section : program.toolpath.sections) {
    cut += feed_length(section);
    for (const Move& move : section.moves) lowest = std::min(lowest, move.z_to);
  }
  EXPECT_EQ(lowest, -4);
  // Nine slots of 20 mm, each with its way down from Z 2, and two circles of 10 mm radius.
  const double down = 3 * ((2 + 1.5) + (2 + 3) + (2 + 4));
  EXPECT_NEAR(cut, 9 * 20 + down + 2 * (2 * kPi * 10 + 3), 1e-6);
}

/// More by hand: CLEARCUT_DAMAGED_PROGRAMS=100000.
TEST(SinumerikLanguage, DamagedProgramsAreReadOrRefusedInBoundedTime) {
  const char* const asked = std::getenv("CLEARCUT_DAMAGED_PROGRAMS");
  const std::string whole = read_file(CLEARCUT_SOURCE_DIR "/tests/corpus/macro/steps.mpf");
  constexpr std::string_view kPieces = "GRXYZL()[]<>=*/+-.0123456789%\n\"PNIFDE_$:,; ";
  Random random(51);
  int read = 0, refused = 0;
  for (int n = asked ? std::atoi(asked) : 300; n > 0; --n) {
    std::string text = whole;
    for (std::uint64_t k = 1 + random.below(4); k > 0; --k) {
      const std::size_t at = random.below(text.size());
      if (random.below(3) == 0)
        text.insert(at, text.substr(random.below(text.size()), random.below(40)));
      else if (random.below(2) == 0)
        text[at] = kPieces[random.below(kPieces.size())];
      else
        text.erase(at, 1 + random.below(8));
    }
    ReadControllerOptions options;
    options.dialect = Dialect::kSiemens;
    options.most_lines = 500;
    options.subprograms = [&](const std::string&) { return std::optional(text); };
    try {
      for (const Section& section : read_gcode(text, "damaged", options).toolpath.sections)
        for (const Move& move : section.moves) ASSERT_TRUE(std::isfinite(move.length())) << text;
      ++read;
    } catch (const InputError& error) {
      ASSERT_NE(std::string(error.what()).find(':'), std::string::npos) << error.what();
      ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(read, 5);
  EXPECT_GT(refused, 20);
}

}  // namespace
}  // namespace clearcut::read::gcode
