#include "report/table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "report/words/text_table.h"

namespace clearcut::report {
namespace {

using testing::Each;
using testing::HasSubstr;
using testing::Le;
using testing::Not;

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<std::size_t> widths_of(const std::string& text) {
  std::vector<std::size_t> widths;
  for (const std::string& line : lines_of(text)) widths.push_back(line.size());
  return widths;
}

FeatureFindings feature(const std::string& name, double scale = 1) {
  FeatureFindings f;
  f.name = name;
  f.tool_number = 3;
  f.tool_diameter = 10;
  f.figures.feed_mm = 1234.56 * scale;
  f.figures.rapid_mm = 78.9 * scale;
  f.figures.retracts = 4;
  f.figures.time_s = 3723;
  f.figures.uncut_thickness_mm = 0.0049;
  f.figures.gouge_mm = 0;
  f.figures.engagement.max_deg = 123.4;
  f.figures.clean = true;
  f.layers.resize(5);
  return f;
}

TEST(Table, GivesEachFeatureItsFiguresAndATotal) {
  Findings findings;
  findings.features = {feature("POCKET1")};
  findings.all = findings.features[0].figures;
  const auto lines = lines_of(table({}, findings));
  ASSERT_GE(lines.size(), 5u);
  EXPECT_EQ(lines[0],
            "feature  tool    layers  feed mm  rapid mm  retracts     time  uncut mm  uncut mm2  gouge mm  "
            "eng deg  "
            "clean");
  EXPECT_EQ(lines[2],
            "POCKET1  T3 D10       5   1234.6      78.9         4  1:02:03     0.005       0.00     0.000    "
            "  123  "
            "yes");
  EXPECT_THAT(lines[4], HasSubstr("total"));
  EXPECT_THAT(lines[5], HasSubstr("verdict: CLEAN"));
  EXPECT_THAT(lines[6], HasSubstr("nothing thicker than 0.005 mm"));
}

TEST(Table, FitsTheTerminalWhateverTheFigures) {
  Findings findings;
  findings.features = {feature("a name that is much longer than the column it has to go into", 12345),
                       feature("b")};
  findings.features[0].tool_number = 9999;
  findings.features[0].tool_diameter = 1234567;
  findings.features[0].figures.time_s = 123456;
  findings.features[0].figures.uncut_mm2 = 123456;
  EXPECT_THAT(widths_of(table({}, findings)), Each(Le(120u)));
}

TEST(Table, SaysLoudlyWhatIsNotClean) {
  Findings findings;
  findings.features = {feature("POCKET1")};
  findings.features[0].figures.clean = false;
  for (int i = 0; i < 13; ++i) {
    findings.faults.push_back({FaultKind::kGouge, "POCKET1", {{1, 2}, -3, 40 + i}, 0.25, ""});
  }
  findings.faults[1].text = "The cutter goes 0.25 mm into the wall.";
  const std::string text = table({}, findings);
  EXPECT_THAT(text, HasSubstr("  NO\n"));
  EXPECT_THAT(text, HasSubstr("13 faults:\n"));
  EXPECT_THAT(text, HasSubstr("  gouge 0.250 mm at x 1.000 y 2.000 z -3.000, line 40 in POCKET1\n"));
  EXPECT_THAT(text, HasSubstr("  gouge: The cutter goes 0.25 mm into the wall.\n"));
  EXPECT_THAT(text, HasSubstr("line 49 "));
  EXPECT_THAT(text, Not(HasSubstr("line 50 ")));
  EXPECT_THAT(text, HasSubstr("and 3 more\n"));
}

TEST(Table, GivesNoLengthWhereThereIsNone) {
  Findings findings;
  findings.faults.push_back({FaultKind::kNothingCut, "POCKET1", {}, 12.5, ""});
  EXPECT_THAT(table({}, findings), HasSubstr("  nothing cut at x 0.000"));
}

TEST(Table, PrintsNeitherNanNorUnicode) {
  Findings findings;
  findings.features = {feature("Tasche \xc3\xbc\n<1>")};
  findings.features[0].figures.feed_mm = std::numeric_limits<double>::quiet_NaN();
  findings.features[0].figures.time_s = std::numeric_limits<double>::infinity();
  const std::string text = table({}, findings);
  EXPECT_THAT(text, HasSubstr("Tasche ? <1>"));
  EXPECT_THAT(text, Not(HasSubstr("nan")));
  EXPECT_THAT(text, Not(HasSubstr("inf")));
  EXPECT_THAT(text, Each(testing::AnyOf('\n', testing::AllOf(testing::Ge(' '), Le('~')))));
}

TEST(TextTable, AlignsAndRules) {
  TextTable t{"lengths", {{"name", Align::kLeft}, {"mm"}}, {}, {"a note"}};
  t.add({"a", "1.5"});
  t.add_rule();
  t.add({"longer", "10.25"});
  EXPECT_EQ(plain(t),
            "lengths\n"
            "name       mm\n"
            "-------------\n"
            "a         1.5\n"
            "-------------\n"
            "longer  10.25\n"
            "a note\n");
}

TEST(TextTable, EscapesMarkdown) {
  TextTable t{"", {{"name", Align::kLeft}, {"mm"}}, {{"a|b_c", "1"}, {"short"}}, {}};
  EXPECT_EQ(markdown(t), "| name | mm |\n|:---|---:|\n| a\\|b\\_c | 1 |\n| short |  |\n");
}

TEST(Text, NumbersAreFixedAndNeverMinusZero) {
  EXPECT_EQ(fixed(-0.0001, 3), "0.000");
  EXPECT_EQ(fixed(-0.0006, 3), "-0.001");
  EXPECT_EQ(fixed(std::numeric_limits<double>::quiet_NaN(), 3), "?");
}

TEST(Text, ClockTimes) {
  EXPECT_EQ(clock_time(0), "0:00");
  EXPECT_EQ(clock_time(59.6), "1:00");
  EXPECT_EQ(clock_time(3599.4), "59:59");
  EXPECT_EQ(clock_time(3600), "1:00:00");
  EXPECT_EQ(clock_time(-1), "?");
}

}  // namespace
}  // namespace clearcut::report
