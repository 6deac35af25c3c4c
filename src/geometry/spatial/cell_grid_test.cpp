#include "geometry/spatial/cell_grid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/random.h"

namespace clearcut::inline geometry {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(BoxIndex, FindsAllThatIsNearAndEachOnce) {
  Random random(5);
  std::vector<Vec2> points;
  BoxIndex index(0.7);
  for (std::uint32_t i = 0; i < 2000; ++i) {
    points.push_back({random.between(-30, 30), random.between(-30, 30)});
    index.add(points.back(), i);
  }
  for (int k = 0; k < 500; ++k) {
    const Vec2 p{random.between(-31, 31), random.between(-31, 31)};
    const auto found = index.near(p);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      const bool listed = std::binary_search(found.begin(), found.end(), i);
      EXPECT_TRUE(listed || distance(points[i], p) > 0.7) << k;
    }
  }
}

TEST(BoxIndex, KeepsPlacesApartThatAreFarFromEachOtherInCells) {
  BoxIndex index(1e-6);
  index.add(Vec2{1e6, 0}, 1);
  index.add(Vec2{-1e6, 0}, 2);
  index.add(Vec2{1e6, 4294.967296}, 3);  // 2^32 cells farther
  EXPECT_THAT(index.near(Vec2{1e6, 0}), ElementsAre(1U));
  EXPECT_THAT(index.near(Vec2{0, 0}), IsEmpty());
}

TEST(BoxIndex, ACellKeepsTheOrderInWhichNumbersCame) {
  BoxIndex index(1);
  index.add(Box{{0.2, 0.2}, {2.5, 0.4}}, 9);
  index.add(Box{{0.1, 0.1}, {0.2, 0.2}}, 4);
  EXPECT_THAT(index.at({0.9, 0.9}), ElementsAre(9U, 4U));
  EXPECT_THAT(index.at({2.9, 0}), ElementsAre(9U));
  EXPECT_THAT(index.at({3.1, 0}), IsEmpty());
  EXPECT_THAT(index.fullest(), ElementsAre(9U, 4U));
}

}  // namespace
}  // namespace clearcut::inline geometry
