#include "plan/adaptive/finish/corners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/random.h"
#include "base/units.h"

namespace clearcut::plan::adaptive {
namespace {

constexpr double kResidual = 5e-3;

/// A corner in the origin, both of its walls cut up to 0.6 radii before it, and all that is farther inside.
struct Wedge {
  Wedge(double turn_angle, double tool_radius)
      : turn(turn_angle),
        radius(tool_radius),
        along(direction_of(0.3)),
        away(rotated(along, turn_angle)),
        region(Region::from_valid_loops(
            loop_from_points(std::vector<Vec2>{along * (-20 * tool_radius), {}, away * (20 * tool_radius)}),
            {})),
        walls(region, 0.06 * tool_radius, 1e-3),
        remaining({region}, tool_radius, std::nullopt) {
    remaining.cut(Edge::line(before(20 * radius), before(near())));
    remaining.cut(Edge::line(after(near()), after(20 * radius)));
    for (double x = near(); x < 5 * radius; x += 0.5 * radius) remaining.cut(Edge::line(before(x), after(x)));
  }

  double near() const { return 0.6 * radius; }
  Vec2 before(double x) const { return along * -x; }
  Vec2 after(double x) const { return away * x; }
  Corner corner(double limit) const {
    const auto corners = corners_of(walls, limit);
    return *std::min_element(corners.begin(), corners.end(), [&](const Corner& a, const Corner& b) {
      return norm(walls.point(a.place)) < norm(walls.point(b.place));
    });
  }
  std::optional<CornerRound> round(double limit) {
    return round_corner(walls, corner(limit), near(), remaining, limit, kResidual);
  }

  double turn, radius;
  Vec2 along, away;
  Region region;
  Walls walls;
  RemainingStock remaining;
};

TEST(RoundCorner, GoesFromWallToWallWithinTheLimitAndLeavesNoMoreThanTheResidual) {
  Random random(7);
  for (int i = 0; i < 60; ++i) {
    const double limit = random.between(0.8, 1.4);
    Wedge wedge(random.between(std::max(1.0, limit + 0.1), 2.3), random.between(1, 6));
    SCOPED_TRACE(testing::Message() << "turn " << wedge.turn << " limit " << limit << " radius "
                                    << wedge.radius);
    const std::size_t cuts = wedge.remaining.cuts();
    const auto round = wedge.round(limit);
    ASSERT_TRUE(round.has_value());
    EXPECT_EQ(wedge.remaining.cuts(), cuts) << "the ground stays as it is";
    EXPECT_LT(distance(round->path.front().from, wedge.before(wedge.near())), 1e-3);
    EXPECT_LT(distance(round->path.back().to, wedge.walls.wall(0).at(round->end)), 1e-3);
    for (const Edge& edge : round->path) {
      for (int k = 1; k < 40; ++k) {
        const double t = k / 40.0;
        EXPECT_TRUE(wedge.remaining.legal().holds(edge.at(t)));
        EXPECT_LT(wedge.remaining.engagement(edge.at(t), edge.tangent_at(t)), limit + 0.035);
      }
      wedge.remaining.cut(edge);
    }
    wedge.remaining.cut(Edge::line(round->path.back().to, wedge.after(wedge.near())));
    for (double x = 0; x < wedge.near(); x += wedge.near() / 50) {
      EXPECT_FALSE(wedge.remaining.touches(wedge.before(x), 1.3 * kResidual)) << x;
      EXPECT_FALSE(wedge.remaining.touches(wedge.after(x), 1.3 * kResidual)) << x;
    }
  }
}

TEST(RoundCorner, TakesFewMoves) {
  EXPECT_LE(Wedge(kPi / 2, 5).round(1.36)->path.size(), 6U);
  EXPECT_LE(Wedge(kPi / 2, 5).round(0.92)->path.size(), 12U);
  EXPECT_LE(Wedge(2 * kPi / 3, 5).round(1.36)->path.size(), 12U);
  EXPECT_LE(Wedge(2 * kPi / 3, 5).round(0.92)->path.size(), 24U);
}

TEST(RoundCorner, LeavesAWedgeThatTheWallsAllowUpToTheEndOfTheSecond) {
  Wedge wedge(kPi / 2, 5);
  const auto round = wedge.round(1.36);
  ASSERT_GT(round->wedge, 0);
  EXPECT_LE(round->wedge, kResidual);
  for (const Edge& edge : round->path) wedge.remaining.cut(edge);
  wedge.remaining.cut(Edge::line(round->path.back().to, wedge.away * (20 * wedge.radius)));
  const auto touches = [&] {
    wedge.walls.update(wedge.remaining, wedge.region.box());
    return wedge.walls.touches_after({0, wedge.corner(1.36).place.s + 0.2 * wedge.radius}, 5 * wedge.radius);
  };
  EXPECT_TRUE(touches()) << "thicker than what may stay on walls";
  wedge.walls.leave_wedge(wedge.corner(1.36).place, round->wedge);
  EXPECT_FALSE(touches());
}

TEST(RoundCorner, IsNoneWhereTheWallsAreFarFromCut) {
  Wedge wedge(kPi / 2, 5);
  RemainingStock whole({wedge.region}, wedge.radius, std::nullopt);
  EXPECT_FALSE(round_corner(wedge.walls, wedge.corner(1.0), 3, whole, 1.0, kResidual).has_value());
}

}  // namespace
}  // namespace clearcut::plan::adaptive
