#include "link/work.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/random.h"

namespace clearcut::link {
namespace {

Region box_region(Vec2 low, double side) {
  const std::vector<Vec2> corners{low, low + Vec2{side, 0}, low + Vec2{side, side}, low + Vec2{0, side}};
  return Region::from_valid_loops(loop_from_points(corners), {});
}

/// As found by asking all edges.
std::vector<double> least_distances(const LayerWork& work, Vec2 p, std::size_t most) {
  std::vector<double> all;
  for (const Region& region : work.touching())
    for (const Edge& edge : region.edges()) all.push_back(distance(edge, p));
  std::sort(all.begin(), all.end());
  all.resize(std::min(all.size(), most));
  return all;
}

TEST(LayerWork, NearestPlacesOfTheRimAreThoseOfAllEdges) {
  LayerPasses layer;
  for (int i = 0; i < 40; ++i) layer.target.push_back(box_region({i % 8 * 10.0, i / 8 * 10.0}, 5));
  layer.legal = {box_region({-10, -10}, 100)};
  const LayerWork work(layer, 1);
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    const Vec2 p{random.between(-20, 100), random.between(-20, 70)};
    const std::size_t most = i % 3 == 0 ? 1 : i % 3 == 1 ? 32 : 1000;
    const auto places = work.nearest_on_rim(p, most);
    const auto expected = least_distances(work, p, most);
    ASSERT_EQ(places.size(), expected.size());
    for (std::size_t k = 0; k < places.size(); ++k) EXPECT_NEAR(distance(places[k], p), expected[k], 1e-12);
  }
}

}  // namespace
}  // namespace clearcut::link
