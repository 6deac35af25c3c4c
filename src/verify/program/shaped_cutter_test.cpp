// Gouges of cutters that are no cylinders beside a leaning wall that the stock's sides cut off square, against dense sampling of places
// and heights, with sections of the wall's body written down here.
#include "verify/program/shaped_cutter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "model/part.h"
#include "verify/part/finished_part.h"
#include "verify/test_program.h"

namespace clearcut::verify {
namespace {

constexpr double kFloor = -4, kLength = 60, kSlack = 5e-4;  // mm

/// A step along the whole length of the stock; its wall leans from y = 15 at the top into the step.
Part leaning_step(double slope) {
  Part part = testing::pocket_part(testing::rectangle(0, 15, kLength, 40), 6, kFloor);
  part.stock = Stock{{{0, 0}, {kLength, 40}}, -20, 0};
  Feature& step = part.features[0];
  step.kind = FeatureKind::kStep;
  step.wall_slope = Radians::of(std::atan(slope));
  step.allowed = {Region::from_valid_loops(testing::rectangle(-1000, -1000, 1060, 1040)[0].outer(),
                                           {testing::rectangle(0, 0, kLength, 15)[0].outer()})};
  return part;
}

Move move_along(const Edge& path, double z_from, double z_to) {
  Move move;
  move.path = path, move.z_from = z_from, move.z_to = z_to;
  return move;
}

/// mm from p to the section of the wall's body at this height: all of y <= 15 and of what leans out there, between the stock's sides.
double distance_to_body(Vec2 p, double height, double slope) {
  const double beside = std::max({0.0, -p.x, p.x - kLength});
  return std::hypot(beside, std::max(0.0, p.y - (15 - slope * height)));
}

/// The greatest depth sideways, over places along the move and heights.
double sampled(const Move& move, const CutterProfile& cutter, double slope) {
  double worst = -1;
  for (int i = 0; i <= 300; ++i) {
    const double t = i / 300.0, z = move.z_from + (move.z_to - move.z_from) * t;
    for (int k = 0; k <= 200; ++k) {
      const double height = std::max(z, kFloor) * (1 - k / 200.0);
      worst =
          std::max(worst, cutter.radius_at(height - z) - distance_to_body(move.path.at(t), height, slope));
    }
  }
  return worst;
}

TEST(ShapedCutter, BesideALeaningWallCutOffSquareGoesAsDeepAsSampled) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  int gouges = 0;
  for (int i = 0; i < 400; ++i) {
    const double slope = 0.1 + 0.4 * share(random);
    const FinishedPart part(leaning_step(slope));
    // A cone whose flank lies along the wall, another one, a ball, a bull-nose.
    const CutterProfile forms[] = {
        {1.5, 0, slope, 1.5 + 4 * slope}, {0.5, 0, 0.3, 2.5}, {0, 2, 0, 2}, {2, 1, 0, 3}};
    const CutterProfile& cutter = forms[i % 4];
    // Around contact at both ends; every third move begins beside the stock.
    const double z_from = kFloor * share(random), z_to = i % 2 == 0 ? z_from : kFloor * share(random);
    const auto beside_wall = [&](double z) {
      return 15 - slope * z + cutter.radius_at(-z) - 0.4 * slope * (4 + z) - 0.05 + 0.2 * share(random);
    };
    const double x = i % 3 == 0 ? -3 * share(random) : 60 * share(random);
    const Move move = move_along(
        Edge::line({x, beside_wall(z_from)}, {60 * share(random), beside_wall(z_to)}), z_from, z_to);
    const double expected = sampled(move, cutter, slope);
    const auto found = shaped_gouge_of(part, move, cutter, kSlack);
    if (expected > 0.01) {
      ASSERT_TRUE(found) << i << ": " << expected;
      ++gouges;
    }
    if (!found) continue;
    EXPECT_GT(expected, -0.002) << i << ": " << found->depth;
    // What a flank frees upwards is less than sideways, and nothing is deeper than sideways.
    EXPECT_LE(found->depth, expected + 0.01) << i;
    if (cutter.slope == 0) {
      EXPECT_NEAR(found->depth, std::min(expected, -found->z), 0.01) << i;
    }
  }
  EXPECT_GT(gouges, 80);
}

/// All heights and all places along it are the nearest ones: each had been divided down to the least piece.
TEST(ShapedCutter, AFlankAlongAWallCutOffSquareIsJudgedAtOnce) {
  const double slope = 0.2;
  const FinishedPart part(leaning_step(slope));
  const CutterProfile cone{1.5, 0, slope, 1.5 - kFloor * slope};
  const double contact = 15 - slope * kFloor + 1.5;
  for (int i = 0; i < 200; ++i) {
    const double deeper = i % 2 == 0 ? 0 : 0.01;
    const Move move =
        move_along(Edge::line({5, contact - deeper}, {55 - 0.1 * i, contact - deeper}), kFloor, kFloor);
    const auto found = shaped_gouge_of(part, move, cone, kSlack);
    EXPECT_NEAR(found ? found->depth : 0, deeper, 1e-4);
  }
}

/// The same of a wall along an arc, beside which the move goes on its own arc about the same centre.
TEST(ShapedCutter, AFlankAlongACurvedWallCutOffSquareIsJudgedAtOnce) {
  const double slope = 0.2;
  for (const double bulge : {0.3, -0.3}) {
    Part part = leaning_step(slope);
    const std::vector<BulgeVertex> wall{{{0, 20}, bulge}, {{kLength, 20}, 0}},
        step{wall[0], wall[1], {{kLength, 40}, 0}, {{0, 40}, 0}},
        kept{{{0, 0}, 0}, {{kLength, 0}, 0}, {{kLength, 20}, -bulge}, {{0, 20}, 0}};
    part.features[0].target = {Region::from_valid_loops(loop_from_bulges(step), {})};
    part.features[0].allowed = {Region::from_valid_loops(
        testing::rectangle(-1000, -1000, 1060, 1040)[0].outer(), {loop_from_bulges(kept)})};
    const FinishedPart finished(part);
    const CutterProfile cone{1.5, 0, slope, 1.5 - kFloor * slope};
    const Edge edge = Edge::from_bulge({0, 20}, {kLength, 20}, bulge);
    for (int i = 0; i < 40; ++i) {
      const double deeper = i % 2 == 0 ? 0 : 0.01;
      const double away = (1.5 - slope * kFloor - deeper) * (bulge > 0 ? -1 : 1);
      const double radius = edge.radius() + away;
      const auto at = [&](double t) { return edge.center + unit(edge.at(t) - edge.center) * radius; };
      const Edge path = Edge::arc(at(0.1), at(0.9 - 0.01 * i), edge.center, edge.turn);
      const auto found = shaped_gouge_of(finished, move_along(path, kFloor, kFloor), cone, kSlack);
      EXPECT_NEAR(found ? found->depth : 0, deeper, 1e-4) << bulge;
    }
  }
}

}  // namespace
}  // namespace clearcut::verify
