// The grid model: table 1 of the grid paper, interpolators, reductions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/error.h"
#include "base/file.h"
#include "base/random.h"
#include "pipeline/elements.h"
#include "plan/grid/interpolate.h"
#include "plan/grid/visit.h"
#include "read/outline/read_elements.h"
#include "studies/reproduce/reproduce_parts.h"
#include "support/element_jobs.h"

namespace clearcut {
namespace {

using test_support::rectangle;
using test_support::square_pocket;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

SquareGrid grid_with(double cell) {
  return {{0, 0}, cell, 1000, 1000};
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
  const TextTable table = studies::grid_reduction_table();
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

}  // namespace
}  // namespace clearcut
