#include "read/common/curve_fit.h"

#include <gtest/gtest.h>

#include "base/random.h"
#include "base/units.h"
#include "geometry/region.h"

namespace clearcut::read {
namespace {

constexpr double kTol = 0.002;

/// Both ways: points of the curve to the path, and points of the path to a dense polygon of the curve.
void expect_near(const ParametricCurve& curve, const Path& path, double tol) {
  std::vector<Vec2> dense;
  for (int i = 0; i <= 2000; ++i) dense.push_back(curve(i / 2000.0));
  for (const Vec2 p : dense) {
    double best = 1e300;
    for (const Edge& edge : path) best = std::min(best, distance(edge, p));
    ASSERT_LE(best, tol);
  }
  for (const Edge& edge : path) {
    for (const double t : {0.1, 0.35, 0.5, 0.8}) {
      double best = 1e300;
      for (std::size_t i = 0; i + 1 < dense.size(); ++i) {
        if (dense[i] != dense[i + 1])
          best = std::min(best, distance(Edge::line(dense[i], dense[i + 1]), edge.at(t)));
      }
      ASSERT_LE(best, tol * 1.2);
    }
  }
}

void expect_joined(const Path& path) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i) EXPECT_EQ(path[i].to, path[i + 1].from);
}

TEST(CurveFit, RandomCubicsAreFollowedBothWays) {
  Random random(7);
  for (int round = 0; round < 60; ++round) {
    Vec2 p[4];
    for (Vec2& q : p) q = {random.between(0, 50), random.between(0, 50)};
    const ParametricCurve cubic = [&](double t) {
      const double s = 1 - t;
      return p[0] * (s * s * s) + p[1] * (3 * s * s * t) + p[2] * (3 * s * t * t) + p[3] * (t * t * t);
    };
    Path path;
    append_fitted(cubic, kTol, path);
    expect_joined(path);
    EXPECT_EQ(path.front().from, p[0]);
    EXPECT_EQ(path.back().to, p[3]);
    EXPECT_LT(path.size(), 150u);
    expect_near(cubic, path, kTol);
  }
}

TEST(CurveFit, FullEllipseClosesAndHasItsArea) {
  Path path;
  append_elliptical({{5, 6}, {30, 0}, {0, 10}, 0, 2 * kPi}, kTol, path);
  expect_joined(path);
  EXPECT_EQ(path.back().to, path.front().from);
  EXPECT_NEAR(signed_area(path), kPi * 300, 0.002 * 140);
  EXPECT_LT(path.size(), 100u);
}

TEST(CurveFit, CircleStaysExact) {
  Path path;
  append_elliptical({{1, 2}, {0, 3}, {-3, 0}, 0.3, -1.2}, kTol, path);
  ASSERT_EQ(path.size(), 1u);
  EXPECT_TRUE(path[0].is_arc());
  EXPECT_NEAR(path[0].sweep(), -1.2, 1e-12);
  EXPECT_NEAR(path[0].radius(), 3, 1e-12);
}

TEST(CurveFit, MirrorTurnsArcsRoundAndStretchMakesEllipses) {
  const Edge quarter = Edge::arc({10, 0}, {0, 10}, {0, 0}, Turn::kCounterClockwise);
  Path mirrored;
  append_mapped(quarter, Affine::scaling(-2, 2), kTol, mirrored);
  ASSERT_EQ(mirrored.size(), 1u);
  EXPECT_NEAR(mirrored[0].sweep(), -kPi / 2, 1e-12);
  Path stretched;
  append_mapped(quarter, Affine::scaling(2, 1), kTol, stretched);
  for (const Edge& edge : stretched) {
    const Vec2 p = edge.at(0.5);
    EXPECT_NEAR(p.x * p.x / 400 + p.y * p.y / 100, 1, 0.001);
  }
  EXPECT_EQ(stretched.front().from, (Vec2{20, 0}));
}

TEST(CurveFit, StraightCurveIsOneLine) {
  Path path;
  append_fitted([](double t) { return Vec2{t * t * 10, t * t * 20}; }, kTol, path);
  ASSERT_EQ(path.size(), 1u);
  EXPECT_FALSE(path[0].is_arc());
}

TEST(CurveFit, CuspsAndPointsEnd) {
  Path cusp;
  append_fitted(
      [](double t) {
        return Vec2{(t - 0.5) * (t - 0.5) * 8, (t - 0.5) * (t - 0.5) * (t - 0.5) * 80};
      },
      kTol, cusp);
  EXPECT_LT(cusp.size(), 200u);
  Path point;
  append_fitted([](double) { return Vec2{1, 1}; }, kTol, point);
  EXPECT_TRUE(point.empty());
}

}  // namespace
}  // namespace clearcut::read
