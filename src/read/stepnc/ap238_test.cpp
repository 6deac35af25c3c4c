// AP238 files are refused with what they hold.
#include "read/stepnc/executables.h"
#include "read/stepnc/test_program.h"

namespace clearcut::read::stepnc::testing {
namespace {

const char* const kText = R"(ISO-10303-21;
HEADER;
FILE_SCHEMA(('INTEGRATED_CNC_SCHEMA'));
ENDSEC;
DATA;
#1=MACHINING_WORKPLAN('MAIN',$,'','');
#2=MACHINING_WORKINGSTEP('POCKET',$,'','');
#3=MACHINING_WORKINGSTEP('FACE',$,'','');
#4=MACHINING_WORKPLAN('HOLES',$,'','');
#5=MACHINING_WORKINGSTEP('DRILL',$,'','');
#6=MACHINING_PROCESS_SEQUENCE_RELATIONSHIP('',$,#1,#2,2.);
#7=MACHINING_PROCESS_SEQUENCE_RELATIONSHIP('',$,#1,#3,1.);
#8=MACHINING_PROCESS_SEQUENCE_RELATIONSHIP('',$,#1,#4,3.);
#9=MACHINING_PROCESS_SEQUENCE_RELATIONSHIP('',$,#4,#5,1.);
ENDSEC;
END-ISO-10303-21;
)";

TEST(Ap238, WorkplansAreListedInTheirOrder) {
  const std::vector<std::string> expected{"workplan MAIN (#1)", "  1  workingstep FACE (#3)",
                                          "  2  workingstep POCKET (#2)", "  3  workplan HOLES (#4)",
                                          "    1  workingstep DRILL (#5)"};
  EXPECT_EQ(ap238_lines(kText, "f.stpnc"), expected);
  EXPECT_TRUE(ap238_lines(Program().text(), "t.p21").empty());
}

TEST(Ap238, TheRefusalCountsTheWorkingsteps) {
  try {
    read_stepnc(kText, "f.stpnc", {});
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("it holds 3 workingsteps, which `clearcut info` lists"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace clearcut::read::stepnc::testing
