#include "verify/part/edge_tree.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "base/units.h"

namespace clearcut::verify {
namespace {

/// Loops whose corners jump up and down: rays cross many edges, also at corners' own heights.
Loop comb(Random& random, Vec2 at, int teeth) {
  std::vector<BulgeVertex> vertices{{at}, {at + Vec2{static_cast<double>(teeth), 0}}};
  for (int i = teeth; i-- > 0;) {
    const double x = at.x + i, bulge = random.below(2) == 0 ? 0 : 0.2 * random.between(0, 1);
    vertices.push_back({{x + 0.9, at.y + 10}, bulge});
    vertices.push_back({{x + 0.4, at.y + 10}});
    vertices.push_back({{x + 0.4, at.y + std::floor(8 * random.between(0, 1)) + 1}, bulge});
    vertices.push_back({{x, at.y + 1}});
  }
  return loop_from_bulges(vertices);
}

TEST(EdgeTree, CountsTurnsAsTheEdgesOneByOneDo) {
  Random random(7);
  for (int round = 0; round < 40; ++round) {
    std::vector<Edge> edges;
    for (int loop = 0; loop < 3; ++loop) {
      for (const Edge& edge : comb(random, {7.0 * loop, 3.0 * loop}, 5 + round)) edges.push_back(edge);
    }
    // Small loops, of which several share a box; some are told in pieces.
    for (int loop = 0; loop < round; ++loop) {
      for (const Edge& edge : comb(random, {60 * random.between(0, 1), 8 * random.between(0, 1)}, 1))
        edges.push_back(edge);
    }
    for (std::size_t i = 0; round % 4 == 0 && i + 20 < edges.size(); i += 20)
      std::swap(edges[i], edges[i + 9]);
    const EdgeTree tree(edges);
    for (int i = 0; i < 500; ++i) {
      const bool on_heights = i % 2 == 0;
      const double y = on_heights ? std::floor(18 * random.between(0, 1)) : 18 * random.between(0, 1) - 1;
      const Vec2 p{60 * random.between(0, 1) - 3, y};
      int sum = 0;
      for (const Edge& edge : edges) sum += clearcut::winding(edge, p);
      EXPECT_EQ(tree.winding(p), sum) << round << " at " << p.x << ", " << p.y;
    }
  }
}

TEST(EdgeTree, TheDistanceIsThatOfTheNearest) {
  Random random(11);
  std::vector<Edge> edges;
  for (int i = 0; i < 400; ++i) {
    const Vec2 p{30 * random.between(0, 1), 30 * random.between(0, 1)};
    edges.push_back(Edge::line(p, p + Vec2{random.between(0, 3), 1}));
  }
  const EdgeTree tree(edges);
  for (int i = 0; i < 500; ++i) {
    const Vec2 p{random.between(-5, 40), random.between(-5, 40)};
    double least = 1e9;
    for (const Edge& edge : edges) least = std::min(least, distance(edge, p));
    EXPECT_EQ(tree.distance_to(p), least) << i;
  }
  EXPECT_EQ(EdgeTree().distance_to({}), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace clearcut::verify
