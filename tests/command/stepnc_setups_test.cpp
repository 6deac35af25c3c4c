// STEP-NC programs of several set-ups, with stops, as a user plans and verifies them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/file.h"
#include "support/command.h"

namespace clearcut {
namespace {

using test_support::run_clearcut;
using test_support::ScratchFolder;
using ::testing::HasSubstr;

/// A pocket of 20 x 14 at (x, 20) of a block of 60 x 40 x 12, as entities from `id` on; its workingstep is `id`.
std::string pocket(int id, const std::string& name, const std::string& x) {
  const auto n = [&](int more) { return "#" + std::to_string(id + more); };
  return n(0) + "=MACHINING_WORKINGSTEP('" + name + "',#9," + n(1) + ",#41,$);\n" + n(1) +
         "=CLOSED_POCKET('" + name + "',#3,(#41)," + n(2) + "," + n(4) + ",(),$,#48,$,$,#50);\n" + n(2) +
         "=AXIS2_PLACEMENT_3D('',#" + std::to_string(id + 3) + ",$,$);\n" + n(3) + "=CARTESIAN_POINT('',(" +
         x + ",20.,12.));\n" + n(4) + "=PLANE('',#52);\n";
}

/// One pocket in each of two set-ups; in the second the block lies a quarter turn on.
std::string two_setups() {
  return "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('MACHINING_SCHEMA'));\nENDSEC;\nDATA;\n"
         "#1=PROJECT('TWO',#2,(#3),$,$,$);\n#2=WORKPLAN('MAIN',(#70,#71),$,$,$);\n"
         "#3=WORKPIECE('W',$,$,$,$,#6,());\n#6=BLOCK('',#12,60.,40.,12.);\n#12=AXIS2_PLACEMENT_3D('',#31,$,$)"
         ";\n"
         "#31=CARTESIAN_POINT('',(0.,0.,0.));\n#9=PLANE('',#16);\n#16=AXIS2_PLACEMENT_3D('',#32,$,$);\n"
         "#32=CARTESIAN_POINT('',(0.,0.,30.));\n#70=WORKPLAN('A',(#100),$,#72,$);\n"
         "#71=WORKPLAN('B',(#75,#200),$,#73,$);\n#75=PROGRAM_STOP('CHECK THE VICE');\n"
         "#72=SETUP('S1',#12,#9,(#77));\n#77=WORKPIECE_SETUP(#3,#12,$,$,());\n"
         "#73=SETUP('S2',#12,#9,(#78));\n#78=WORKPIECE_SETUP(#3,#79,$,$,());\n"
         "#79=AXIS2_PLACEMENT_3D('',#31,$,#80);\n#80=DIRECTION('',(0.,1.,0.));\n" +
         pocket(100, "LEFT", "16.") + pocket(200, "RIGHT", "44.") +
         "#41=BOTTOM_AND_SIDE_ROUGH_MILLING($,$,'OP',5.,$,#68,#69,#90,$,$,$,$,2.,$,0.,0.);\n"
         "#68=MILLING_CUTTING_TOOL('T1 MILL',#74,(),$,$,$);\n#74=ENDMILL(#76,3,.RIGHT.,$,$);\n"
         "#76=MILLING_TOOL_DIMENSION(6.,$,$,20.,0.,$,$);\n"
         "#69=MILLING_TECHNOLOGY(0.015,.TCP.,$,-100.,$,$,$,$,$);\n"
         "#90=MILLING_MACHINE_FUNCTIONS(.T.,$,$,.F.,$,(),.F.,$,$,());\n#48=PLANAR_POCKET_BOTTOM_CONDITION();"
         "\n"
         "#50=RECTANGULAR_CLOSED_PROFILE($,#61,#62);\n#61=TOLERANCED_LENGTH_MEASURE(14.,$);\n"
         "#62=TOLERANCED_LENGTH_MEASURE(20.,$);\n#52=AXIS2_PLACEMENT_3D('',#53,$,$);\n"
         "#53=CARTESIAN_POINT('',(0.,0.,-4.));\nENDSEC;\nEND-ISO-10303-21;\n";
}

TEST(StepNcSetups, AreProgramsOfTheirOwnThatAreVerifiedEach) {
  const ScratchFolder folder;
  const std::string part = folder.file("two.p21", two_setups());
  const std::string program = (std::filesystem::path(part).parent_path() / "two.ngc").string();
  const auto planned = run_clearcut({"plan", part, "-o", program, "--accept", "out-of-reach"});
  EXPECT_EQ(planned.exit_code, 0) << planned.out << planned.err;
  EXPECT_THAT(planned.out, HasSubstr("2 set-ups, verdict: CLEAN"));
  const std::string first = (std::filesystem::path(part).parent_path() / "two-1.ngc").string();
  const std::string second = (std::filesystem::path(part).parent_path() / "two-2.ngc").string();
  EXPECT_THAT(read_file(second, 1 << 20), HasSubstr("(STOP: CHECK THE VICE)\nM0\n"));
  EXPECT_EQ(
      run_clearcut({"verify", first, "--part", part, "--setup", "1", "--accept", "out-of-reach"}).exit_code,
      0);
  const auto verified = run_clearcut({"verify", second, "--part", part, "--setup", "2", "--earlier-setup",
                                      first, "--accept", "out-of-reach"});
  EXPECT_EQ(verified.exit_code, 0) << verified.out << verified.err;
  // The other way about neither pocket is where its program cuts.
  EXPECT_NE(run_clearcut({"verify", first, "--part", part, "--setup", "2", "--earlier-setup", second,
                          "--accept", "out-of-reach"})
                .exit_code,
            0);
}

/// `text` with each `from` replaced.
std::string with(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

/// The pocket of one set-up is narrower than its mill, or lies above the block, or is of a kind that is not planned.
TEST(StepNcSetups, OfWhichNothingCanBeMachinedAreLeftOutAndSaid) {
  const std::string own_profile = with(two_setups(), "ENDSEC;\nEND",
                                       "#54=CIRCULAR_CLOSED_PROFILE($,#55);\n"
                                       "#55=TOLERANCED_LENGTH_MEASURE(5.,$);\nENDSEC;\nEND");
  const auto narrow = [&](const std::string& pocket) {
    const std::size_t at = own_profile.find("CLOSED_POCKET('" + pocket);
    std::string text = own_profile;
    return text.replace(text.find("#50", at), 3, "#54");
  };
  const std::string above = with(two_setups(), "(16.,20.,12.)", "(16.,20.,19.)");
  const std::string unknown = with(two_setups(), "CLOSED_POCKET('LEFT'", "EDGE_ROUND('LEFT'");
  for (const std::string& text : {narrow("LEFT"), above, unknown, narrow("RIGHT")}) {
    const ScratchFolder folder;
    const std::string part = folder.file("two.p21", text);
    const std::filesystem::path place = std::filesystem::path(part).parent_path();
    const auto planned = run_clearcut({"plan", part, "-o", (place / "two.ngc").string()});
    const bool is_first = text != narrow("RIGHT");
    EXPECT_EQ(planned.exit_code, 1) << planned.out << planned.err;
    EXPECT_THAT(planned.out, HasSubstr("2 set-ups, verdict: FAULTY"));
    EXPECT_THAT(planned.out, HasSubstr(is_first ? "NOT MACHINED: LEFT\n" : "NOT MACHINED: RIGHT\n"));
    EXPECT_EQ(std::filesystem::exists(place / "two-1.ngc"), !is_first);
    EXPECT_EQ(std::filesystem::exists(place / "two-2.ngc"), is_first);
    if (!is_first) continue;
    const auto verified = run_clearcut({"verify", (place / "two-2.ngc").string(), "--part", part, "--setup",
                                        "2", "--earlier-setup", "none", "--accept", "out-of-reach"});
    EXPECT_EQ(verified.exit_code, 0) << verified.out << verified.err;
  }
}

/// The program with a face of the whole block in place of each pocket.
std::string two_faces() {
  std::string text = two_setups();
  for (const char* pocket : {"LEFT',#3,(#41),#102,#104,", "RIGHT',#3,(#41),#202,#204,"}) {
    text = with(text, "CLOSED_POCKET('" + std::string(pocket) + "(),$,#48,$,$,#50)",
                "PLANAR_FACE('" + std::string(pocket) + "#55,#56,$,())");
  }
  text = with(with(text, "(16.,20.,12.)", "(0.,0.,12.)"), "(44.,20.,12.)", "(0.,0.,12.)");
  text = with(text, "BOTTOM_AND_SIDE_ROUGH_MILLING($,$,'OP',5.,$,#68,#69,#90,$,$,$,$,2.,$,0.,0.)",
              "PLANE_ROUGH_MILLING($,$,'OP',5.,$,#68,#69,#90,$,$,$,$,2.,$)");
  return with(text, "ENDSEC;\nEND",
              "#55=LINEAR_PATH($,#57,#58);\n#57=TOLERANCED_LENGTH_MEASURE(60.,$);\n"
              "#58=DIRECTION('',(1.,0.,0.));\n#56=LINEAR_PROFILE($,#59);\n"
              "#59=TOLERANCED_LENGTH_MEASURE(40.,$);\nENDSEC;\nEND");
}

TEST(StepNcSetups, WithoutAnythingToCutAreLeftOutOfAWrittenFileAndSaid) {
  const ScratchFolder folder;
  const std::string written = folder.path("written.p21");
  const auto convert = [&](const std::string& text) {
    return run_clearcut({"convert", folder.file("two.p21", text), "--with-toolpaths", "--accept",
                         "out-of-reach", "-o", written});
  };
  // The first face has cut the second away.
  const auto done = convert(two_faces());
  EXPECT_EQ(done.exit_code, 0) << done.out << done.err;
  EXPECT_THAT(done.out, HasSubstr("set-up 2: no program, as nothing in it is left to cut"));
  EXPECT_EQ(run_clearcut({"plan", written, "-o", folder.path("again.ngc")}).exit_code, 0);
  // Neither pocket above the block can be made; the other one is written.
  for (const std::string above : {"(16.,20.,12.)", "(44.,20.,12.)"}) {
    const auto missing = convert(with(two_setups(), above, above.substr(0, 9) + "19.)"));
    EXPECT_EQ(missing.exit_code, 1) << missing.out << missing.err;
    EXPECT_THAT(missing.out,
                HasSubstr(above == "(16.,20.,12.)" ? "NOT MACHINED: LEFT\n" : "NOT MACHINED: RIGHT\n"));
  }
}

TEST(StepNcSetups, AreRefusedWhereNothingOfAnyCanBeMachined) {
  const ScratchFolder folder;
  const std::string part = folder.file("two.p21", with(two_setups(), ",20.,12.)", ",20.,19.)"));
  const std::string program = (std::filesystem::path(part).parent_path() / "two.ngc").string();
  const auto planned = run_clearcut({"plan", part, "-o", program});
  EXPECT_EQ(planned.exit_code, 2);
  EXPECT_THAT(planned.err, HasSubstr("LEFT"));
}

TEST(StepNcSetups, ThatAreNotThereAreRefused) {
  const ScratchFolder folder;
  const std::string part = folder.file("two.p21", two_setups());
  const auto verified = run_clearcut({"verify", part, "--part", part, "--setup", "3"});
  EXPECT_EQ(verified.exit_code, 2);
}

}  // namespace
}  // namespace clearcut
