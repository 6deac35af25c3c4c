// What is mended in drawings and what is refused.
#include "read/repair/repair.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/units.h"
#include "read/repair/clean.h"
#include "read/repair/test_curves.h"

namespace clearcut::read {
namespace {

using testing::closed;
using ::testing::HasSubstr;
using testing::open;
using testing::options;
using testing::refusal;
using testing::Repaired;
using testing::repaired;

RawCurve square(double x, double y, double side) {
  return closed({{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}});
}

RawCurve circle(Vec2 center, double radius) {
  return {full_circle(center, radius), true, "circle", {}};
}

/// A path of a plotter file over one side of a square, a hundred thousand times.
TEST(Repair, WhatGoesForthAndBackByTheThousandIsReadAtOnce) {
  std::vector<Vec2> points{{0, 0}};
  for (int i = 1; i < 100000; ++i) points.push_back({i % 2 == 1 ? 40.0 : 0.0, 0});
  points.insert(points.end(), {{40, 40}, {0, 40}});
  const Repaired result = repaired({closed(points)});
  ASSERT_EQ(result.regions.size(), 1u);
  EXPECT_NEAR(area(result.regions), 1600, 1e-6);
  EXPECT_EQ(result.count(Severity::kRepair, "forth and back"), 1);
}

TEST(Repair, CleanOutlinesPassUnchangedAndInSilence) {
  const Repaired result = repaired({square(0, 0, 50), circle({25, 25}, 5)});
  ASSERT_EQ(result.regions.size(), 1u);
  EXPECT_DOUBLE_EQ(area(result.regions), 2500 - kPi * 25);
  EXPECT_TRUE(result.said.empty());
}

TEST(Repair, OrientationIsPutRight) {
  const Repaired result = repaired({closed({{0, 0}, {0, 9}, {9, 9}, {9, 0}})});
  EXPECT_DOUBLE_EQ(signed_area(result.regions[0].outer()), 81);
}

TEST(Repair, LooseSegmentsInAnyOrderAndDirectionAreChained) {
  const Repaired result = repaired({open({{0, 0}, {10, 0}}), open({{10, 10}, {0, 10}}),
                                    open({{10, 10}, {10, 0}}), open({{0, 0}, {0, 10}})});
  EXPECT_DOUBLE_EQ(area(result.regions), 100);
  EXPECT_TRUE(result.said.empty());
}

TEST(Repair, GapsWithinTheJoinGapAreClosedAndReportedWithPlaceAndSize) {
  const Repaired result = repaired({open({{0, 0}, {10, 0}}), open({{10, 0.008}, {10, 10}, {0, 10}, {0, 0}})});
  EXPECT_NEAR(area(result.regions), 100, 0.1);
  ASSERT_EQ(result.count(Severity::kRepair, "closed a gap of 0.008 mm"), 1);
  EXPECT_THAT(result.said[0].where, HasSubstr("(10, 0)"));
}

TEST(Repair, LargerGapsAreRefusedSayingWhereAndHowLarge) {
  const std::string message =
      refusal({open({{0, 0}, {10, 0}}), open({{10, 0.5}, {10, 10}, {0, 10}, {0, 0}})});
  EXPECT_THAT(message, HasSubstr("test.dxf: the outline is open at (10, 0)"));
  EXPECT_THAT(message, HasSubstr("0.5 mm away at (10, 0.5)"));
}

TEST(Repair, OpenCurvesAreLeftOutWhenAskedForAndReported) {
  RepairOptions how = options();
  how.open_curves = OpenCurves::kSkip;
  const Repaired result = repaired({square(0, 0, 50), open({{60, 0}, {70, 0}})}, how);
  EXPECT_EQ(result.regions.size(), 1u);
  EXPECT_EQ(result.count(Severity::kSkipped, "an open curve of 10 mm"), 1);
}

TEST(Repair, ArcEndsStayWhereLinesCanMove) {
  RawCurve arc{{Edge::arc({10, 0}, {0, 10}, {0, 0}, Turn::kCounterClockwise)}, false, "arc", {}};
  const Repaired result = repaired({arc, open({{0, 10.005}, {0, 0}, {10.004, 0}})});
  ASSERT_EQ(result.regions.size(), 1u);
  for (const Edge& edge : result.regions[0].outer()) {
    if (edge.is_arc()) {
      EXPECT_EQ(edge.center, (Vec2{0, 0}));
      EXPECT_DOUBLE_EQ(edge.radius(), 10);
    }
  }
  EXPECT_EQ(result.count(Severity::kRepair, "closed a gap"), 2);
}

TEST(Repair, ArcsWithInconsistentRadiiGetOneCenterOrAreRefused) {
  const auto with_center = [](Vec2 center) {
    return RawCurve{
        {Edge::arc({10, 0}, {-10, 0}, center, Turn::kCounterClockwise), Edge::line({-10, 0}, {10, 0})},
        true,
        "arc",
        {}};
  };
  const Repaired result = repaired({with_center({0.002, 0})});
  EXPECT_EQ(result.count(Severity::kRepair, "radii"), 1);
  const Edge& arc = *std::find_if(result.regions[0].outer().begin(), result.regions[0].outer().end(),
                                  [](const Edge& e) { return e.is_arc(); });
  EXPECT_NEAR(distance(arc.from, arc.center), distance(arc.to, arc.center), 1e-12);
  EXPECT_THAT(refusal({with_center({1, 0})}), HasSubstr("radii 9 and 11 mm"));
}

TEST(Repair, TinyEdgesVanishWithoutShorteningARunOfThem) {
  std::vector<Vec2> points{{0, 0}, {10, 0}, {10, 10}};
  for (int i = 1; i <= 20000; ++i) points.push_back({10 - i * 5e-5, 10 + i * 5e-5});
  points.push_back({0, 10});
  const Repaired result = repaired({closed(points)});
  EXPECT_NEAR(area(result.regions), std::abs(signed_area(loop_from_points(points))), 1e-3);
  EXPECT_LT(result.regions[0].outer().size(), 15000u);
}

TEST(Repair, DuplicatesCountOnce) {
  const Repaired lines = repaired({open({{0, 0}, {10, 0}}), open({{10, 0}, {0, 0.001}}),
                                   open({{10, 0}, {10, 10}}), open({{10, 10}, {0, 0}})});
  EXPECT_NEAR(area(lines.regions), 50, 0.01);
  EXPECT_EQ(lines.count(Severity::kRepair, "drawn twice"), 1);
  const Repaired loops = repaired({square(0, 0, 10), closed({{10, 0}, {10, 10}, {0, 10}, {0, 5}, {0, 0}})});
  EXPECT_NEAR(area(loops.regions), 100, 1e-9);
  EXPECT_EQ(loops.count(Severity::kRepair, "drawn twice"), 1);
}

/// A square of loose sides, of which the lower is drawn in pieces that overlap.
std::vector<RawCurve> square_with_base(const std::vector<std::vector<Vec2>>& base) {
  std::vector<RawCurve> curves{open({{60, 0}, {60, 40}}), open({{60, 40}, {0, 40}}), open({{0, 40}, {0, 0}})};
  for (const auto& piece : base) curves.push_back(open(piece));
  return curves;
}

TEST(Repair, CurvesThatRunAlongEachOtherCountOnce) {
  const std::vector<std::vector<std::vector<Vec2>>> bases{
      {{{0, 0}, {60, 0}}, {{20, 0}, {60, 0}}},                      // a piece again, to the corner
      {{{60, 0}, {0, 0}}, {{20, 0}, {30, 0}}},                      // a piece again, in the middle
      {{{0, 0}, {40, 0}}, {{30, 0}, {60, 0}}},                      // two that overlap in part
      {{{0, 0}, {40, 0}}, {{60, 0}, {30, 0}}, {{10, 0}, {50, 0}}},  // and a third over both
      {{{0, 0}, {25, 0}}, {{20, 0}, {45, 0}}, {{40, 0}, {60, 0}}},  // three in a row
      {{{0, 0}, {40, 0}}, {{60, 0}, {39.984, 0}}}};  // two that overlap by little more than a gap
  for (const auto& base : bases) {
    const Repaired result = repaired(square_with_base(base));
    ASSERT_EQ(result.regions.size(), 1U);
    EXPECT_DOUBLE_EQ(area(result.regions), 2400);
    EXPECT_EQ(result.regions[0].outer().size(), 4U);
    EXPECT_GE(result.count(Severity::kRepair, "run along each other"), 1);
  }
}

TEST(Repair, ArcsThatRunAlongEachOtherCountOnce) {
  const Vec2 center{0, 0};
  const auto arc = [&](double from, double to) {
    return RawCurve{{Edge::arc(Vec2{10 * std::cos(from), 10 * std::sin(from)},
                               Vec2{10 * std::cos(to), 10 * std::sin(to)}, center, Turn::kCounterClockwise)},
                    false,
                    "arc",
                    {}};
  };
  const Repaired result = repaired({arc(0, 2), arc(1.5, kPi), open({{-10, 0}, {10, 0}})});
  EXPECT_NEAR(area(result.regions), 50 * kPi, 1e-6);
  EXPECT_EQ(result.count(Severity::kRepair, "run along each other"), 1);
}

TEST(Repair, APieceOfAnOutlineDrawnAgainIsDropped) {
  const Repaired result = repaired({square(0, 0, 50), open({{10, 0}, {30, 0}})});
  EXPECT_DOUBLE_EQ(area(result.regions), 2500);
  EXPECT_EQ(result.count(Severity::kRepair, "run along each other"), 1);
}

/// Pockets that share part of a wall, each drawn whole, are left as drawn; what leads on alone is still open.
TEST(Repair, OnlyEdgesWithAnOpenEndGiveWay) {
  const Repaired result =
      repaired({open({{0, 0}, {10, 0}}), open({{10, 0}, {10, 20}}), open({{10, 20}, {0, 20}}),
                open({{0, 20}, {0, 0}}), open({{10, 5}, {20, 5}}), open({{20, 5}, {20, 15}}),
                open({{20, 15}, {10, 15}}), open({{10, 15}, {10, 5}})});
  EXPECT_NEAR(area(result.regions), 300, 1e-9);
  EXPECT_EQ(result.count(Severity::kRepair, "run along"), 0);
  EXPECT_THAT(refusal(square_with_base({{{0, 0}, {60, 0}}, {{20, 0}, {20, 10}}})), HasSubstr("open at"));
  EXPECT_THAT(refusal(square_with_base({{{0, 0}, {60, 0}}, {{20, 0.5}, {60, 0.5}}})), HasSubstr("open at"));
}

TEST(Repair, NestingAlternatesToAnyDepth) {
  std::vector<RawCurve> curves;
  double expected = 0;
  for (int i = 0; i < 9; ++i) {
    curves.push_back(square(i, i, 40 - 2 * i));
    expected += (i % 2 == 0 ? 1 : -1) * (40.0 - 2 * i) * (40 - 2 * i);
  }
  std::reverse(curves.begin() + 2, curves.end());
  const Repaired result = repaired(std::move(curves));
  EXPECT_EQ(result.regions.size(), 5u);
  EXPECT_NEAR(area(result.regions), expected, 1e-9);
}

TEST(Repair, PinchesAreSplitExactly) {
  const Repaired hourglass = repaired({closed({{0, 0}, {10, 0}, {5, 5}, {10, 10}, {0, 10}, {5, 5}})});
  EXPECT_EQ(hourglass.regions.size(), 2u);
  EXPECT_DOUBLE_EQ(area(hourglass.regions), 50);
  EXPECT_EQ(hourglass.count(Severity::kRepair, "touches itself"), 1);
  const Repaired on_edge = repaired({closed({{0, 0}, {10, 0}, {10, 10}, {5, 0}, {0, 10}})});
  EXPECT_EQ(on_edge.regions.size(), 2u);
  EXPECT_DOUBLE_EQ(area(on_edge.regions), 50);
}

TEST(Repair, AKeyholeOutlineBecomesAnOutlineWithAnIsland) {
  const Repaired result = repaired({closed(
      {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 5}, {3, 5}, {3, 7}, {7, 7}, {7, 3}, {3, 3}, {3, 5}, {0, 5}})});
  ASSERT_EQ(result.regions.size(), 1u);
  EXPECT_EQ(result.regions[0].islands().size(), 1u);
  EXPECT_NEAR(area(result.regions), 84, 1e-6);
}

TEST(Repair, SmallCurlsAreRemovedAndReported) {
  const Repaired result = repaired({closed({{0, 0}, {50, 0}, {50, 50.05}, {50.05, 50}, {0, 50}})});
  ASSERT_EQ(result.regions.size(), 1u);
  EXPECT_NEAR(area(result.regions), 2500, 0.1);
  EXPECT_EQ(result.count(Severity::kRepair, "curl"), 1);
}

TEST(Repair, ALineThatLeansIntoATangentArcEndsWhereTheyCross) {
  // A half circle bites into the right side; its tangent, the bottom, leans into it by 0.005 rad.
  const auto bitten = [](double left) {
    return RawCurve{{Edge::line({0, left}, {10, 0}), Edge::arc({10, 0}, {10, 4}, {10, 2}, Turn::kClockwise),
                     Edge::line({10, 4}, {0, 4}), Edge::line({0, 4}, {0, left})},
                    true,
                    "bite",
                    {}};
  };
  EXPECT_TRUE(repaired({bitten(-0.05)}).said.empty());
  const Repaired result = repaired({bitten(0.05)});
  EXPECT_EQ(result.count(Severity::kRepair, "joined at the crossing: a sliver of 2.5e-05 mm"), 1);
  EXPECT_EQ(result.regions.size(), 1u);
}

TEST(Repair, GrossSelfCrossingIsRefusedWithThePlace) {
  EXPECT_THAT(refusal({closed({{0, 0}, {10, 10}, {10, 0}, {0, 10}})}), HasSubstr("crosses itself at (5, 5)"));
}

TEST(Repair, AnIslandThroughAWallIsCutBack) {
  const Repaired result = repaired({square(0, 0, 50), closed({{20, 20}, {30, 20}, {30, 50.3}, {20, 50.3}})});
  EXPECT_NEAR(area(result.regions), 2500 - 300, 1e-3);
  EXPECT_EQ(result.count(Severity::kRepair, "through the wall"), 1);
}

/// mm2 of discs in a row, each less what the next leaves of it: summed over lines along the row.
double one_in_the_other(const std::vector<Vec2>& centers, double radius) {
  constexpr int kLines = 200'000;
  const double apart = 2 * radius / kLines;
  double sum = 0;
  for (int line = 0; line < kLines; ++line) {
    const double y = -radius + (line + 0.5) * apart, half = std::sqrt(radius * radius - y * y);
    double sign = 1;
    for (const Vec2 center : centers) {
      const double within = 2 * half - (center.x - centers.front().x);
      sum += sign * std::max(0.0, within) * apart;
      sign = -sign;
    }
  }
  return sum;
}

TEST(Repair, OutlinesThroughOneAnothersWallsAreCutOut) {
  constexpr double kRadius = 10'000;
  std::vector<Vec2> centers;
  std::vector<RawCurve> discs;
  for (int i = 0; i < 6; ++i) {
    centers.push_back({200.0 * i, 0});
    discs.push_back(circle(centers.back(), kRadius));
  }
  const Repaired result = repaired(discs);
  EXPECT_EQ(result.count(Severity::kRepair, "through the wall"), 15) << "of every later one";
  EXPECT_NEAR(area(result.regions), one_in_the_other(centers, kRadius), 1);
}

TEST(Repair, AnIslandThatTouchesTheWallStaysExact) {
  const Repaired result = repaired({square(0, 0, 50), circle({25, 10}, 10)});
  EXPECT_DOUBLE_EQ(area(result.regions), 2500 - 100 * kPi);
  EXPECT_EQ(result.count(Severity::kRepair), 0);
}

TEST(Repair, AnIslandWithASharedStretchOfWallIsCutOut) {
  const Repaired result = repaired({square(0, 0, 50), square(0, 20, 10)});
  ASSERT_EQ(result.regions.size(), 1u);
  EXPECT_NEAR(area(result.regions), 2400, 1e-6);
  EXPECT_TRUE(result.regions[0].islands().empty());
}

TEST(Repair, PocketsThatShareAWallAreUnited) {
  const Repaired result = repaired({square(0, 0, 10), square(10, 2, 5)});
  ASSERT_EQ(result.regions.size(), 1u);
  EXPECT_NEAR(area(result.regions), 125, 1e-6);
}

TEST(Repair, AnArcThroughAWallIsCutBack) {
  const Repaired result = repaired({square(0, 0, 50), circle({25, 42.2}, 8)});
  const double angle = 2 * std::acos(7.8 / 8);
  EXPECT_NEAR(area(result.regions), 2500 - 64 * kPi + 32 * (angle - std::sin(angle)), 1e-3);
}

TEST(Repair, HalfInHalfOutIsRefused) {
  EXPECT_THAT(refusal({square(0, 0, 10), square(5, 5, 10)}), HasSubstr("cross at"));
}

TEST(Repair, NumbersOutOfRangeAreRefused) {
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {inf, -inf, nan, 2e6, -1e300}) {
    EXPECT_THAT(refusal({closed({{0, 0}, {10, 0}, {bad, 10}})}), HasSubstr("not a number or lies beyond"));
  }
}

TEST(Repair, OutlinesThatEncloseNothingAreDroppedAndNothingLeftIsRefused) {
  const Repaired result = repaired({square(0, 0, 50), closed({{60, 0}, {70, 0}, {80, 0}})});
  EXPECT_EQ(result.regions.size(), 1u);
  EXPECT_EQ(result.count(Severity::kRepair, "encloses nothing"), 1);
  EXPECT_THAT(refusal({closed({{60, 0}, {70, 0}, {80, 0}})}), HasSubstr("no outline encloses an area"));
  EXPECT_THAT(refusal({}), HasSubstr("no closed outline found"));
}

TEST(Repair, ArcsAreFoundAgainInShortLinesOnly) {
  RepairOptions how = options();
  how.find_arcs = true;
  const auto polygon = [](int n, double r) {
    std::vector<Vec2> points;
    for (int i = 0; i < n; ++i) points.push_back(direction_of(2 * kPi * i / n) * r);
    return closed(points);
  };
  EXPECT_EQ(repaired({polygon(360, 20)}, how).regions[0].outer().size(), 2u);
  EXPECT_EQ(repaired({polygon(4, 20)}, how).regions[0].outer().size(), 4u);
  EXPECT_EQ(repaired({polygon(12, 20)}, how).regions[0].outer().size(), 12u);
  EXPECT_EQ(repaired({polygon(360, 20)}).regions[0].outer().size(), 360u);
}

TEST(Repair, ARoundedRectangleOfShortLinesGetsFourArcsAndKeepsItsSides) {
  RepairOptions how = options();
  how.find_arcs = true;
  std::vector<Vec2> points;
  const Vec2 centers[] = {{30, 10}, {30, 30}, {10, 30}, {10, 10}};
  for (int corner = 0; corner < 4; ++corner) {
    for (int i = 0; i <= 40; ++i) {
      points.push_back(centers[corner] + direction_of((corner - 1) * kPi / 2 + kPi / 2 * i / 40) * 10);
    }
  }
  const Repaired result = repaired({closed(points)}, how);
  EXPECT_EQ(result.regions[0].outer().size(), 8u);
  EXPECT_NEAR(area(result.regions), 1600 - 400 + 100 * kPi, 0.1);
  EXPECT_EQ(result.count(Severity::kRepair, "160 short lines became 4 arcs"), 1);
}

}  // namespace
}  // namespace clearcut::read
