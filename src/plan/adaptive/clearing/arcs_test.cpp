#include "plan/adaptive/clearing/arcs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "base/units.h"

namespace clearcut::plan::adaptive {
namespace {

MachineClock router_on_linuxcnc() {
  MachineClock clock;
  clock.feed = MmPerMin::of(3000);
  clock.link_feed = clock.machine.rapid;
  clock.path = {PathMode::kTolerance, 5e-4, std::nullopt};
  clock.of_control = MotionPlanner::kLinuxCnc;
  return clock;
}

Regions square_of(double side) {
  const std::vector<Vec2> corners{{-side, -side}, {side, -side}, {side, side}, {-side, side}};
  return {Region::from_valid_loops(loop_from_points(corners), {})};
}

/// From p along `heading` for `length` mm; `bend`: 1 / mm, positive to the left.
Edge edge_along(Vec2 p, Vec2 heading, double length, double bend) {
  if (bend == 0) return Edge::line(p, p + heading * length);
  const Vec2 center = p + left_of(heading) / bend;
  return Edge::arc(p, center + rotated(p - center, bend * length), center,
                   bend > 0 ? Turn::kCounterClockwise : Turn::kClockwise);
}

TEST(EasedJoints, ArcJoinsBothSidesTangentially) {
  Random random(7);
  int found = 0;
  for (int i = 0; i < 400; ++i) {
    const double bends[] = {0, random.between(-0.5, 0.5)};
    const Vec2 heading = direction_of(random.between(0, 2 * kPi));
    const Edge before = edge_along({0, 0}, heading, random.between(1, 5), bends[i % 2]);
    const double turn = (i % 4 < 2 ? 1 : -1) * random.between(0.02, 0.25);
    const Edge after =
        edge_along(before.to, rotated(before.tangent_at(1), turn), random.between(1, 5), bends[(i / 2) % 2]);
    const auto eased = eased_joint(before, after, random.between(0.01, 0.1));
    if (!eased) continue;
    ++found;
    EXPECT_LT(distance(eased->before.to, eased->arc.from), 1e-12);
    EXPECT_LT(distance(eased->arc.to, eased->after.from), 1e-12);
    EXPECT_LT(norm(eased->before.tangent_at(1) - eased->arc.tangent_at(0)), 1e-6);
    EXPECT_LT(norm(eased->arc.tangent_at(1) - eased->after.tangent_at(0)), 1e-6);
    EXPECT_LT(distance(eased->arc, before.to), 0.3 * std::abs(turn));
  }
  EXPECT_GT(found, 200);
}

TEST(EasedJoints, KinkIsEasedWithinItsBoundWhereTheMachineIsFaster) {
  const LegalArea legal(square_of(50));
  const double turn = 0.1;
  Pass pass;
  pass.path = {Edge::line({-20, 0}, {0, 0}), edge_along({0, 0}, direction_of(turn), 20, 0)};
  pass.kinds = {MoveKind::kCut, MoveKind::kCut};
  const Pass kinked = pass;
  const MachineClock clock = router_on_linuxcnc();
  EXPECT_EQ(ease_joints(pass, {legal, 0.0015, 0.01}, clock).size(), 2u);
  ASSERT_EQ(pass.path.size(), 3u);
  EXPECT_LE(distance(pass.path[1], Vec2{0, 0}), 0.01);
  EXPECT_LT(clock.seconds(pass.path, pass.kinds), clock.seconds(kinked.path, kinked.kinds) - 0.02);

  Pass unknown_machine = kinked;
  EXPECT_TRUE(ease_joints(unknown_machine, {legal, 0.0015, 0.01}, {}).empty());
  EXPECT_EQ(unknown_machine.path, kinked.path);
}

TEST(EasedJoints, ArcsAtWallsDeviateLess) {
  const LegalArea legal(square_of(20));
  Pass pass;
  pass.path = {Edge::line({-19, -20}, {0, -20}), edge_along({0, -20}, direction_of(0.1), 15, 0)};
  pass.kinds = {MoveKind::kCut, MoveKind::kCut};
  const MachineClock clock = router_on_linuxcnc();
  ease_joints(pass, {legal, 0.0015, 0.01}, clock);
  for (const Edge& edge : pass.path) EXPECT_TRUE(legal.contains(edge.at(0.5)));
  ASSERT_EQ(pass.path.size(), 3u);
  EXPECT_LE(distance(pass.path[1], Vec2{0, -20}), 0.0015);
}

TEST(WideArcs, AreWrittenAsLinesWithinWhatIsPermitted) {
  const LegalArea legal(square_of(50));
  const Edge wide = edge_along({-10, 3}, direction_of(0.2), 25, 1 / 1500.0),
             narrow = edge_along(wide.to, wide.tangent_at(1), 10, 1 / 300.0);
  Pass pass;
  pass.path = {wide, narrow};
  pass.kinds = {MoveKind::kCut, MoveKind::kLink};
  const auto replaced = straighten_wide_arcs(pass, {legal, 0.0015, 0.005});
  ASSERT_EQ(replaced, (std::vector<Edge>{wide}));
  ASSERT_EQ(pass.kinds.size(), pass.path.size());
  EXPECT_EQ(pass.path.back(), narrow);
  EXPECT_EQ(pass.path.size(), 5U) << "7.7 mm each have a sagitta of 0.005 mm";
  EXPECT_EQ(pass.path.front().from, wide.from);
  double mm = 0;
  for (std::size_t i = 0; i + 1 < pass.path.size(); ++i) {
    const Edge& line = pass.path[i];
    EXPECT_FALSE(line.is_arc());
    EXPECT_EQ(pass.kinds[i], MoveKind::kCut);
    EXPECT_EQ(line.to, pass.path[i + 1].from);
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) EXPECT_LE(distance(wide, line.at(t)), 0.005 + 1e-9);
    mm += line.length();
  }
  EXPECT_NEAR(mm, wide.length(), 1e-4);
}

TEST(WideArcs, StayWhereLinesWouldLeaveTheLegalArea) {
  // An arc along a wall of the same radius, which bulges inwards: lines along it run outside of the area by their sagitta.
  const Edge wall = edge_along({-20, 0}, {1, 0}, 40, -1 / 1200.0);
  const LegalArea legal(
      {Region::from_valid_loops({wall, Edge::line(wall.to, {0, 60}), Edge::line({0, 60}, wall.from)}, {})});
  Pass pass;
  pass.path = {wall};
  pass.kinds = {MoveKind::kCut};
  EXPECT_TRUE(straighten_wide_arcs(pass, {legal, 0.0015, 0.005}).empty());
  EXPECT_EQ(pass.path, (Path{wall}));
}

}  // namespace
}  // namespace clearcut::plan::adaptive
