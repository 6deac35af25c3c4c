#include "link/hole.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/random.h"

namespace clearcut::link {
namespace {

constexpr double kFeed = 1500, kRampFeed = 400;  // mm/min

/// mm/min; the fastest that a tooth at the wall advances, of moves of `kind`.
double fastest_at_wall(const Section& section, MoveKind kind, const HoleWork& hole) {
  double fastest = 0;
  for (const Move& move : section.moves) {
    if (move.kind != kind || !move.path.is_arc()) continue;
    fastest = std::max(fastest, move.feed.mm_per_min() * hole.radius / move.path.radius());
  }
  return fastest;
}

TEST(BoreHole, FeedsAtTheWallAndRampsNoFasterThanItsRamps) {
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    LinkOptions options;
    options.tool_radius = 1 + 4 * random.unit();
    options.feed = MmPerMin::of(kFeed);
    options.ramp_feed = MmPerMin::of(kRampFeed);
    options.plunge_feed = MmPerMin::of(300);
    const HoleWork hole{{3, 4}, options.tool_radius * (1.11 + 0.8 * random.unit()), 0, -8};
    ASSERT_TRUE(can_bore(hole, options.tool_radius, options.tool_radius));
    const Section section = bore_hole(hole, 2, options);
    EXPECT_LE(fastest_at_wall(section, MoveKind::kRamp, hole), kFeed * (1 + 1e-9));
    EXPECT_NEAR(fastest_at_wall(section, MoveKind::kCut, hole), kFeed, 1e-6);
    for (const Move& move : section.moves) {
      if (move.kind != MoveKind::kRamp) continue;
      EXPECT_LE(move.feed.mm_per_min(), kRampFeed * (1 + 1e-9));
    }
  }
}

/// The flat of a rounded end goes round less, and would leave a post.
TEST(BoreHole, LeavesNothingInTheMiddleUnderARoundedEnd) {
  const HoleWork hole{{3, 4}, 5, 0, -8};
  EXPECT_TRUE(can_bore(hole, 3, 3));
  EXPECT_TRUE(can_bore(hole, 3, 2.2));
  EXPECT_FALSE(can_bore(hole, 3, 2));
}

TEST(DrillHole, PecksWhatIsDeeperThanItsPeck) {
  const HoleWork hole{{0, 0}, 1.5, 0, -12};
  const Section section = drill_hole(hole, 3, LinkOptions{});
  const auto pecks = std::count_if(section.moves.begin(), section.moves.end(),
                                   [](const Move& move) { return move.kind == MoveKind::kPlunge; });
  EXPECT_EQ(pecks, 5);  // counted from the height above the material, as cycles do
}

}  // namespace
}  // namespace clearcut::link
