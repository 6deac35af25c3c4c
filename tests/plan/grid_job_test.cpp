// The grid model: whole jobs and their validation.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.h"
#include "base/file.h"
#include "pipeline/elements.h"
#include "plan/grid/shape.h"
#include "read/outline/read_elements.h"
#include "support/command.h"
#include "support/element_jobs.h"

namespace clearcut {
namespace {

using test_support::kExample;
using test_support::rectangle;
using test_support::square_pocket;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

ElementJob job_with(const std::string& elements, const std::string& head = "") {
  return read::read_elements_text(head + R"(
[stock]
x = [0, 60]
y = [0, 60]
z = [-10, 0]
[[tool]]
number = 1
diameter = 6
[[tool]]
number = 2
diameter = 4
)" + elements,
                                  "job.toml");
}

// --- Whole jobs.

/// Every reduced point is visited once, and the program's own feed moves reach it.
void expect_all_visited(const ElementsResult& result) {
  std::set<int> visits;
  for (const auto& point : result.points.points) {
    EXPECT_EQ(point.visit > 0, point.reduced);
    if (!point.reduced) continue;
    EXPECT_TRUE(visits.insert(point.visit).second);
    double away = 1e9;
    for (const auto& section : result.plan.toolpath.sections) {
      for (const auto& move : section.moves) {
        if (is_rapid(move.kind)) continue;
        away = std::min(
            away, move.is_vertical() ? distance(move.path.to, point.at) : distance(move.path, point.at));
      }
    }
    EXPECT_LE(away, 1e-3) << "point of element " << point.element;
  }
  EXPECT_EQ(visits.size(), count_reduced(result.points));
  ASSERT_FALSE(visits.empty());
  EXPECT_EQ(*visits.rbegin(), static_cast<int>(visits.size()));
}

TEST(ElementJob, FivePocketsBecomeAProgramThatGougesNothingAndSaysWhatTheRuleLeaves) {
  const auto job = read::read_elements(kExample);
  ASSERT_EQ(job.elements.size(), 5u);
  const auto result = pipeline::plan_elements(job, {});
  EXPECT_EQ(result.points.points.size(), 441u + 4 * 231u);
  EXPECT_EQ(count_reduced(result.points), 5 * 36u);
  expect_all_visited(result);
  EXPECT_LE(result.plan.findings.all.gouge_mm, 0.001);
  EXPECT_EQ(result.plan.findings.all.rapid_in_material, 0);
  // Squares along a wall stand at most a radius apart. Where no move joins two of them the discs about them
  // leave a cusp of R (1 - sqrt(3) / 2).
  for (const auto& feature : result.plan.findings.features) {
    const double cusp = feature.tool_diameter / 2 * (1 - std::sqrt(3) / 2);
    EXPECT_GT(feature.figures.uncut_thickness_mm, 0.01) << feature.name;
    EXPECT_LE(feature.figures.uncut_thickness_mm, cusp) << feature.name;
  }
  for (const auto& fault : result.plan.findings.faults)
    EXPECT_EQ(fault.kind, FaultKind::kUncut) << fault.text;
  EXPECT_EQ(pipeline::plan_elements(job, {}).plan.program, result.plan.program) << "same job, same bytes";
}

TEST(ElementJob, ToolsFollowEachOtherInTheJobsOrder) {
  const auto result = pipeline::plan_elements(read::read_elements(kExample), {});
  std::vector<int> tools;
  for (const auto& section : result.plan.toolpath.sections) tools.push_back(section.tool_number);
  EXPECT_THAT(tools, ElementsAre(1, 2, 2, 2, 2));
}

const char* kEveryKind = R"(
[[element]]
id = "line"
kind = "line"
from = [5, 5]
to = [35, 5]
tool = 2
depth = 2
[[element]]
id = "slanted"
kind = "line"
from = [5, 12]
to = [38, 20]
tool = 2
depth = 2
[[element]]
id = "arc"
kind = "arc"
from = [10, 30]
to = [30, 30]
radius = 12
direction = "cw"
tool = 2
depth = 5
[[element]]
id = "drilled"
kind = "hole"
center = [50.3, 50.2]
diameter = 6
depth = 4
[[element]]
id = "hole"
kind = "hole"
center = [50, 30]
diameter = 14
depth = 4
[[element]]
id = "slot"
kind = "slot"
from = [10, 50]
to = [35, 50]
width = 10
depth = 3
[[element]]
id = "narrow slot"
kind = "slot"
from = [50, 5]
to = [54, 15]
width = 6
depth = 3
)";

TEST(ElementJob, EveryKindIsCutWithoutGougeAndExactFitsAreClean) {
  const auto result = pipeline::plan_elements(job_with(kEveryKind), {});
  expect_all_visited(result);
  ASSERT_EQ(result.plan.findings.features.size(), 7u);
  std::set<std::string> clean;
  for (const auto& feature : result.plan.findings.features) {
    EXPECT_LE(feature.figures.gouge_mm, 0.001) << feature.name;
    EXPECT_LE(feature.figures.uncut_thickness_mm, 3)
        << feature.name << ": no square is farther than a radius";
    if (feature.figures.clean) clean.insert(feature.name);
  }
  EXPECT_THAT(clean, ::testing::IsSupersetOf({"drilled", "line", "narrow slot"}));
  EXPECT_FALSE(clean.count("hole")) << "its wall keeps cusps, and the certificate says so";
}

TEST(ElementJob, FinerSquaresLeaveLessAtTheEndsOfSlantedGrooves) {
  const std::string line =
      "[[element]]\nkind = \"line\"\nfrom = [5, 12]\nto = [38, 20]\ntool = 2\ndepth = 2\n";
  const auto left_at = [&](const std::string& resolution) {
    return pipeline::plan_elements(job_with(line, "resolution = " + resolution), {})
        .plan.findings.all.uncut_thickness_mm;
  };
  EXPECT_LT(left_at("0.05"), left_at("1.0"));
  EXPECT_LE(left_at("0.05"), 0.05 * std::sqrt(2));
}

TEST(ElementJob, AToolRadiusBetweenSquaresIsToldAndStaysOffTheWall) {
  const auto job = read::read_elements_text(square_pocket(20, 2.4, "keep"), "off.toml");
  const auto result = pipeline::plan_elements(job, {});
  EXPECT_LE(result.plan.findings.all.gouge_mm, 0.001);
  bool told = false;
  for (const auto& item : result.plan.part.diagnostics.items())
    told = told || item.what.find("no whole number of squares") != std::string::npos;
  EXPECT_TRUE(told);
}

// --- Validation: every rule, with its message, and all of them at once.

struct Rule {
  const char* name;
  const char* element;
  const char* message;
};

void PrintTo(const Rule& rule, std::ostream* out) {
  *out << rule.name;
}

class Validation : public ::testing::TestWithParam<Rule> {};

TEST_P(Validation, NamesTheFault) {
  const auto job = job_with(std::string("[[element]]\nid = \"e\"\n") + GetParam().element);
  const auto faults = plan::grid::faults_of(job);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_THAT(faults.front().text, HasSubstr(GetParam().message));
  EXPECT_THAT(faults.front().place, HasSubstr("job.toml:12"));
}

INSTANTIATE_TEST_SUITE_P(
    Rules, Validation,
    ::testing::Values(
        Rule{"ZeroLength", "kind = \"line\"\nfrom = [5, 5]\nto = [5, 5]\ndepth = 1", "has length 0"},
        Rule{"NoWidth", "kind = \"rectangle\"\nbase = [5, 5]\nlength = 9\nwidth = 0\ndepth = 1",
             "length 9 and width 0"},
        Rule{"RadiusTooSmall",
             "kind = \"arc\"\nfrom = [10, 30]\nto = [30, 30]\nradius = 9\ndirection = \"cw\"\ndepth = 1",
             "radius 9 mm, too small for its chord of 20 mm: at least 10 mm"},
        Rule{"ToolTooLargeForPocket", "kind = \"rectangle\"\nbase = [5, 5]\nlength = 9\nwidth = 5\ndepth = 1",
             "tool 1 of radius 3 mm is too large for half the side of 5 mm"},
        Rule{"ToolTooLargeForLine", "kind = \"line\"\nfrom = [5, 5]\nto = [8, 9]\ndepth = 1",
             "tool 1 of radius 3 mm is too large for the 5 mm from end to end"},
        Rule{"ToolTooLargeForArc",
             "kind = \"arc\"\nfrom = [10, 30]\nto = [14, 30]\nradius = 2.5\ndirection = \"cw\"\ndepth = 1",
             "tool 1 of radius 3 mm is too large for the arc's radius of 2.5 mm"},
        Rule{"ToolTooLargeForHole", "kind = \"hole\"\ncenter = [30, 30]\ndiameter = 5\ndepth = 1",
             "tool 1 of radius 3 mm is too large for the width of 5 mm"},
        Rule{"OutsideTheStock", "kind = \"rectangle\"\nbase = [50, 1]\nlength = 14\nwidth = 20\ndepth = 1",
             "x 50..64 y 1..21, outside the stock x 0..60 y 0..60"},
        Rule{"TooDeep", "kind = \"hole\"\ncenter = [30, 30]\ndiameter = 8\ndepth = 11",
             "11 mm deep in stock of 10"},
        Rule{"NoDepth", "kind = \"hole\"\ncenter = [30, 30]\ndiameter = 8\ndepth = 0", "depth 0"},
        Rule{"UnknownTool", "kind = \"hole\"\ncenter = [30, 30]\ndiameter = 8\ndepth = 1\ntool = 7",
             "uses tool 7, which the job does not have"}),
    [](const auto& each) { return each.param.name; });

TEST(ElementJob, AllFaultsAreNamedOnOneLine) {
  const auto job = job_with(R"(
[[element]]
id = "a"
kind = "line"
from = [5, 5]
to = [5, 5]
depth = 20
[[element]]
id = "a"
kind = "hole"
center = [5, 5]
diameter = 3
depth = 1
)");
  try {
    plan::grid::check(job);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_THAT(message, HasSubstr("4 faults: "));
    EXPECT_THAT(message, HasSubstr("has length 0"));
    EXPECT_THAT(message, HasSubstr("20 mm deep"));
    EXPECT_THAT(message, HasSubstr("the id is used before"));
    EXPECT_THAT(message, HasSubstr("too large"));
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

TEST(ElementJob, AnEmptyStrictReductionIsAFaultBeforePlanning) {
  const auto job = read::read_elements_text(square_pocket(5, 2, "strict"), "strict.toml");
  ASSERT_EQ(plan::grid::faults_of(job).size(), 1u);
  EXPECT_THAT(plan::grid::faults_of(job).front().text, HasSubstr("middle_row = \"keep\""));
}

TEST(ElementJob, AbsurdSizesAreRefusedAtOnce) {
  const char* pocket =
      "[[element]]\nkind = \"rectangle\"\nbase = [5, 5]\nlength = 20\nwidth = 20\ndepth = 1\n";
  for (const char* resolution : {"1e-300", "1e-9", "0.001", "100.0", "1e300"})
    EXPECT_FALSE(plan::grid::faults_of(job_with(pocket, std::string("resolution = ") + resolution)).empty())
        << resolution;
  const char* huge =
      "[[element]]\nkind = \"rectangle\"\nbase = [5, 5]\nlength = 1e300\nwidth = 1e12\ndepth = 1\n";
  EXPECT_FALSE(plan::grid::faults_of(job_with(huge)).empty());
  const char* arc =
      "[[element]]\nkind = \"arc\"\nfrom = [5, 5]\nto = [30, 5]\nradius = 1e200\ndirection = \"cw\"\ndepth = "
      "1\n";
  EXPECT_FALSE(plan::grid::faults_of(job_with(arc)).empty());
}

TEST(ElementJob, SpellingMistakesAreFound) {
  try {
    job_with("[[element]]\nkind = \"hole\"\ncentre = [1, 2]\n");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("job.toml:12"));
    EXPECT_THAT(error.what(), HasSubstr("center is missing"));
  }
}

}  // namespace
}  // namespace clearcut
