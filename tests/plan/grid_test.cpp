// The grid model from job file to judged program: interpolators, reductions, visits. Table 1 of the grid
// paper.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/error.h"
#include "base/files/file.h"
#include "base/random.h"
#include "pipeline/elements.h"
#include "plan/grid/check.h"
#include "plan/grid/interpolate.h"
#include "plan/grid/reduce.h"
#include "plan/grid/visit.h"
#include "read/elements/read_elements.h"
#include "report/picture/grid_picture.h"
#include "support/command.h"

namespace clearcut {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kExample = std::string(CLEARCUT_SOURCE_DIR) + "/examples/five_pockets.toml";

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

std::string square_pocket(double side, double radius, const std::string& rule) {
  return "middle_row = \"" + rule +
         "\"\n[stock]\nx = [0, 60]\ny = [0, 60]\nz = [-10, 0]\n[[tool]]\ndiameter = " +
         std::to_string(2 * radius) +
         "\n[[element]]\nkind = \"rectangle\"\nbase = [5, 5]\nlength = " + std::to_string(side) +
         "\nwidth = " + std::to_string(side) + "\ndepth = 1\n";
}

SquareGrid grid_with(double cell) {
  return {{0, 0}, cell, 1000, 1000};
}

DesignElement rectangle(Vec2 base, double length, double width, Corner corner = Corner::kLowerLeft) {
  DesignElement element;
  element.from = base;
  element.length = length;
  element.width = width;
  element.base = corner;
  return element;
}

// --- Table 1: counts of squares. The radii are not printed; those below give the printed counts.

struct Table1Row {
  double side, radius;
  const char* rule;
  std::size_t squares, reduced;
};

class Table1 : public ::testing::TestWithParam<Table1Row> {};

TEST_P(Table1, CountsAreThePrintedOnes) {
  const auto& row = GetParam();
  const auto job = read::read_elements_text(square_pocket(row.side, row.radius, row.rule), "row.toml");
  const PointTable table = plan::grid::tabulate(job);
  EXPECT_EQ(table.points.size(), row.squares);
  EXPECT_EQ(count_reduced(table), row.reduced);
}

INSTANTIATE_TEST_SUITE_P(
    GridPaper, Table1,
    ::testing::Values(Table1Row{10, 2, "keep", 121, 16}, Table1Row{12, 2, "keep", 169, 25},
                      Table1Row{20, 3, "keep", 441, 36}, Table1Row{20, 4, "keep", 441, 16},
                      Table1Row{30, 3, "keep", 961, 81}, Table1Row{30, 3, "strict", 961, 64}));

TEST(GridTable, EveryOrderIsProvenWithinTheirSeconds) {
  const report::TextTable table = pipeline::grid_reduction_table();
  ASSERT_EQ(table.rows.size(), 6u);
  for (const auto& row : table.rows) {
    EXPECT_EQ(row[7], "optimal") << row[0];
    EXPECT_LT(std::stod(row[8]), 10000) << row[0] << ": milliseconds; the shortest printed time is 85 s";
  }
}

// --- Interpolators.
//
// Correct means: (1) the centre of every activated square lies within half a square of the curve, in x and in
// y, and (2) no square on the curve is missed. A square is on the curve when the curve runs inside it for
// longer than the distance between two successive points of the interpolator; shorter touches of a corner may
// or may not count. (3) Squares that follow each other touch.

double length_inside(Vec2 a, Vec2 b, Vec2 center, double half) {
  double t0 = 0, t1 = 1;
  const auto clip = [&](double from, double along, double low, double high) {
    if (along == 0) {
      if (from < low || from > high) t1 = t0;
      return;
    }
    const double at_low = (low - from) / along, at_high = (high - from) / along;
    t0 = std::max(t0, std::min(at_low, at_high));
    t1 = std::min(t1, std::max(at_low, at_high));
  };
  clip(a.x, b.x - a.x, center.x - half, center.x + half);
  clip(a.y, b.y - a.y, center.y - half, center.y + half);
  return std::max(0.0, t1 - t0) * distance(a, b);
}

/// Whether the line meets the square, grown by rounding.
bool line_meets(Vec2 a, Vec2 b, Vec2 center, double half) {
  return length_inside(a, b, center, half + 1e-9) > 0;
}

void expect_connected(const std::vector<Square>& squares) {
  for (std::size_t i = 1; i < squares.size(); ++i) {
    ASSERT_LE(std::abs(squares[i].column - squares[i - 1].column), 1);
    ASSERT_LE(std::abs(squares[i].row - squares[i - 1].row), 1);
  }
}

TEST(LinearInterpolator, ActivatesTheSquaresOnTheLine) {
  Random random(1);
  for (int trial = 0; trial < 300; ++trial) {
    const double cell = random.between(0.2, 2);
    const SquareGrid grid = grid_with(cell);
    const Vec2 a{random.between(5, 45), random.between(5, 45)},
        b{random.between(5, 45), random.between(5, 45)};
    const auto points = plan::grid::interpolate_line(a, b, cell);
    const auto squares = plan::grid::activate(points, grid);
    const std::set<Square> active(squares.begin(), squares.end());
    for (const Square s : squares) ASSERT_TRUE(line_meets(a, b, grid.center(s), cell / 2));
    const double spacing = distance(a, b) / static_cast<double>(points.size() - 1);
    for (const Square s : plan::grid::activate_near(a, b, 2 * cell, grid)) {
      if (length_inside(a, b, grid.center(s), cell / 2) > spacing * (1 + 1e-9)) {
        ASSERT_TRUE(active.count(s)) << "column " << s.column << " row " << s.row;
      }
    }
    expect_connected(squares);
  }
}

TEST(LinearInterpolator, ThriceAsManyPointsAsMillimetres) {
  EXPECT_EQ(plan::grid::interpolate_line({0, 0}, {3, 4}, 1).size(), 15u);
  EXPECT_EQ(plan::grid::interpolate_line({0, 0}, {3, 4}, 0.5).size(), 30u);
}

TEST(LinearInterpolator, SteepLinesHaveNoGaps) {
  const auto squares = plan::grid::activate(plan::grid::interpolate_line({10, 0}, {11, 30}, 1), grid_with(1));
  std::set<int> rows;
  for (const Square s : squares) rows.insert(s.row);
  EXPECT_EQ(rows.size(), 31u);
}

DesignElement random_arc(Random& random) {
  DesignElement arc;
  arc.kind = ElementKind::kArc;
  arc.from = {random.between(20, 40), random.between(20, 40)};
  arc.to = arc.from + direction_of(random.between(0, 2 * kPi)) * random.between(3, 20);
  arc.radius = distance(arc.from, arc.to) / 2 * random.between(1, 4);
  arc.direction = random.below(2) ? Turn::kClockwise : Turn::kCounterClockwise;
  return arc;
}

TEST(CircularInterpolator, ActivatesTheSquaresOnTheArc) {
  Random random(2);
  for (int trial = 0; trial < 60; ++trial) {
    const double cell = random.between(0.5, 2);
    const SquareGrid grid = grid_with(cell);
    const Edge arc = plan::grid::arc_of(random_arc(random));
    const auto squares = plan::grid::activate(plan::grid::interpolate_arc(arc, cell), grid);
    const std::set<Square> active(squares.begin(), squares.end());
    // Walk along the true arc in steps far smaller than a square, and measure the stay in each one.
    const int steps = static_cast<int>(arc.length() / cell * 200) + 1;
    std::map<Square, double> stay;
    for (int i = 0; i <= steps; ++i) stay[grid.nearest(arc.at(i / double(steps)))] += arc.length() / steps;
    for (const Square s : squares) {
      double off = 1e9;
      for (int i = 0; i <= steps; ++i) {
        const Vec2 d = arc.at(i / double(steps)) - grid.center(s);
        off = std::min(off, std::max(std::abs(d.x), std::abs(d.y)));
      }
      ASSERT_LE(off, cell / 2 + cell / 200);
    }
    for (const auto& [square, along] : stay) {
      if (along > cell / 2) {
        ASSERT_TRUE(active.count(square)) << "column " << square.column;
      }
    }
    expect_connected(squares);
  }
}

TEST(CircularInterpolator, FindsBothCentresAndChoosesByDirection) {
  Random random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const DesignElement element = random_arc(random);
    for (const Vec2 center : plan::grid::arc_centers(element.from, element.to, element.radius)) {
      EXPECT_NEAR(distance(center, element.from), element.radius, 1e-9);
      EXPECT_NEAR(distance(center, element.to), element.radius, 1e-9);
    }
    const Edge arc = plan::grid::arc_of(element);
    EXPECT_LE(std::abs(arc.sweep()), kPi + 1e-6) << "at most half a turn";
    EXPECT_EQ(arc.sweep() > 0, element.direction == Turn::kCounterClockwise);
  }
}

TEST(CircularInterpolator, StepsOfAMicronMirroredToTheLowerHalf) {
  EXPECT_EQ(plan::grid::circle_step(10, 1), 0.001);
  const auto circle = plan::grid::circle_at_origin(10, 0.001);
  EXPECT_EQ(circle.size(), 2u * 20001u);
  for (std::size_t i = 0; i < circle.size(); ++i) {
    ASSERT_NEAR(norm(circle[i]), 10, 1e-9);
    ASSERT_EQ(circle[i].x, circle[circle.size() - 1 - i].x);
    ASSERT_EQ(circle[i].y, -circle[circle.size() - 1 - i].y);
  }
}

TEST(RectangleInterpolator, IsTheSameFromEveryCornerAndHoldsExactlyTheSquaresInside) {
  Random random(4);
  for (int trial = 0; trial < 100; ++trial) {
    const int x = int(random.below(20)), y = int(random.below(20));
    const int length = 1 + int(random.below(30)), width = 1 + int(random.below(30));
    const SquareGrid grid = grid_with(1);
    const double left = x, low = y, right = x + length, high = y + width;
    const auto squares = plan::grid::activate_rectangle(rectangle({left, low}, length, width), grid);
    std::vector<Square> inside;
    for (int row = 0; row < 60; ++row) {
      for (int column = 0; column < 60; ++column) {
        if (column >= left && column <= right && row >= low && row <= high) inside.push_back({column, row});
      }
    }
    EXPECT_EQ(squares, inside) << "row by row from the lower left";
    using enum Corner;
    EXPECT_EQ(squares,
              plan::grid::activate_rectangle(rectangle({right, low}, length, width, kLowerRight), grid));
    EXPECT_EQ(squares,
              plan::grid::activate_rectangle(rectangle({left, high}, length, width, kUpperLeft), grid));
    EXPECT_EQ(squares,
              plan::grid::activate_rectangle(rectangle({right, high}, length, width, kUpperRight), grid));
  }
}

// --- Reductions: always a subset, in ascending places.

void expect_subset(const plan::grid::Places& places, std::size_t size) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    ASSERT_LT(places[i], size);
    if (i > 0) {
      ASSERT_LT(places[i - 1], places[i]);
    }
  }
}

TEST(EdgePointSearch, FindsTheGeometricEdges) {
  Random random(5);
  for (int trial = 0; trial < 100; ++trial) {
    const int columns = 2 + int(random.below(15)), rows = 2 + int(random.below(15));
    const auto squares =
        plan::grid::activate_rectangle(rectangle({3, 4}, columns - 1, rows - 1), grid_with(1));
    plan::grid::ElementEdges expected;
    for (std::size_t i = 0; i < squares.size(); ++i) {
      const int column = squares[i].column - 3, row = squares[i].row - 4;
      if (column == 0) expected.left.push_back(i);
      if (column == columns - 1) expected.right.push_back(i);
      const bool between = column > 0 && column < columns - 1;
      if (row == 0 && between) expected.lower.push_back(i);
      if (row == rows - 1 && between) expected.upper.push_back(i);
    }
    const auto edges = plan::grid::find_edges(squares);
    ASSERT_EQ(edges.left, expected.left);
    ASSERT_EQ(edges.right, expected.right);
    ASSERT_EQ(edges.lower, expected.lower);
    ASSERT_EQ(edges.upper, expected.upper);
  }
}

TEST(CurveReduction, KeepsWhatLiesOnTheToolsPeripheryFromBothEnds) {
  const auto squares = plan::grid::activate(plan::grid::interpolate_line({0, 5}, {20, 5}, 1), grid_with(1));
  EXPECT_THAT(plan::grid::reduce_curve(squares, 3), ElementsAre(3, 6, 9, 11, 14, 17));
  EXPECT_THAT(plan::grid::reduce_curve(squares, 5), ElementsAre(5, 10, 15));
  EXPECT_THAT(plan::grid::reduce_curve(squares, 30), IsEmpty());
}

TEST(CurveReduction, NoKeptSquareIsNearerToTheEndsThanTheToolsRadius) {
  Random random(6);
  for (int trial = 0; trial < 300; ++trial) {
    const Vec2 a{random.between(5, 45), random.between(5, 45)},
        b{random.between(5, 45), random.between(5, 45)};
    const auto squares = plan::grid::activate(plan::grid::interpolate_line(a, b, 1), grid_with(1));
    const double radius = random.between(1, 6);
    const auto kept = plan::grid::reduce_curve(squares, radius);
    expect_subset(kept, squares.size());
    if (distance(a, b) < 2 * radius + 4) continue;  // too short to stay away from both ends
    for (const std::size_t i : kept) {
      for (const Square end : {squares.front(), squares.back()}) {
        const double d = std::hypot(squares[i].column - end.column, squares[i].row - end.row);
        ASSERT_GE(d, radius - 1e-9);
      }
    }
    EXPECT_FALSE(kept.empty());
  }
}

TEST(RectangleReduction, MiddleRowByBothRules) {
  using enum MiddleRow;
  EXPECT_THAT(plan::grid::kept_rows(0, 12, 3, kKeep), ElementsAre(3, 6, 9)) << "d3 = 0: counted once";
  EXPECT_THAT(plan::grid::kept_rows(0, 12, 3, kStrict), ElementsAre(3, 9)) << "d3 = 0: dropped";
  EXPECT_THAT(plan::grid::kept_rows(0, 13, 3, kKeep), ElementsAre(3, 6, 7, 10)) << "d3 = 1";
  EXPECT_THAT(plan::grid::kept_rows(0, 13, 3, kStrict), ElementsAre(3, 10)) << "d3 = 1 is not > 1";
  EXPECT_THAT(plan::grid::kept_rows(0, 14, 3, kStrict), ElementsAre(3, 6, 8, 11)) << "d3 = 2";
}

TEST(RectangleReduction, StaysOffTheWallsAndCoversThem) {
  Random random(7);
  for (int trial = 0; trial < 200; ++trial) {
    const double radius = random.between(1, 5);
    const int length = int(random.between(2 * radius + 2, 50)),
              width = int(random.between(2 * radius + 2, 50));
    const auto squares = plan::grid::activate_rectangle(rectangle({0, 0}, length, width), grid_with(1));
    const auto kept = plan::grid::reduce_rectangle(squares, radius, MiddleRow::kKeep);
    expect_subset(kept, squares.size());
    ASSERT_FALSE(kept.empty());
    int low = length, high = 0;
    for (const std::size_t i : kept) {
      const auto [column, row] = squares[i];
      ASSERT_GE(std::min({column, row, length - column, width - row}), radius);
      low = std::min(low, column);
      high = std::max(high, column);
    }
    EXPECT_EQ(low, std::ceil(radius));
    EXPECT_EQ(high, length - std::ceil(radius));
  }
}

TEST(AreaReduction, KeepsNoTwoWithinARadiusAndLeavesNoneFarFromThem) {
  Random random(8);
  for (int trial = 0; trial < 60; ++trial) {
    const Vec2 a{random.between(10, 40), random.between(10, 40)},
        b{random.between(10, 40), random.between(10, 40)};
    const auto squares = plan::grid::activate_near(a, b, random.between(1, 8), grid_with(1));
    const double radius = random.between(1, 5);
    const auto kept = plan::grid::reduce_area(squares, radius);
    expect_subset(kept, squares.size());
    const auto apart = [&](std::size_t i, std::size_t k) {
      return std::hypot(squares[i].column - squares[k].column, squares[i].row - squares[k].row);
    };
    for (std::size_t i = 0; i < squares.size(); ++i) {
      double nearest_kept = 1e9;
      for (const std::size_t k : kept) {
        nearest_kept = std::min(nearest_kept, apart(i, k));
        if (std::binary_search(kept.begin(), kept.end(), i) && i != k) {
          ASSERT_GE(apart(i, k), radius - 1e-9);
        }
      }
      ASSERT_LE(nearest_kept, radius + 1);
    }
  }
}

TEST(AreaReduction, FirstPhaseLeavesNoNeighboursOffTheBoundary) {
  const auto squares = plan::grid::activate_rectangle(rectangle({0, 0}, 20, 20), grid_with(1));
  const auto boundary = plan::grid::boundary_of(squares);
  EXPECT_EQ(boundary.size(), 80u);
  const auto kept = plan::grid::reduce_neighbours(squares);
  expect_subset(kept, squares.size());
  EXPECT_TRUE(std::includes(kept.begin(), kept.end(), boundary.begin(), boundary.end()));
  EXPECT_EQ(kept.size(), 80u + 181u) << "of 19 x 19 inner squares one colour of the chessboard";
}

// --- Whole jobs.

/// Every reduced point is visited once, and the program's own feed moves reach it.
void expect_all_visited(const pipeline::ElementsResult& result) {
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

// --- What is written.

TEST(PointTable, SavesOneLineForEveryPoint) {
  const auto job = read::read_elements(kExample);
  const auto result = pipeline::plan_elements(job, {});
  const std::string csv = report::points_csv(job, result.points);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 1365);
  EXPECT_THAT(
      csv, HasSubstr("point,element,id,kind,column,row,x,y,tool,diameter,depth,feed,spindle,reduced,visit\n"
                     "1,1,middle,rectangle,15,15,15,15,1,6,4,800,5300,0,\n"));
}

std::size_t occurrences(const std::string& text, const std::string& of) {
  std::size_t count = 0;
  for (auto at = text.find(of); at != std::string::npos; at = text.find(of, at + 1)) ++count;
  return count;
}

TEST(GridPicture, DrawsEverySquareAndEveryReducedOne) {
  const auto job = read::read_elements(kExample);
  const auto result = pipeline::plan_elements(job, {});
  const std::string svg = report::grid_picture(job, result.points, result.plan.toolpath);
  EXPECT_EQ(occurrences(svg, "<rect"), 1u + 3u + 1365u + 180u) << "page, stocks, squares, reduced squares";
  EXPECT_EQ(occurrences(svg, "<path"), 10u) << "swept area and centre line of five pockets";
}

TEST(ElementsCommand, WritesEverythingAndSaysThatMaterialIsLeft) {
  const test_support::ScratchFolder folder;
  const auto run = test_support::run_clearcut({"elements", kExample, "-o", folder.path("p.ngc"), "--svg",
                                               folder.path("p.svg"), "--certificate", folder.path("p.json"),
                                               "--points", folder.path("p.csv")});
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_THAT(folder.names(), ::testing::UnorderedElementsAre("p.ngc", "p.svg", "p.json", "p.csv"));
  EXPECT_THAT(run.out, HasSubstr("uncut: middle"));
  EXPECT_THAT(read_file(folder.path("p.json")), HasSubstr("\"uncut_thickness_mm\""));
}

TEST(ElementsCommand, TakesElementsAsOptionsInTheOrderTyped) {
  const test_support::ScratchFolder folder;
  const auto run = test_support::run_clearcut({"elements",
                                               "--hole",
                                               "12,12,9:id=first",
                                               "--line",
                                               "25,5,25,35:id=second",
                                               "--hole",
                                               "12,30,9:T2",
                                               "--slot",
                                               "35,8,35,30,6:T2",
                                               "--arc",
                                               "45,8,45,30,11,ccw:T2",
                                               "--pocket",
                                               "60,5,20,20",
                                               "--tool",
                                               "endmill:6",
                                               "--tool",
                                               "endmill:4",
                                               "--depth",
                                               "2",
                                               "-o",
                                               folder.path("p.ngc"),
                                               "--certificate",
                                               folder.path("p.json")});
  EXPECT_NE(run.exit_code, 2) << run.err;
  EXPECT_LT(run.out.find("first"), run.out.find("second"));
  EXPECT_LT(run.out.find("second"), run.out.find("element 3"));
  EXPECT_THAT(read_file(folder.path("p.json")), HasSubstr("\"gouge_mm\": 0"));
}

TEST(ElementsCommand, RefusesBadElementsInOneLineAndWritesNothing) {
  const test_support::ScratchFolder folder;
  const std::vector<std::vector<std::string>> bad{
      {"--hole", "12,12"}, {"--hole", "12,12,9", kExample}, {"--hole", "12,12,3", "--tool", "endmill:6"}};
  for (const auto& options : bad) {
    std::vector<std::string> arguments{"elements", "--depth", "2", "-o", folder.path("p.ngc")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const auto run = test_support::run_clearcut(arguments);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_TRUE(folder.names().empty());
  }
}

TEST(ElementsCommand, RefusesBadJobsInOneLineAndWritesNothing) {
  const test_support::ScratchFolder folder;
  const auto job = folder.file("bad.toml", "[stock]\nx = [0, 9]\ny = [0, 9]\nz = [-1, 0]\n");
  const auto run = test_support::run_clearcut({"elements", job, "-o", folder.path("p.ngc")});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1);
  EXPECT_THAT(run.err, HasSubstr("has no elements"));
  EXPECT_THAT(folder.names(), ElementsAre("bad.toml"));
}

}  // namespace
}  // namespace clearcut
