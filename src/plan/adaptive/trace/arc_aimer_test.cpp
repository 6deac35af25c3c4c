#include "plan/adaptive/trace/arc_aimer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "base/units.h"

namespace clearcut::plan::adaptive {
namespace {

constexpr double kTool = 5;

/// The room of a square pocket whose middle is cleared up to `cleared` mm.
struct Room {
  explicit Room(double cleared) : ground(area, kTool, std::nullopt) { ground.remove_disc({25, 25}, cleared); }

  Regions area = {
      Region::from_valid_loops(loop_from_points(std::vector<Vec2>{{5, 5}, {45, 5}, {45, 45}, {5, 45}}), {})};
  Ground ground;
};

/// Along the lower wall, x mm from its beginning.
Course on_wall(double x, double limit) {
  return {{5 + x, 5}, {1, 0}, 1 / kTool, limit, kTool, kTool / 2, 0.0};
}

/// The largest contact and what is lost, looked at closely.
struct Looks {
  double most = 0;
  double lost = 0;
};
Looks look_along(const Course& from, const Shot& shot, const Ground& ground, double limit) {
  constexpr int kLooks = 2000;
  Looks looks;
  for (int k = 0; k < kLooks; ++k) {
    const auto [p, heading] = after(from, shot, shot.length * (k + 0.5) / kLooks);
    const double contact = ground.contact(p, heading);
    looks.most = std::max(looks.most, contact);
    looks.lost += std::max(0.0, 1 - (1 - std::cos(contact)) / (1 - std::cos(limit))) * shot.length / kLooks;
  }
  return looks;
}

TEST(ArcAimer, CrossesACornerOnOneArcWithinTheLimitAndSaysWhatThatLoses) {
  Random random(3);
  int crossings = 0, sure_ones = 0;
  for (int i = 0; i < 400; ++i) {
    const double limit = random.between(0.7, 1.5);
    Room room(random.between(24, 30));
    const ArcAimer aimer(room.ground, room.area, limit);
    const Course from = on_wall(random.between(20, 38), limit);
    room.ground.cut(Edge::line({5, 5}, from.point));
    const auto crossing = aimer.across(from, 0.5 / kTool);
    if (!crossing || !aimer.leaves_wall(from, crossing->shot)) continue;
    ++crossings;
    SCOPED_TRACE(testing::Message() << "limit " << limit << " from " << from.point.x);
    const Shot& shot = crossing->shot;
    const Looks looks = look_along(from, shot, room.ground, limit);
    EXPECT_NEAR(crossing->lost, looks.lost, 0.08 * shot.length);
    EXPECT_TRUE(crossing->loses_little() ? looks.lost < 0.19 * shot.length : looks.lost > 0.03 * shot.length);
    EXPECT_NEAR(after(from, shot, shot.length).point.x, 45, 1e-6) << "it ends on the wall";
    const auto sure = aimer.surely_within(from, shot);
    if (!sure) continue;
    ++sure_ones;
    EXPECT_LE(look_along(from, *sure, room.ground, limit).most, limit + kAboveLimit + 2e-3);
  }
  EXPECT_GT(crossings, 40);
  EXPECT_GT(sure_ones, 30);
}

TEST(ArcAimer, CrossesNothingWhereNoWallIsNear) {
  const Room room(10);
  const ArcAimer aimer(room.ground, room.area, 1.2);
  EXPECT_FALSE(aimer.across(on_wall(1, 1.2), 1 / kTool).has_value());
  EXPECT_FALSE(
      aimer.meets_wall({{25, 25}, {1, 0}, 1 / kTool, 1.2, kTool, kTool / 2, std::nullopt}, 1 / kTool));
}

TEST(ArcAimer, PlacesOnAShotAreOnItsArc) {
  Random random(5);
  for (int i = 0; i < 500; ++i) {
    const Course from{
        {random.between(-9, 9), random.between(-9, 9)}, direction_of(random.between(0, 6)), 0, 0, 0, 1, {}};
    const Shot shot{random.between(-0.4, 0.4), random.between(0.1, 9), random.between(-0.1, 0.1)};
    const Edge edge = edge_of(from, shot);
    for (const double t : {0.3, 0.8, 1.0})
      EXPECT_LT(distance(after(from, shot, t * shot.length).point, edge.at(t)), 2e-4);
    EXPECT_GT(dot(after(from, shot, shot.length).heading, edge.tangent_at(1)), 1 - 1e-3);
  }
}

}  // namespace
}  // namespace clearcut::plan::adaptive
