#include "report/picture/plan_marks.h"

#include <gtest/gtest.h>

#include "base/random.h"

namespace clearcut::report {
namespace {

TEST(Badges, NeverCoverEachOther) {
  Random random(4);
  const Box page{{0, 0}, {900, 460}};
  for (int round = 0; round < 100; ++round) {
    std::vector<Badge> badges;
    const auto count = 1 + random.below(60);
    for (std::size_t i = 0; i < count; ++i)
      badges.push_back({{200 + 150 * random.unit(), 100 + 80 * random.unit()}, std::to_string(i * i)});
    const auto placed = placed_apart(badges, page);
    EXPECT_EQ(placed.size(), badges.size());
    for (std::size_t i = 0; i < placed.size(); ++i) {
      const Box own = covered_by(placed[i].badge.text, placed[i].middle);
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_FALSE(own.overlaps(covered_by(placed[j].badge.text, placed[j].middle)));
    }
  }
}

TEST(Badges, StayAtTheirPlacesWhereThereIsRoom) {
  const auto placed = placed_apart({{{50, 50}, "1"}, {{150, 50}, "2"}}, {{0, 0}, {200, 100}});
  ASSERT_EQ(placed.size(), 2U);
  EXPECT_EQ(placed[0].middle, (Vec2{50, 50}));
  EXPECT_EQ(placed[1].middle, (Vec2{150, 50}));
}

TEST(Badges, JoinRowsThatFollowEachOther) {
  EXPECT_EQ(numbers_text({4}), "4");
  EXPECT_EQ(numbers_text({1, 2, 3, 7, 9, 10}), "1-3, 7, 9, 10");
}

}  // namespace
}  // namespace clearcut::report
