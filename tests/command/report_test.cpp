// Reports as other programs take them: the picture by rsvg-convert, the page by a browser.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "base/file.h"
#include "base/units.h"
#include "kinematics/kinematics.h"
#include "pipeline/run.h"
#include "report/picture/svg.h"
#include "report/sample_job.h"
#include "report/viewer/html.h"
#include "support/command.h"

namespace clearcut {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

bool installed(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

TEST(Picture, BecomesAPngOfTheWidthAskedFor) {
  if (!installed("rsvg-convert")) GTEST_SKIP() << "rsvg-convert is absent; install the package librsvg2-bin";
  const test_support::ScratchFolder folder;
  const std::string svg_file =
      folder.file("part.svg", report::svg(sample::part(), sample::toolpath(), sample::findings()));
  const std::string png_file = folder.path("part.png"), errors = folder.path("errors");
  ASSERT_EQ(std::system(("rsvg-convert -w 1600 " + svg_file + " -o " + png_file + " 2>" + errors).c_str()), 0)
      << read_file(errors);
  EXPECT_EQ(read_file(errors), "");
  const std::string png = read_file(png_file);
  ASSERT_GT(png.size(), 20000u) << "an empty page is smaller";
  const auto byte = [&png](std::size_t i) {
    return static_cast<unsigned>(static_cast<unsigned char>(png[i]));
  };
  EXPECT_EQ((byte(18) << 8U) + byte(19), 1600u);
}

/// The document after the page's script has run, opened at `moment`; "" when there is no browser.
std::string document_in_browser(const std::string& page, const std::string& moment) {
  const test_support::ScratchFolder folder;
  const std::string file = folder.file("page.html", page);
  const std::string command =
      "timeout 60 chromium --headless --no-sandbox --disable-gpu --no-first-run "
      "--disable-background-networking "
      "--disable-component-update --disable-sync --user-data-dir=" +
      folder.path("profile") + " --virtual-time-budget=2000 --dump-dom 'file://" + file + moment + "' >" +
      folder.path("dom") + " 2>/dev/null";
  return std::system(command.c_str()) == 0 ? read_file(folder.path("dom")) : "";
}

TEST(Page, PlaysInABrowser) {
  if (!installed("chromium")) GTEST_SKIP() << "chromium is absent; install the package chromium";
  std::string program;
  for (int line = 1; line < 60; ++line)
    program += "N" + std::to_string(line) + " <G1> & X" + std::to_string(line) + "\n";
  const std::string page =
      report::html(sample::part(), sample::toolpath(), sample::findings(), {Machine{}, program});

  const std::string at_line = document_in_browser(page, "#line=17");
  EXPECT_THAT(at_line, HasSubstr(">sample &lt;part&gt; &amp; \"name\"</h1>"));
  EXPECT_THAT(at_line, HasSubstr(">FAULTY</strong> <span id=\"reason\">1 fault:</span>"));
  EXPECT_THAT(at_line, HasSubstr("2001&nbsp;mm</dd>"));
  EXPECT_THAT(at_line, HasSubstr(">POCKET1</dd>"));
  EXPECT_THAT(at_line, HasSubstr(">T1 end mill 10 mm</dd>"));
  EXPECT_THAT(at_line, HasSubstr("N17 &lt;G1&gt; &amp; X17"));
  EXPECT_THAT(at_line, HasSubstr("0.25 mm left in the &lt;corner&gt;"));

  // A fault without a line is shown when its feature is done.
  const std::string at_fault = document_in_browser(page, "#fault=0");
  const long seconds =
      std::lround(kinematics::kinematic_time(sample::pocket_section().moves, Machine{}).seconds());
  const std::string clock =
      std::to_string(seconds / 60) + ":" + (seconds % 60 < 10 ? "0" : "") + std::to_string(seconds % 60);
  EXPECT_THAT(at_fault, HasSubstr("\">" + clock + " / ")) << "clock";
}

/// A fixed step of 0.9 D leaves twelve rests in a star.
PlanResult planned_star() {
  std::vector<Vec2> corners;
  for (int i = 0; i < 12; ++i) corners.push_back(direction_of(kPi * i / 6) * (i % 2 == 0 ? 50 : 28.8675));
  Part part;
  part.name = part.source_file = "star";
  Feature feature;
  feature.name = "star";
  feature.target = feature.allowed = {Region::from_valid_loops(loop_from_points(corners), {})};
  feature.floor_z = -2;
  part.features = {feature};
  part.workplan.push_back({});
  PlanOptions options;
  options.tools = {resolve::parse_tool("endmill:8")};
  options.strategy = "fixed";
  return pipeline::plan_part(part, options);
}

/// The document at a moment of a plan's page.
std::string page_at(const PlanResult& result, const char* moment, const Toolpath* earlier = nullptr) {
  return document_in_browser(
      report::html(result.part, result.toolpath, result.findings, {Machine{}, result.program, earlier}),
      moment);
}

/// mm2 that the page colours at its end; absent where it colours nothing.
std::optional<double> left_in(const std::string& document) {
  const std::string left = "data-left-mm2=\"";
  const auto found = document.find(left);
  if (found == std::string::npos) return std::nullopt;
  return std::stod(document.substr(found + left.size()));
}

/// The page colours what the certificate counts.
TEST(Page, ColoursWhatIsLeft) {
  if (!installed("chromium")) GTEST_SKIP() << "chromium is absent; install the package chromium";
  const PlanResult result = planned_star();
  ASSERT_FALSE(result.findings.all.clean);
  const double uncut = result.findings.all.uncut_mm2;
  EXPECT_NEAR(left_in(page_at(result, "#t=1e9")).value_or(0), uncut, 0.25 * uncut);
  EXPECT_FALSE(left_in(page_at(result, "#t=1"))) << "nothing is left before the end";
}

/// Lines over the whole star, 2 mm deep.
Toolpath cut_before(const Part& part) {
  Section section;
  section.tool_number = part.tools.front().number;
  for (int y = -52; y <= 52; y += 4) {
    Move move;
    move.path = Edge::line({-52.0, static_cast<double>(y)}, {52.0, static_cast<double>(y)});
    move.z_from = move.z_to = -2;
    section.moves.push_back(move);
  }
  return {{section}};
}

/// What was cut before is not there, and a hollow under a ceiling shows where the cutter has come down to it.
TEST(Page, BeginsWithWhatWasCutBefore) {
  if (!installed("chromium")) GTEST_SKIP() << "chromium is absent; install the package chromium";
  const PlanResult result = planned_star();
  const double uncut = result.findings.all.uncut_mm2;
  Toolpath earlier = cut_before(result.part);
  EXPECT_EQ(left_in(page_at(result, "#t=1e9", &earlier)), 0.0);
  earlier.sections.front().carried_below = -1;
  EXPECT_NEAR(left_in(page_at(result, "#t=1e9", &earlier)).value_or(0), uncut, 0.25 * uncut);
}

}  // namespace
}  // namespace clearcut
