// Offsets of an outline of 100 000 vertices with noise, as scanned shapes have, against exact distances.
#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "base/units.h"
#include "geometry/voronoi/clearance.h"
#include "verify/part/edge_tree.h"

namespace clearcut {
namespace {

constexpr double kPromise = 0.001;

/// A wavy star whose vertices stray by up to `noise` mm.
Region scanned_star(int vertices, double noise) {
  Random random(1);
  std::vector<Vec2> points;
  for (int i = 0; i < vertices; ++i) {
    const double t = 2 * kPi * i / vertices;
    const double r = 150 * (1 + 0.25 * std::sin(5 * t) + 0.03 * std::sin(37 * t) + 0.004 * std::sin(301 * t));
    points.push_back(direction_of(t) * (r + random.between(-noise, noise)));
  }
  return Region::from_valid_loops(loop_from_points(points), {});
}

verify::EdgeTree tree_of(const Regions& regions) {
  std::vector<Edge> edges;
  for (const Region& region : regions) {
    for (const Edge& edge : region.edges()) edges.push_back(edge);
  }
  return verify::EdgeTree(std::move(edges));
}

TEST(LargeOutline, OffsetsLieAtTheirDistanceAndMissNothing) {
  const Region region = scanned_star(100000, 0.003);
  const verify::EdgeTree outline = tree_of({region});
  const std::vector<double> levels{0.5, 3, 10, 40, 90};
  const auto insets = Clearance(region, {}).insets(levels);
  Random random(2);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const verify::EdgeTree inset = tree_of(insets[i]);
    ASSERT_FALSE(inset.empty()) << levels[i];
    double worst = 0;
    for (const Edge& edge : inset.edges()) {
      for (const double t : {0.0, 0.5}) {
        const double off = outline.nearest(edge.at(t), levels[i] + 1).distance - levels[i];
        worst = std::max(worst, std::abs(off));
      }
    }
    EXPECT_LE(worst, kPromise) << levels[i];
    for (int k = 0; k < 5000; ++k) {
      const Vec2 p{random.between(-190, 190), random.between(-190, 190)};
      if (outline.winding(p) == 0) continue;
      const double d = outline.nearest(p).distance;
      if (std::abs(d - levels[i]) <= kPromise) continue;
      EXPECT_EQ(inset.winding(p) != 0, d > levels[i]) << p.x << " " << p.y << " at " << d;
    }
  }
}

}  // namespace
}  // namespace clearcut
