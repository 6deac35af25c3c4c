#include "read/dxf/dxf_spline.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "base/units.h"

namespace clearcut::read {
namespace {

/// Derivatives by u, the parameter of the chords, at the beginning of a span (t = 0) or its end (t = 1).
Vec2 first(const FitSpan& span, double t) {
  const double h = 1e-4, at = t == 0 ? h : 1 - h;
  return (span.at(at + h) - span.at(at - h)) / (2 * h * span.length);
}

Vec2 second(const FitSpan& span, double t) {
  const Vec2 chord = (span.to - span.from) / span.length;
  const Vec2 bend = t == 0 ? chord * 3.0 - span.from_slope * 2.0 - span.to_slope
                           : span.from_slope + span.to_slope * 2.0 - chord * 3.0;
  return bend * (2 / span.length);
}

std::vector<Vec2> random_points(std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec2> points;
  for (std::uint64_t i = 0; i < 3 + random.below(20); ++i)
    points.push_back({random.between(-50, 50), random.between(-50, 50)});
  return points;
}

void expect_smooth_joint(const FitSpan& a, const FitSpan& b) {
  EXPECT_EQ(a.to, b.from);
  EXPECT_LT(norm(a.to_slope - b.from_slope), 1e-12);
  EXPECT_LT(norm(second(a, 1) - second(b, 0)), 1e-9 * (1 + norm(second(a, 1))));
}

// Correct means: through every point, slope and curvature the same on both sides of each; at the ends what was asked.
TEST(FitPoints, PassThroughEveryPointWithoutKinkOrJumpOfCurvature) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    const auto points = random_points(seed);
    const FitEnds ends{seed % 2 ? std::optional<Vec2>({3, 4}) : std::nullopt, std::nullopt, seed % 5 == 0};
    const auto spans = cubic_through(points, ends);
    ASSERT_EQ(spans.size(), points.size() - (ends.closed ? 0 : 1));
    for (std::size_t i = 0; i < spans.size(); ++i) {
      EXPECT_EQ(spans[i].from, points[i]);
      EXPECT_LT(norm(spans[i].at(1) - spans[i].to), 1e-12);
      EXPECT_LT(norm(first(spans[i], 0) - spans[i].from_slope), 1e-2 * (1 + norm(spans[i].from_slope)));
      if (i > 0) expect_smooth_joint(spans[i - 1], spans[i]);
    }
    if (ends.closed) {
      expect_smooth_joint(spans.back(), spans.front());
    } else {
      EXPECT_LT(norm(second(spans.back(), 1)), 1e-9);
      if (ends.start) {
        EXPECT_LT(norm(spans.front().from_slope - Vec2{0.6, 0.8}), 1e-12);
      }
    }
  }
}

TEST(FitPoints, CirclesComeBackAsTheFourthPowerOfTheStep) {
  double before = 0;
  for (const int count : {8, 16, 32, 64}) {
    std::vector<Vec2> points;
    for (int i = 0; i < count; ++i) points.push_back(direction_of(2 * kPi * i / count) * 10);
    double worst = 0;
    for (const FitSpan& span : cubic_through(points, {std::nullopt, std::nullopt, true}))
      worst = std::max(worst, std::abs(norm(span.at(0.5)) - 10));
    if (before > 0) {
      EXPECT_NEAR(before / worst, 16, 2);
    }
    before = worst;
  }
  EXPECT_LT(before, 1e-5);
}

/// The first point again, rounded another way, is no point more: between the two the curve could turn anywhere.
TEST(FitPoints, PointsRepeatedButForRoundingCountOnce) {
  std::vector<Vec2> points;
  for (int i = 0; i < 8; ++i) points.push_back(direction_of(0.3 + 2 * kPi * i / 8) * 10);
  for (const Vec2 rounding : {Vec2{1e-12, 1e-13}, Vec2{-3e-8, 1e-8}, Vec2{0, 0}}) {
    std::vector<Vec2> again = points;
    again.push_back(points.front() + rounding);
    const auto spans = cubic_through(again, {std::nullopt, std::nullopt, true});
    ASSERT_EQ(spans.size(), 8u);
    for (const FitSpan& span : spans) EXPECT_NEAR(norm(span.at(0.5)), 10, 0.02);
  }
}

TEST(FitPoints, FewOrRepeatedPointsAreNoTrouble) {
  EXPECT_TRUE(cubic_through(std::vector<Vec2>{}, {}).empty());
  EXPECT_TRUE(cubic_through(std::vector<Vec2>{{1, 1}, {1, 1}}, {}).empty());
  const auto line = cubic_through(std::vector<Vec2>{{0, 0}, {0, 0}, {8, 6}}, {});
  ASSERT_EQ(line.size(), 1u);
  EXPECT_LT(norm(line[0].at(0.25) - Vec2{2, 1.5}), 1e-12);
}

}  // namespace
}  // namespace clearcut::read
