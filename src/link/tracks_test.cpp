#include "link/tracks.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace clearcut::link {
namespace {

/// Two lines that end and begin 2 mm apart, the second one deeper.
std::vector<std::vector<Track>> two_lines() {
  const Track first{{{Edge::line({0, 0}, {10, 0}), -1, -1}}};
  const Track second{{{Edge::line({10, 2}, {0, 2}), -1.5, -1.5}}};
  return {{first}, {second}};
}

LinkOptions options() {
  LinkOptions options;
  options.safe_z = 10;
  options.cross_z = 2;
  options.feed = MmPerMin::of(1000);
  options.plunge_feed = MmPerMin::of(300);
  return options;
}

int rapids_across(const Section& section) {
  return static_cast<int>(std::count_if(section.moves.begin(), section.moves.end(), [](const Move& move) {
    return is_rapid(move.kind) && !move.is_vertical();
  }));
}

TEST(Tracks, AreLinkedAtDepthWhereTheTipHasRoom) {
  Vec2 from, to;
  double height = 0;
  const auto note = [&](Vec2 a, Vec2 b, double z) {
    from = a, to = b, height = z;
    return true;
  };
  const Section section = link_tracks(two_lines(), 1, options(), {note});
  EXPECT_EQ(rapids_across(section), 0);
  EXPECT_EQ(from, (Vec2{10, 0}));
  EXPECT_EQ(to, (Vec2{10, 2}));
  EXPECT_EQ(height, -1) << "at the height of the shallower end";
  const auto link = std::find_if(section.moves.begin(), section.moves.end(),
                                 [](const Move& move) { return move.kind == MoveKind::kLink; });
  ASSERT_NE(link, section.moves.end());
  EXPECT_EQ(link->z_from, -1);
  EXPECT_EQ(link->z_to, -1);
}

TEST(Tracks, AreLeftUpwardsWhereTheTipHasNoRoom) {
  EXPECT_EQ(rapids_across(link_tracks(two_lines(), 1, options())), 1);
  const auto nowhere = [](Vec2, Vec2, double) { return false; };
  EXPECT_EQ(rapids_across(link_tracks(two_lines(), 1, options(), {nowhere})), 1);
}

TEST(Tracks, LongWaysAreHigherWhereTheyWouldCutTooMuch) {
  const auto height_of_way = [](const TipRoom& room) {
    const Section section = link_tracks(two_lines(), 1, options(), room);
    const auto link = std::find_if(section.moves.begin(), section.moves.end(),
                                   [](const Move& move) { return move.kind == MoveKind::kLink; });
    return link == section.moves.end() ? 1.0 : link->z_from;
  };
  const auto anywhere = [](Vec2, Vec2, double) { return true; };
  EXPECT_EQ(height_of_way({anywhere, -0.5, 1.9}), -0.5);
  EXPECT_EQ(height_of_way({anywhere, -0.5, 2.1}), -1);
  EXPECT_EQ(height_of_way({anywhere, -1.2, 1.9}), -1);
}

TEST(Tracks, AreLeftUpwardsWhereThatIsQuicker) {
  auto sets = two_lines();
  sets[1] = {{{{Edge::line({10, 200}, {0, 200}), -1.5, -1.5}}}};
  const auto anywhere = [](Vec2, Vec2, double) { return true; };
  EXPECT_EQ(rapids_across(link_tracks(sets, 1, options(), {anywhere})), 1);
}

}  // namespace
}  // namespace clearcut::link
