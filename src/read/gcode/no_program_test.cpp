#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "read/gcode/gcode.h"
#include "read/gcode/recognise.h"

namespace clearcut::read::gcode {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using namespace std::string_literals;

std::string refusal_of(const std::string& text, const std::string& file = "dropped") {
  try {
    read_gcode(text, file, ReadControllerOptions{});
  } catch (const InputError& error) {
    return error.what();
  }
  return "read";
}

TEST(NoProgram, EmptyFilesAreSaidToBeEmpty) {
  for (const char* text : {"", " \n\t\r\n", "\xEF\xBB\xBF\n"})
    EXPECT_THAT(refusal_of(text), StartsWith("dropped: the file is empty; give the text")) << text;
}

TEST(NoProgram, FilesOfOtherKindsAreNamed) {
  const std::vector<std::pair<std::string, const char*>> files{
      {"\x89PNG\r\n\x1a\n\0\0"s, "this is a picture"},
      {"%PDF-1.4\n", "this is a page for printing"},
      {"PK\3\4\24\0"s, "this is a zip archive"},
      {"ISO-10303-21;\nHEADER;\n", "this is a STEP file"},
      {"  0\r\nSECTION\r\n", "this is a DXF drawing"},
      {"999\nmade by\n0\nSECTION\n", "this is a DXF drawing"},
      {"<?xml version='1.0'?>\n<svg/>", "this is an SVG drawing"},
      {"{\"name\": \"a\"}", "this is a JSON file"},
      {"# a job\n\n[part]\nfile = 'a.dxf'\n", "this is a job file"},
      {"%FSLAX46Y46*%\nX0Y0D02*\n", "this is a Gerber file"},
      {"M48\nMETRIC,TZ\nT1C0.8\n", "this is an Excellon"},
      {"G\0"
       "1\0 \0"s,
       "this is a binary file"},
      {"Dear Sir,\nplease mill this.\n", "no line of it is a block"},
      {"(A)\n; a comment\n%\n", "no line of it is a block"}};
  for (const auto& [text, what] : files) {
    const std::string refusal = refusal_of(text);
    EXPECT_THAT(refusal, StartsWith("dropped: "s + what));
    EXPECT_THAT(refusal, HasSubstr("; give "));
    EXPECT_EQ(refusal.find('\n'), std::string::npos);
  }
}

TEST(NoProgram, ProgramsInOtherLanguagesAreNamed) {
  const std::vector<std::pair<std::string, const char*>> files{
      {"%PLATE G71 *\nN10 G30 G17 X+0 Y+0 Z-10 *\nN20 T1 G17 S5000 *\n",
       "this is a program in Heidenhain's ISO"},
      {"N10 G71 *\r\nN20 G00 X+1 *\r\n", "this is a program in Heidenhain's ISO"},
      {"'----\n'SHOPBOT ROUTER FILE IN MM\nIF %(25)=0 THEN GOTO UNIT_ERROR\nSA  \t'absolute\nJZ,20\n",
       "this is a program of ShopBot"},
      {"MS,25.4,12.7\nJ2,0,0\n", "this is a program of ShopBot"},
      {"IN;SP1;PU10,10;PD20,10;\n", "this is a plot file"},
      {"TOOL PATH/PLANAR_MILL,TOOL,MILL\nTLDATA/MILL,6\nGOTO/1,2,3\n", "this is cutter location data"},
      {"$$ made by a CAM\nLOADTL/1\nGOTO/1,2,3\n", "this is cutter location data"}};
  for (const auto& [text, what] : files) {
    EXPECT_THAT(refusal_of(text), StartsWith("dropped: "s + what));
    EXPECT_THAT(refusal_of(text), HasSubstr(", which is not read; ")) << text;
  }
  EXPECT_THAT(refusal_of("[Made by a CAM]\nG21\nM2\n"), StartsWith("dropped:1: unexpected '['"));
}

TEST(NoProgram, ProgramsOfEveryKindAreNone) {
  for (const char* text :
       {"G21\nM2\n", "%\nO0001 (A)\nG21\nM30\n%\n", ":0001\nG0 Z5\nM30\n", "/N10 g 0 z 5\nM2\n",
        "(A) G0 Z5\nM2\n", "; made by hand\nG0 Z5\nM2\n", "0 BEGIN PGM A MM\n1 END PGM A MM\n"})
    EXPECT_EQ(refusal_of(text), "read") << text;
}

TEST(NoProgram, ProgramsThatComputeAreNone) {
  for (const char* text : {"#1 = 5\nG0 Z#1\n", "G0 Z[5+1]\n"}) EXPECT_EQ(refusal_of(text), "read") << text;
}

}  // namespace
}  // namespace clearcut::read::gcode
