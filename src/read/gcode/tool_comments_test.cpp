// Tools as the comments of posts name them.
#include <gtest/gtest.h>

#include "read/gcode/recognise.h"

namespace clearcut::read::gcode {
namespace {

std::string proposed(const std::string& program) {
  std::string text;
  for (const ToolComment& one : tools_in_comments(program)) text += (text.empty() ? "" : " ") + one.tool;
  return text;
}

TEST(ToolComments, OfPostsPropose) {
  EXPECT_EQ(proposed("(T1  D=6. CR=0. - ZMIN=-2. - flat end mill)\nG21\nT1 M6\n"), "endmill:6:T1");
  EXPECT_EQ(proposed("(T12  D=10 CR=1 - ZMIN=-2 - bullnose end mill)\nG21\nT12 M6\n"),
            "endmill:10:corner=1:T12");
  EXPECT_EQ(proposed("(T2  D=5. CR=0. TAPER=118deg - ZMIN=-8. - drill)\nG21\nT2 M6\n"), "drill:5:T2");
  EXPECT_EQ(proposed("(T1  D=0.25 CR=0. - ZMIN=-0.1 - flat end mill)\nG20\nT1 M6\n"), "endmill:6.35:T1");
  EXPECT_EQ(proposed("( T1 |  6. FLAT ENDMILL | H1 )\nG21\nT1 M6\n"), "endmill:6:T1") << "Mastercam";
  EXPECT_EQ(proposed("(1 = End Mill {6 mm})\nG21\nT1M06\n(End Mill {6 mm})\n"), "endmill:6:T1") << "Vectric";
  EXPECT_EQ(proposed("(1 = End Mill {1/4 inch})\nG20\nT1M06\n"), "endmill:6.35:T1");
  EXPECT_EQ(proposed("G21\n(TC: 6mm Endmill)\nM5\nM6 T3\n"), "endmill:6:T3") << "FreeCAD";
  EXPECT_EQ(proposed("(Required tools:)\n(  End mill 6mm)\nG21\nM03 S24000\n"), "endmill:6") << "Estlcam";
  EXPECT_EQ(proposed("(Bit: 3mm)\nG21\n"), "endmill:3") << "bCNC";
  EXPECT_EQ(proposed("( T1 : 6.0 )\n( T2 : 3.0 )\nG21\nT1 M6\nT2 M6\n"), "endmill:6:T1 endmill:3:T2")
      << "CamBam";
  EXPECT_EQ(proposed("G21\nT1\n(MSG, Change tool bit to drill size 0.8mm)\nM0\n"), "drill:0.8")
      << "pcb2gcode";
  EXPECT_EQ(proposed("0 BEGIN PGM A MM\n3 ;TOOL 1 - FLAT END MILL D6\n4 TOOL CALL 1 Z S8000\n"),
            "endmill:6:T1");
  EXPECT_EQ(proposed("G21\n(TOOL CHANGE T1: ENDMILL D6)\nT1 M6\n"), "endmill:6:T1") << "our own";
}

TEST(ToolComments, WhoseShapeTakesMoreProposeNothing) {
  EXPECT_EQ(proposed("(T3  D=12. CR=0. TAPER=45deg - chamfer mill)\nT3 M6\n"), "");
  EXPECT_EQ(proposed("(V-Bit {60 deg 12 mm})\nT1 M6\n"), "");
  EXPECT_EQ(proposed("(POCKET 20 mm deep)\nG21\nT1 M6\n"), "");
  EXPECT_EQ(proposed("(DATE=DD-MM-YY)\n(X=100 Y=60)\n"), "");
}

}  // namespace
}  // namespace clearcut::read::gcode
