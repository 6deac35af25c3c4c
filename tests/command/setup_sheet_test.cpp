// The page for the machine: what it states, in which unit, and of whose programs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/file.h"
#include "support/command.h"

namespace clearcut {
namespace {

using test_support::run_clearcut;
using test_support::ScratchFolder;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kJob =
    "[part]\nfile = \"plate.json\"\n"
    "[stock]\nx = [0, 80]\ny = [0, 60]\nz = [-12, 0]\n"
    "[[tool]]\nnumber = 3\nkind = \"endmill\"\nname = \"rougher <8>\"\ndiameter = 8\nflute_length = 20\nfeed "
    "= 600\n"
    "plunge_feed = 150\nspindle = 4000\n";
const std::string kPlate =
    R"({"name": "PLATE & CO", "units": "mm", "outer": [[10, 10, 0], [70, 10, 0], [70, 50, 0], [10, 50, 0]],
        "islands": [], "top": 0, "depth": 7})";

struct Planned {
  ScratchFolder folder;
  std::string job, program, sheet;
};

void plan(Planned& out, const std::vector<std::string>& more = {}) {
  out.folder.file("plate.json", kPlate);
  out.job = out.folder.file("job.toml", kJob);
  out.program = out.folder.path("plate.ngc");
  out.sheet = out.folder.path("sheet.html");
  std::vector<std::string> arguments{"plan", out.job, "-o", out.program, "--setup-sheet", out.sheet};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const auto result = run_clearcut(arguments);
  ASSERT_EQ(result.exit_code, 0) << result.err;
}

TEST(SetupSheet, StatesZeroStockToolsOperationsAndTimes) {
  Planned planned;
  plan(planned);
  const std::string page = read_file(planned.sheet);
  EXPECT_THAT(page, HasSubstr("PLATE &amp; CO"));
  EXPECT_THAT(page, HasSubstr("CLEAN"));
  EXPECT_THAT(page, HasSubstr("80 x 60 x 12 mm; X 0 to 80 mm, Y 0 to 60 mm, Z -12 to 0 mm"));
  EXPECT_THAT(page, HasSubstr("X: left side; Y: front side; Z: top"));
  EXPECT_THAT(page, HasSubstr("X 14 to 66 mm, Y 14 to 46 mm, Z -7 to "));
  EXPECT_THAT(page, HasSubstr("endmill, rougher &lt;8&gt;"));
  // Deepest cut 7 mm below the top, and 5 mm more.
  EXPECT_THAT(page, HasSubstr("<td class=\"n\">20 mm</td>\n    <td class=\"n\">12 mm</td>"));
  EXPECT_THAT(page, HasSubstr("600 / 150"));
  EXPECT_THAT(page, HasSubstr("plate.ngc for linuxcnc"));
  EXPECT_THAT(page, Not(HasSubstr(planned.folder.path("")))) << "no folder of this machine";
}

TEST(SetupSheet, IsInTheProgramsUnit) {
  Planned planned;
  plan(planned, {"--inch"});
  const std::string page = read_file(planned.sheet);
  EXPECT_THAT(page, HasSubstr("3.1496 x 2.3622 x 0.4724 in"));
  EXPECT_THAT(page, HasSubstr("23.62 / 5.91"));
}

TEST(SetupSheet, IsWrittenForAnyProgramAndSaysItsFaults) {
  Planned planned;
  plan(planned);
  std::string program = read_file(planned.program);
  const auto at = program.find("M5");
  ASSERT_NE(at, std::string::npos);
  program.insert(at, "G1 Z-7.5 F100\n");
  const auto wrong = planned.folder.file("wrong.ngc", program);
  const auto sheet = planned.folder.path("wrong.html");
  const auto result = run_clearcut({"setup-sheet", wrong, "--part", planned.job, "-o", sheet});
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_THAT(read_file(sheet), HasSubstr("FAULT: "));
  EXPECT_THAT(read_file(sheet), HasSubstr("verdict FAULTY"));
}

TEST(SetupSheet, OverwritesNoInput) {
  Planned planned;
  plan(planned);
  const auto result =
      run_clearcut({"setup-sheet", planned.program, "--part", planned.job, "-o", planned.program});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("would be overwritten"));
}

}  // namespace
}  // namespace clearcut
