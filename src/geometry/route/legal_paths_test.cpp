// Shortest legal paths: legal, symmetric, no longer than any other way through the same corners.
#include "geometry/route/legal_paths.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "base/units.h"
#include "geometry/contours/boolean.h"

namespace clearcut::inline geometry {
namespace {

Region rectangle(double x0, double y0, double x1, double y1) {
  const std::vector<Vec2> corners{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  return Region::from_valid_loops(loop_from_points(corners), {});
}

Region disc(Vec2 center, double radius) {
  const Vec2 a = center + Vec2{radius, 0}, b = center - Vec2{radius, 0};
  return Region::from_valid_loops(
      {Edge::arc(a, b, center, Turn::kCounterClockwise), Edge::arc(b, a, center, Turn::kCounterClockwise)},
      {});
}

double length_of(Vec2 a, const std::vector<Vec2>& bends, Vec2 b) {
  double length = 0;
  for (const Vec2 p : bends) length += distance(a, p), a = p;
  return length + distance(a, b);
}

/// A square of 100 mm less some random bars and discs.
Regions random_area(Random& random) {
  Regions area{rectangle(0, 0, 100, 100)};
  for (int i = 0; i < 6; ++i) {
    const Vec2 p{random.between(5, 80), random.between(5, 80)};
    const Region island = i % 2 == 0
                              ? disc(p, random.between(3, 15))
                              : rectangle(p.x, p.y, p.x + random.between(2, 40), p.y + random.between(2, 40));
    area = subtract(area, {island}, {});
  }
  return area;
}

TEST(LegalPaths, StraightWhereNothingIsInTheWay) {
  const LegalPaths paths({rectangle(0, 0, 10, 10)});
  EXPECT_TRUE(paths.all_straight());
  EXPECT_EQ(paths.bends({1, 1}, {9, 8}), std::vector<Vec2>{});
}

TEST(LegalPaths, RoundTheCornerOfABar) {
  const LegalPaths paths(subtract({rectangle(0, 0, 20, 10)}, {rectangle(9, -1, 11, 6)}, {}));
  const auto bends = paths.bends({2, 5}, {18, 5});
  ASSERT_TRUE(bends);
  EXPECT_NEAR(length_of({2, 5}, *bends, {18, 5}), 2 + 2 * std::hypot(7, 1), 1e-3);
}

TEST(LegalPaths, RoundADiscWithinHalfAPercentOfTheArc) {
  const LegalPaths paths(subtract({rectangle(-50, -50, 50, 50)}, {disc({0, 0}, 10)}, {}));
  const auto bends = paths.bends({-30, 0}, {30, 0});
  ASSERT_TRUE(bends);
  const double tangent = std::sqrt(30.0 * 30 - 100), turned = kPi - 2 * std::acos(10.0 / 30);
  const double shortest = 2 * tangent + 10 * turned;
  EXPECT_GE(length_of({-30, 0}, *bends, {30, 0}), shortest - 1e-3);
  EXPECT_LE(length_of({-30, 0}, *bends, {30, 0}), 1.005 * shortest);
}

TEST(LegalPaths, NoneBetweenSeparateAreas) {
  const LegalPaths paths({rectangle(0, 0, 10, 10), rectangle(20, 0, 30, 10)});
  EXPECT_FALSE(paths.bends({5, 5}, {25, 5}));
}

TEST(LegalPaths, EveryMoveOfEveryWayIsLegalAndTheTriangleInequalityHolds) {
  // What is not seen here: whether a shorter way exists that touches no corner of the graph; that none does is
  // the theorem the graph stands on.
  Random random(7);
  int bent = 0;
  for (int i = 0; i < 60; ++i) {
    const Regions area = random_area(random);
    const LegalPaths paths({area.front()});
    std::vector<Vec2> points;
    while (points.size() < 8) {
      const Vec2 p{random.between(0, 100), random.between(0, 100)};
      if (area.front().contains(p)) points.push_back(p);
    }
    std::vector<std::vector<double>> length(8, std::vector<double>(8, 0));
    for (std::size_t a = 0; a < 8; ++a) {
      for (std::size_t b = 0; b < 8; ++b) {
        const auto bends = paths.bends(points[a], points[b]);
        ASSERT_TRUE(bends);
        bent += bends->empty() ? 0 : 1;
        Vec2 at = points[a];
        for (const Vec2 p : *bends) {
          EXPECT_TRUE(paths.area().holds_line(at, p));
          at = p;
        }
        EXPECT_TRUE(paths.area().holds_line(at, points[b]));
        length[a][b] = length_of(points[a], *bends, points[b]);
        auto back = paths.bends(points[b], points[a]);
        std::reverse(back->begin(), back->end());
        EXPECT_EQ(*back, *bends);
      }
    }
    for (std::size_t a = 0; a < 8; ++a)
      for (std::size_t b = 0; b < 8; ++b)
        for (std::size_t c = 0; c < 8; ++c)
          EXPECT_LE(length[a][b], 1.005 * (length[a][c] + length[c][b]) + 1e-6);
  }
  EXPECT_GT(bent, 500);
}

}  // namespace
}  // namespace clearcut::inline geometry
