// Filled shapes of one colour that overlap, beside formulas and sampled points.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "base/random.h"
#include "base/units.h"
#include "read/repair/clean.h"
#include "read/repair/repair.h"

namespace clearcut::read {
namespace {

using ::testing::HasSubstr;

/// Outlines of one shape that is filled by the even-odd rule.
std::vector<RawCurve> filled(int number, const std::string& paint, const std::vector<Loop>& loops) {
  std::vector<RawCurve> curves;
  for (const Loop& loop : loops)
    curves.push_back({loop, true, "shape " + std::to_string(number), Compound{number, false, paint}});
  return curves;
}

Loop rectangle(Vec2 low, Vec2 high) {
  const Vec2 corners[] = {low, {high.x, low.y}, high, {low.x, high.y}};
  return loop_from_points(corners);
}

Regions repaired(std::vector<std::vector<RawCurve>> shapes) {
  std::vector<RawCurve> curves;
  for (auto& shape : shapes) curves.insert(curves.end(), shape.begin(), shape.end());
  RepairOptions options;
  options.where = "test";
  Diagnostics diagnostics;
  return repair(std::move(curves), options, diagnostics);
}

TEST(Fills, DiscsOfOneColourAreOneArea) {
  constexpr double kRadius = 10, kApart = 8;
  const auto left = filled(0, "#ff0000", {full_circle({0, 0}, kRadius)});
  const Loop other = full_circle({kApart, 0}, kRadius);
  const Regions united = repaired({left, filled(1, "#ff0000", {other})});
  ASSERT_EQ(united.size(), 1U);
  const double lens = 2 * kRadius * kRadius * std::acos(kApart / (2 * kRadius)) -
                      kApart / 2 * std::sqrt(4 * kRadius * kRadius - kApart * kApart);
  EXPECT_NEAR(area(united), 2 * kPi * kRadius * kRadius - lens, 1e-4);
  EXPECT_THROW(repaired({left, filled(1, "#0000ff", {other})}), InputError) << "what lies on top hides";
}

TEST(Fills, ABarAcrossARingFillsPartOfItsHole) {
  const auto ring = filled(0, "", {rectangle({0, 0}, {30, 30}), rectangle({10, 10}, {20, 20})});
  const Regions united = repaired({ring, filled(1, "", {rectangle({15, 12}, {45, 18})})});
  ASSERT_EQ(united.size(), 1U);
  EXPECT_EQ(united[0].islands().size(), 1U);
  EXPECT_NEAR(area(united), 900 - 100 + 15 * 6 + 5 * 6, 1e-6);
}

/// Rows of squares, each half over the one before: their union, and what lies well within it or well outside.
TEST(Fills, RandomRowsCoverWhatAnyOfThemCovers) {
  Random random(11);
  for (int round = 0; round < 100; ++round) {
    std::vector<std::vector<RawCurve>> shapes;
    std::vector<Vec2> corners{{0, 0}};
    constexpr double kSide = 10;
    for (int i = 0; i < 6; ++i) {
      shapes.push_back(filled(i, "black", {rectangle(corners.back(), corners.back() + Vec2{kSide, kSide})}));
      corners.push_back(corners.back() + Vec2{random.between(3, 7), random.between(-3, 3)});
    }
    corners.pop_back();
    const Regions united = repaired(shapes);
    for (int k = 0; k < 100; ++k) {
      const Vec2 p{random.between(-2, 50), random.between(-20, 30)};
      bool covered = false;
      for (const Vec2 low : corners)
        covered = covered || (p.x > low.x && p.y > low.y && p.x < low.x + kSide && p.y < low.y + kSide);
      EXPECT_EQ(contains(united, p), covered) << "round " << round << " at " << p.x << ", " << p.y;
    }
  }
}

}  // namespace
}  // namespace clearcut::read
