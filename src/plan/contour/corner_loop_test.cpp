#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "base/units.h"
#include "plan/contour/published_rings.h"

namespace clearcut::plan::contour {
namespace {

constexpr CornerLoop kAll[] = {CornerLoop::kCircle, CornerLoop::kPwid, CornerLoop::kSingle,
                               CornerLoop::kDouble};

struct Corner {
  Vec2 root, tip, in, out;
};

/// A corner of angle alpha, its outward bisector turned by `turned`, that has to be cleared up to `far` mm. The contour
/// comes along one side and leaves along the other, the material on its left.
Corner built(double alpha, double turned, double far) {
  const auto direction = [](double angle) { return Vec2{std::cos(angle), std::sin(angle)}; };
  const Vec2 root{3, -2};
  return {root, root + direction(turned) * far, direction(turned + alpha / 2),
          -direction(turned - alpha / 2)};
}

double distance_to(const Path& path, Vec2 p) {
  double nearest = 1e9;
  for (const auto& edge : path) nearest = std::min(nearest, distance(edge, p));
  return nearest;
}

TEST(CornerLoop, JoinsUpFromTheRootToTheRootThroughTheTip) {
  for (const CornerLoop kind : kAll) {
    const Corner c = built(1.0, 0.7, 2.5);
    const auto loop = corner_loop(kind, c.root, c.tip, c.in, c.out, 5);
    ASSERT_TRUE(loop);
    EXPECT_LT(distance(loop->front().from, c.root), 1e-12);
    EXPECT_LT(distance(loop->back().to, c.root), 1e-12);
    for (std::size_t i = 1; i < loop->size(); ++i)
      EXPECT_LT(distance((*loop)[i - 1].to, (*loop)[i].from), 1e-12);
    EXPECT_LT(distance_to(*loop, c.tip), 1e-9);
  }
}

/// Choy and Chan: no change of direction anywhere, so that the machine need not stop.
TEST(CornerLoop, TangentLoopsHaveNoCorner) {
  for (const double alpha : {0.2, 0.8, 1.5, 2.4}) {
    const Corner c = built(alpha, 2.1, 3);
    const auto loop = corner_loop(CornerLoop::kSingle, c.root, c.tip, c.in, c.out, 5);
    ASSERT_TRUE(loop);
    EXPECT_NEAR(dot(loop->front().tangent_at(0), c.in), 1, 1e-9);
    EXPECT_NEAR(dot(loop->back().tangent_at(1), c.out), 1, 1e-9);
    for (std::size_t i = 1; i < loop->size(); ++i) {
      EXPECT_NEAR(dot((*loop)[i - 1].tangent_at(1), (*loop)[i].tangent_at(0)), 1, 1e-9);
    }
    const double radius = 3 * std::sin(alpha / 2) / (1 + std::sin(alpha / 2));
    EXPECT_NEAR(length(*loop), 2 * radius / std::tan(alpha / 2) + radius * (kPi + alpha), 1e-9);
  }
}

/// A circle wider than the cutter would leave its middle.
TEST(CornerLoop, CirclesAreNoWiderThanTheCutter) {
  for (const auto& [far, is_there] : {std::pair(9.99, true), std::pair(10.01, false)}) {
    const Corner c = built(0.3, 0.7, far);
    EXPECT_EQ(corner_loop(CornerLoop::kCircle, c.root, c.tip, c.in, c.out, 5).has_value(), is_there) << far;
  }
}

/// Choy and Chan: the first of two loops reaches half as far.
TEST(CornerLoop, OfTwoLoopsTheFirstReachesHalfAsFar) {
  const Corner c = built(1.0, 0.7, 3);
  const auto both = corner_loop(CornerLoop::kDouble, c.root, c.tip, c.in, c.out, 5);
  const auto one = corner_loop(CornerLoop::kSingle, c.root, c.tip, c.in, c.out, 5);
  ASSERT_TRUE(both && one);
  EXPECT_NEAR(length(*both), 1.5 * length(*one), 1e-9);
}

/// Whatever the way to the tip clears, a loop about it clears, too, as long as it is no wider than the cutter.
TEST(CornerLoop, ClearsWhatTheWayToTheTipClears) {
  int checked = 0;
  for (int seed = 0; seed < 200; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const double radius = 5, far = random.between(0.1, radius);
    const Corner c = built(random.between(0.1, 2.6), random.between(0, 6), far);
    const Edge path = Edge::line(c.root, c.tip);
    for (const CornerLoop kind : kAll) {
      const auto loop = corner_loop(kind, c.root, c.tip, c.in, c.out, 5);
      ASSERT_TRUE(loop);
      for (int i = 0; i < 50; ++i) {
        const Vec2 p =
            c.root + Vec2{random.between(-2 * radius, 2 * radius), random.between(-2 * radius, 2 * radius)};
        if (distance(path, p) > radius) continue;
        ++checked;
        EXPECT_LE(distance_to(*loop, p), radius + 1e-9) << seed;
      }
    }
  }
  EXPECT_GT(checked, 5000);
}

TEST(CornerLoop, IsNoWiderThanTheCutter) {
  const Corner c = built(0.2, 0, 12);
  EXPECT_FALSE(corner_loop(CornerLoop::kCircle, c.root, c.tip, c.in, c.out, 5)) << "its middle would be left";
  EXPECT_TRUE(corner_loop(CornerLoop::kSingle, c.root, c.tip, c.in, c.out, 5));
}

TEST(CornerLoop, NeedsACorner) {
  const Corner c = built(1.0, 0, 2);
  EXPECT_FALSE(corner_loop(CornerLoop::kSingle, c.root, c.tip, c.in, c.in, 5)) << "a straight contour";
  EXPECT_FALSE(corner_loop(CornerLoop::kPwid, c.root, c.tip, c.out, c.in, 5)) << "a reflex corner";
  EXPECT_FALSE(corner_loop(CornerLoop::kCircle, c.root, c.root, c.in, c.out, 5)) << "nothing to clear";
}

}  // namespace
}  // namespace clearcut::plan::contour
