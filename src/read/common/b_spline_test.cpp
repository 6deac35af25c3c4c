#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "base/units.h"
#include "read/common/curve_fit.h"

namespace clearcut::read {
namespace {

/// Basis function i of the degree at u, by its definition (Cox and de Boor).
double basis(const std::vector<double>& knots, int i, int degree, double u) {
  const auto k = [&](int n) { return knots[static_cast<std::size_t>(n)]; };
  if (degree == 0) return k(i) <= u && u < k(i + 1) ? 1 : 0;
  double sum = 0;
  if (k(i + degree) > k(i)) sum += (u - k(i)) / (k(i + degree) - k(i)) * basis(knots, i, degree - 1, u);
  if (k(i + degree + 1) > k(i + 1))
    sum += (k(i + degree + 1) - u) / (k(i + degree + 1) - k(i + 1)) * basis(knots, i + 1, degree - 1, u);
  return sum;
}

/// Poles carry their weights: the sum of the basis functions times them, divided by that of the weights.
Vec2 exact(const BSpline& spline, double u) {
  Vec2 p;
  double w = 0;
  for (int i = 0; i < static_cast<int>(spline.poles.size()); ++i) {
    const double n = basis(spline.knots, i, spline.degree, u);
    const auto& pole = spline.poles[static_cast<std::size_t>(i)];
    p = p + pole.p * n;
    w += pole.w * n;
  }
  return p / w;
}

double distance_to(const Path& path, Vec2 p) {
  double least = 1e300;
  for (const Edge& edge : path) least = std::min(least, distance(edge, p));
  return least;
}

BSpline::Pole pole(Vec2 p, double w) {
  return {p * w, w};
}

/// A star-like closed curve: the first poles come again at the end, knots are evenly spaced.
BSpline periodic(Random& random, bool rational) {
  BSpline spline;
  spline.degree = 2 + static_cast<int>(random.below(3));
  const int own = spline.degree + 3 + static_cast<int>(random.below(8));
  for (int i = 0; i < own; ++i) {
    const double w = rational ? random.between(0.3, 3) : 1;
    spline.poles.push_back(pole(direction_of(2 * kPi * i / own) * random.between(10, 30), w));
  }
  for (int i = 0; i < spline.degree; ++i) spline.poles.push_back(spline.poles[static_cast<std::size_t>(i)]);
  for (int i = 0; i < own + 2 * spline.degree + 1; ++i) spline.knots.push_back(i);
  return spline;
}

/// With ends that are poles, uneven and multiple knots.
BSpline clamped(Random& random, bool rational) {
  BSpline spline;
  spline.degree = 1 + static_cast<int>(random.below(5));
  const int count = spline.degree + 1 + static_cast<int>(random.below(8));
  for (int i = 0; i < count; ++i) {
    const double w = rational ? random.between(0.3, 3) : 1;
    spline.poles.push_back(pole({10.0 * i, random.between(-20, 20)}, w));
  }
  spline.knots.assign(static_cast<std::size_t>(spline.degree) + 1, 0);
  double u = 0;
  int same = spline.degree;  // knots more often the same than the degree would tear the curve
  for (int i = spline.degree + 1; i < count; ++i) {
    const bool again = same < spline.degree && random.below(4) == 0;
    same = again ? same + 1 : 1;
    spline.knots.push_back(u += again ? 0 : 0.5);
  }
  spline.knots.insert(spline.knots.end(), static_cast<std::size_t>(spline.degree) + 1, u + 1);
  return spline;
}

void expect_near_everywhere(const BSpline& spline) {
  ASSERT_EQ(fault_of(spline), "");
  Path path;
  append_spline(spline, kCurveTolerance, path);
  const double low = spline.knots[static_cast<std::size_t>(spline.degree)];
  const double high = spline.knots[spline.poles.size()];
  constexpr int kSamples = 400;
  for (int i = 0; i < kSamples; ++i) {
    const Vec2 p = exact(spline, low + (high - low) * i / kSamples);
    EXPECT_LT(distance_to(path, p), 1.2 * kCurveTolerance) << "sample " << i;
  }
  EXPECT_LT(distance(path.front().from, exact(spline, low)), 1e-9);
  for (std::size_t i = 1; i < path.size(); ++i) EXPECT_EQ(path[i - 1].to, path[i].from);
}

TEST(BSpline, IsNearItsDefinitionEverywhere) {
  Random random(3);
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    expect_near_everywhere(clamped(random, i % 2 == 1));
    const BSpline closed = periodic(random, i % 2 == 1);
    expect_near_everywhere(closed);
    Path path;
    append_spline(closed, kCurveTolerance, path);
    EXPECT_LT(distance(path.front().from, path.back().to), 1e-9);
  }
}

TEST(BSpline, TornWhereKnotsCoincideMoreOftenThanItsDegreeIsAFault) {
  BSpline spline;
  spline.degree = 2;
  spline.knots = {0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1};
  const auto with_gap = [&](double gap) {
    spline.poles = {pole({0, 0}, 1),        pole({5, 5}, 2),   pole({10, 0}, 1),
                    pole({10 + gap, 0}, 3), pole({15, -5}, 1), pole({20, 0}, 1)};
    return fault_of(spline);
  };
  EXPECT_EQ(with_gap(3), "a tear of 3 mm at knot 0.5");
  EXPECT_EQ(with_gap(0), "");
}

}  // namespace
}  // namespace clearcut::read
