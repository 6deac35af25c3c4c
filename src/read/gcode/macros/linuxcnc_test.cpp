// Habits of LinuxCNC's programs that compute.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "read/gcode/test_told_program.h"

namespace clearcut::read::gcode {
namespace {

using ::testing::HasSubstr;

const std::string kBegin = "G21 G90 G64 P0.01\nG0 X0 Y0\nZ5\nF100\n";

ReadControllerOptions with_files(const std::map<std::string, std::string>& files) {
  ReadControllerOptions options;
  options.dialect = Dialect::kLinuxCnc;
  options.subprograms = [files](const std::string& name) -> std::optional<std::string> {
    const auto found = files.find(name);
    return found == files.end() ? std::nullopt : std::optional(found->second);
  };
  return options;
}

std::string ends_of(const Program& program) {
  std::string text;
  for (const Section& section : program.toolpath.sections)
    for (const Move& move : section.moves) text += "|" + point(move.path.to, move.z_to);
  return text;
}

std::string refusal_of(const std::string& text, const ReadControllerOptions& options) {
  try {
    read_gcode(text, "main.ngc", options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "read";
}

TEST(LinuxCncMacros, ParametersAndFunctionsAreComputed) {
  const std::string text =
      kBegin + "#<depth> = [3 * 2]\n#1 = 10 G1 X#<depth>\nG1 X#1 Y[sqrt[16] + 2 ** 3]\nM2\n";
  EXPECT_EQ(moves_as(Dialect::kLinuxCnc, text), "\nrapid to 0 0 5\ncut to 6 0 5 F100\ncut to 10 12 5 F100");
}

TEST(LinuxCncMacros, ABreakIsRememberedUpToTheEndOfADoLoop) {
  const std::string broken = "o1 while [1]\nG1 X1\no1 break\no1 endwhile\n";
  const std::string loop = "o2 do\n#2 = [#2 + 1]\nG1 X[10 + #2]\no2 while [#2 lt 3]\n";
  const std::string again = "#2 = 0\no3 do\n#2 = [#2 + 1]\nG1 X[20 + #2]\no3 while [#2 lt 2]\n";
  const Program read = read_as(Dialect::kLinuxCnc, kBegin + "#2 = 0\n" + broken + loop + again + "M2\n");
  EXPECT_EQ(ends_of(read), "|0 0 5|1 0 5|11 0 5|21 0 5|22 0 5");
  EXPECT_THAT(names_of(read), HasSubstr("do-after-break@13"));
  const std::string left = "#2 = 0\no4 do\no4 break\no4 while [1]\n";
  EXPECT_EQ(ends_of(read_as(Dialect::kLinuxCnc, kBegin + left + again + "M2\n")), "|0 0 5|21 0 5|22 0 5");
}

TEST(LinuxCncMacros, HolesInARowByALoop) {
  const std::string text = kBegin +
                           "#1 = 0\no100 while [#1 lt 3]\nG81 X[#1 * 10] Y0 Z-2 R1\n#1 = [#1 + 1]\n"
                           "o100 endwhile\nG80\nM2\n";
  const Program read = read_as(Dialect::kLinuxCnc, text);
  EXPECT_THAT(ends_of(read), HasSubstr("|20 0 -2"));
  EXPECT_EQ(names_of(read).find("parameter"), std::string::npos);
}

TEST(LinuxCncMacros, SubroutineBesideTheProgramIsReadAndAConditionNamesIt) {
  const auto options = with_files({{"slot.ngc", "o<slot> sub\nG1 X#1 Y#2\no<slot> endsub [#1 + 1]\nM2\n"}});
  const Program read = read_gcode(kBegin + "o<slot> call [7] [8]\nG1 X#<_value>\nM2\n", "main.ngc", options);
  EXPECT_THAT(ends_of(read), HasSubstr("|7 8 5|8 8 5"));
  EXPECT_THAT(names_of(read), HasSubstr("subprogram-1@5"));
  EXPECT_EQ(refusal_of("o<none> call\nM2\n", options),
            "main.ngc:1: subroutine o<none> is neither in the program nor in a file none.ngc beside it; put "
            "the file there");
}

TEST(LinuxCncMacros, ARefusalNamesItsFileAndTheCalls) {
  const auto options = with_files({{"deep.ngc", "o<deep> sub\nG1 X#<unset>\no<deep> endsub\n"}});
  EXPECT_EQ(refusal_of(kBegin + "o<deep> call\nM2\n", options),
            "deep.ngc:2: #<unset> is read before anything sets it, at which the control stops; set it before "
            "(odeep called in main.ngc:5)");
}

TEST(LinuxCncMacros, UnsetParametersAreConditions) {
  const Program read = read_as(Dialect::kLinuxCnc, kBegin + "G1 X[#150 + 1]\nM2\n");
  EXPECT_THAT(names_of(read), HasSubstr("parameter-150@5"));
}

TEST(LinuxCncMacros, WhatTheControlKeepsIsRefusedUnlessStated) {
  const std::string text = kBegin + "G1 X#5221\nM2\n";
  EXPECT_THAT(refusal_of(text, with_files({})),
              HasSubstr("#5221 is a value of the control that nothing states"));
  ReadControllerOptions options = with_files({});
  options.places = MachinePlaces{};
  options.places->origins[0] = {12, 0, 0};
  EXPECT_THAT(ends_of(read_gcode(text, "main.ngc", options)), HasSubstr("|12 0 5"));
}

TEST(LinuxCncMacros, ProbingMovesNothingAndIsACondition) {
  const std::string text = kBegin + "G38.2 Z-20 F50\nG10 L20 P1 Z0\nG0 Z5\nG1 X3 Z#5063\nM2\n";
  const Program read = read_as(Dialect::kLinuxCnc, text);
  EXPECT_THAT(names_of(read), HasSubstr("measured-move@5"));
  EXPECT_THAT(names_of(read), HasSubstr("measured-value@8"));
  EXPECT_EQ(ends_of(read).find("|0 0 -20"), std::string::npos);
}

TEST(LinuxCncMacros, PolarWordsOfACycleCountOnFromHoleToHole) {
  const Program read = read_as(Dialect::kLinuxCnc, kBegin + "G0 X10 Y0\nG91 G81 R0 Z-6 ^90 L3\nG80\nM2\n");
  for (const char* hole : {"|0 10 -1", "|-10 0 -1", "|0 -10 -1"}) EXPECT_THAT(ends_of(read), HasSubstr(hole));
}

TEST(LinuxCncMacros, PolarWords) {
  EXPECT_EQ(moves_as(Dialect::kLinuxCnc, kBegin + "G1 @10 ^90\n^0\nM2\n"),
            "\nrapid to 0 0 5\ncut to 0 10 5 F100\ncut to 10 0 5 F100");
}

}  // namespace
}  // namespace clearcut::read::gcode
