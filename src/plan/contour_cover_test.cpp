#include "plan/contour_cover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "base/random.h"

namespace clearcut {
namespace {

constexpr double kSide = 60;  // mm

/// Two sides of a square, then chords of it.
std::vector<Edge> chords(Random& random, int count) {
  std::vector<Edge> edges{Edge::line({0, 0}, {kSide, 0}), Edge::line({kSide, kSide}, {0, kSide})};
  const auto place = [&] { return Vec2{random.between(0, kSide), random.between(0, kSide)}; };
  for (int i = 0; i < count; ++i) edges.push_back(Edge::line(place(), place()));
  return edges;
}

std::vector<Vec2> sorted(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(),
            [](Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  return points;
}

/// Whether a point of the sorted ones is at p.
bool has(const std::vector<Vec2>& points, Vec2 p) {
  constexpr double kSame = 1e-6;
  auto at =
      std::lower_bound(points.begin(), points.end(), p.x - kSame, [](Vec2 a, double x) { return a.x < x; });
  for (; at != points.end() && at->x <= p.x + kSame; ++at) {
    if (distance(*at, p) <= kSame) return true;
  }
  return false;
}

TEST(Cover, CrowdedSquaresHideNoHole) {
  // Laid over a cover of its first two edges the rest is searched without quartering any square.
  for (int seed = 1; seed <= 6; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const double radius = random.between(0.05, 0.6);
    const auto edges = chords(random, 1200);
    const auto everywhere = [](Vec2) { return true; };
    auto few = std::make_shared<Cover>(std::span(edges).first(2), radius);
    few->keep_rim(everywhere);
    const auto found = sorted(Cover(edges, radius).holes(everywhere));
    const auto expected = Cover(std::span(edges).subspan(2), few).holes(everywhere);
    EXPECT_FALSE(expected.empty()) << seed;
    const auto missed =
        std::count_if(expected.begin(), expected.end(), [&](Vec2 p) { return !has(found, p); });
    EXPECT_EQ(missed, 0) << seed;
  }
}

}  // namespace
}  // namespace clearcut
