#include "report/sheet/setup_sheet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/sample_job.h"

namespace clearcut::report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Findings findings_of(const Part& part) {
  Findings findings;
  for (int i = 0; i < static_cast<int>(part.workplan.size()); ++i) {
    FeatureFindings one;
    one.workingstep = i;
    one.tool_number = 1;
    one.figures.clean = true;
    findings.features.push_back(one);
  }
  return findings;
}

Section cut(int workingstep, double feed, double plunge, Vec2 at) {
  Section section;
  section.workingstep = workingstep;
  section.tool_number = 1;
  section.spindle_rpm = 9000;
  section.moves = {
      {Edge::line(at, at), 5, -4, MoveKind::kPlunge, MmPerMin::of(plunge), 0},
      {Edge::line(at, at + Vec2{5, 0}), -4, -4, MoveKind::kCut, MmPerMin::of(feed), 0},
      {Edge::line(at + Vec2{5, 0}, at + Vec2{9, 0}), -4, -4, MoveKind::kCut, MmPerMin::of(feed / 2), 0},
  };
  return section;
}

/// The slot, the second feature, is cut first and third: its badge says those rows.
TEST(ComposeSheet, NumbersInThePictureAreTheTablesRows) {
  Part part = sample::part();
  part.workplan.push_back(part.workplan[1]);
  Toolpath toolpath;
  toolpath.sections = {cut(1, 800, 100, {85, 15}), cut(0, 600, 100, {20, 20}), cut(2, 700, 100, {85, 15})};
  const SetupSheet sheet = compose_sheet(part, toolpath, findings_of(part), {"a.ngc", "linuxcnc"});
  ASSERT_EQ(sheet.operations.rows.size(), 3U);
  EXPECT_THAT(sheet.operations.rows[0][1], HasSubstr("SLOT <2>"));
  EXPECT_THAT(sheet.operations.rows[1][1], HasSubstr("POCKET1"));
  EXPECT_THAT(sheet.picture, HasSubstr(">1, 3</text>"));
  EXPECT_THAT(sheet.picture, HasSubstr(">2</text>"));
}

/// Whatever the part asks for: what the program drives.
TEST(ComposeSheet, FeedsAreTheProgramsOwn) {
  Part part = sample::part();
  for (Workingstep& step : part.workplan) {
    step.operation.cutting.feed = MmPerMin::of(1234);
    step.operation.cutting.spindle_rpm = 4321;
  }
  Toolpath toolpath;
  toolpath.sections = {cut(0, 800, 90, {20, 20})};
  const SetupSheet sheet = compose_sheet(part, toolpath, findings_of(part), {"a.ngc", "linuxcnc"});
  std::string row;
  for (const std::string& cell : sheet.operations.rows[0]) row += cell + "|";
  EXPECT_THAT(row, HasSubstr("|9000|400 to 800 / 90|"));
  EXPECT_THAT(row, Not(HasSubstr("1234")));
}

}  // namespace
}  // namespace clearcut::report
