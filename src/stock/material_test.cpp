#include "stock/material.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/random.h"

namespace clearcut::stock {
namespace {

Move flat(const Edge& path, double z) {
  return {path, z, z, MoveKind::kCut, MmPerMin::of(1000), 0};
}

double degrees(double radians) {
  return radians * 180 / kPi;
}

TEST(Material, FreshSolidIsASlot) {
  const Material material(std::nullopt, 0, {3});
  const CutterEngagement engagement = material.engagement({0, 0}, {1, 0}, 3, -1);
  EXPECT_DOUBLE_EQ(degrees(engagement.angle), 180);
  EXPECT_DOUBLE_EQ(engagement.left, engagement.right);
}

TEST(Material, AboveTheTopThereIsNothing) {
  const Material material(std::nullopt, 0, {3});
  EXPECT_EQ(material.engagement({0, 0}, {1, 0}, 3, 0).angle, 0);
  EXPECT_TRUE(material.is_removed({0, 0}, 0));
  EXPECT_FALSE(material.is_removed({0, 0}, -0.001));
}

TEST(Material, ForgettingBringsBackWhatWasThereBefore) {
  Random random(5);
  Material once(std::nullopt, 0, {3}), twice(std::nullopt, 0, {3});
  const auto some_move = [&] {
    const Vec2 a{random.between(0, 40), random.between(0, 40)},
        b{random.between(0, 40), random.between(0, 40)};
    return flat(Edge::line(a, b), -1);
  };
  for (int i = 0; i < 20; ++i) {
    const Move kept = some_move();
    once.add(kept, 3);
    twice.add(kept, 3);
  }
  const std::size_t sweeps = twice.sweeps();
  for (int i = 0; i < 20; ++i) twice.add(some_move(), 3);
  twice.forget_beyond(sweeps);
  for (int i = 0; i < 200; ++i) {
    const Vec2 p{random.between(-5, 45), random.between(-5, 45)};
    EXPECT_EQ(once.engagement(p, {1, 0}, 3, -1).angle, twice.engagement(p, {1, 0}, 3, -1).angle);
  }
}

// acos(1 - stepover / R): the closed form of a straight pass beside a straight pass.
TEST(Material, StepoverGivesItsClosedForm) {
  const double r = 5;
  for (const double stepover : {0.5, 2.0, 5.0, 7.5, 9.9}) {
    Material material(std::nullopt, 0, {r});
    material.add(flat(Edge::line({-50, 0}, {50, 0}), -1), r);
    const CutterEngagement on_left = material.engagement({0, stepover}, {1, 0}, r, -1);
    EXPECT_NEAR(on_left.angle, std::acos(1 - stepover / r), 1e-12) << stepover;
    // Material is on the left when the cleared pass is on the right.
    EXPECT_GT(on_left.left, on_left.right - 1e-12);
    const CutterEngagement on_right = material.engagement({0, stepover}, {-1, 0}, r, -1);
    EXPECT_NEAR(on_right.right, on_left.left, 1e-12);
  }
}

TEST(Material, OutsideTheBlockThereIsNothing) {
  const Material material(Box{{0, 0}, {100, 50}}, 0, {5});
  // Half over the long edge, travelling along it: a quarter circle is in.
  EXPECT_NEAR(degrees(material.engagement({50, 0}, {1, 0}, 5, -1).angle), 90, 1e-9);
  EXPECT_EQ(material.engagement({50, -6}, {1, 0}, 5, -1).angle, 0);
  EXPECT_TRUE(material.is_removed({101, 10}, -1));
}

TEST(Material, ShallowPassesLeaveWhatIsBelow) {
  Material material(std::nullopt, 0, {5});
  material.add(flat(Edge::line({-50, 0}, {50, 0}), -1), 5);
  EXPECT_NEAR(degrees(material.engagement({0, 0}, {1, 0}, 5, -2).angle), 180, 1e-9);
  EXPECT_EQ(material.height({0, 0}), -1);
  EXPECT_EQ(material.height({0, 6}), 0);
}

TEST(Material, PlungeRemovesADisc) {
  Material material(std::nullopt, 0, {5});
  material.add({Edge::line({1, 1}, {1, 1}), 2, -3, MoveKind::kPlunge, MmPerMin::of(100), 0}, 5);
  EXPECT_EQ(material.height({1, 5.9}), -3);
  EXPECT_EQ(material.height({1, 6.1}), 0);
}

TEST(Material, RampRemovesAsDeepAsItsTipPassed) {
  Material material(std::nullopt, 0, {1});
  material.add({Edge::line({0, 0}, {100, 0}), 0, -10, MoveKind::kRamp, MmPerMin::of(100), 0}, 1);
  // The lowest disc over (50, 0) is that whose centre is 1 mm further: z = -5.1.
  EXPECT_NEAR(material.height({50, 0}), -5.1, 1e-5);
  EXPECT_TRUE(material.is_removed({50, 0}, -5));
  EXPECT_FALSE(material.is_removed({50, 0}, -5.2));
}

TEST(Material, ACircleRunTwiceMeetsItsOwnStart) {
  const Material material(std::nullopt, 0, {5});
  // One arc of nearly a full turn: at its end the front is over where it began.
  const Vec2 start{4, 0}, end = direction_of(-0.05) * 4;
  const Move round = flat(Edge::arc(start, end, {0, 0}, Turn::kCounterClockwise), -1);
  EXPECT_NEAR(degrees(material.engagement(round, 0, 5).angle), 180, 1e-9);
  EXPECT_LT(degrees(material.engagement(round, 1, 5).angle), 3);  // the gap itself is 2.9 degrees
}

struct Scene {
  std::vector<Move> moves;
  std::vector<double> radii;
};

Scene random_scene(Random& random) {
  Scene scene;
  const auto point = [&] { return Vec2{random.between(-15, 15), random.between(-15, 15)}; };
  for (int i = 0; i < 14; ++i) {
    const Vec2 a = point(), b = point();
    const double z = -static_cast<double>(1 + random.below(3));
    const auto kind = random.below(4);
    Edge path = Edge::line(a, b);
    if (kind == 1) path = Edge::from_bulge(a, b, random.between(-3, 3));
    if (kind == 2) path = Edge::line(a, a);
    Move move = flat(path, z);
    if (kind == 3) move.z_from = z + 1;
    scene.moves.push_back(move);
    scene.radii.push_back(random.below(2) == 0 ? 2.0 : 5.0);
  }
  return scene;
}

/// Brute force: the lowest tip over p, from points along every path.
bool removed_by_sampling(const Scene& scene, Vec2 p, double z, double slack) {
  for (std::size_t i = 0; i < scene.moves.size(); ++i) {
    const Move& move = scene.moves[i];
    if (move.is_vertical()) {
      if (move.z_to <= z && distance(move.path.from, p) <= scene.radii[i] + slack) return true;
      continue;
    }
    const int n = 400;
    for (int k = 0; k <= n; ++k) {
      const double t = static_cast<double>(k) / n;
      if (move.z_from + (move.z_to - move.z_from) * t > z + slack) continue;
      if (distance(move.path.at(t), p) <= scene.radii[i] + slack) return true;
    }
  }
  return false;
}

// What correct means: a direction belongs to the engagement exactly when the point of the circle there is in
// material. The sampling is blind within 0.01 mm of an outline; such directions are left out, and must be
// few.
TEST(Material, EngagementAgreesWithSampledRandomScenes) {
  Random random(11);
  int checked = 0, unclear = 0, in_material = 0;
  for (int round = 0; round < 25; ++round) {
    const Scene scene = random_scene(random);
    Material material(Box{{-14, -13}, {13, 14}}, 0, {2, 5, 3.5});
    for (std::size_t i = 0; i < scene.moves.size(); ++i) material.add(scene.moves[i], scene.radii[i]);
    for (int k = 0; k < 6; ++k) {
      const Vec2 center{random.between(-15, 15), random.between(-15, 15)};
      const double radius = random.below(2) == 0 ? 2.0 : 3.5, z = -random.between(0.5, 3.2);
      const AngleSet circle = material.circle_in_material(center, radius, z);
      for (int i = 0; i < 180; ++i) {
        const double angle = -kPi + 2 * kPi * (i + 0.5) / 180;
        const Vec2 p = center + direction_of(angle) * radius;
        const Box block = *material.plan();
        const bool surely_out = !block.grown(0.01).contains(p) || removed_by_sampling(scene, p, z, -0.02);
        const bool surely_in = block.grown(-0.01).contains(p) && !removed_by_sampling(scene, p, z, 0.02);
        bool found = false;
        for (const AngleInterval& item : circle.intervals()) found |= item.from <= angle && angle <= item.to;
        ++checked;
        if (surely_in == surely_out) {
          ++unclear;
          continue;
        }
        in_material += surely_in;
        ASSERT_EQ(found, surely_in) << "round " << round << " angle " << angle << " at " << p.x << ' ' << p.y;
        ASSERT_EQ(material.is_removed(p, z), !surely_in);
      }
    }
  }
  EXPECT_LT(unclear, checked / 20);
  EXPECT_GT(in_material, checked / 20);
}

/// Moves as programs have them: most go on where the last one ended, many without a bend, some to and fro.
std::vector<Move> random_chain(Random& random, int count) {
  std::vector<Move> moves;
  Vec2 at{random.between(-9, 9), random.between(-9, 9)}, ahead = direction_of(random.between(-3, 3));
  for (int i = 0; i < count; ++i) {
    const auto kind = random.below(8);
    if (kind == 0) at = {random.between(-9, 9), random.between(-9, 9)};
    if (kind <= 2) ahead = direction_of(random.between(-3, 3));
    Edge path = Edge::line(at, at + ahead * random.between(0.01, 6));
    if (kind == 3 && !moves.empty()) path = moves.back().path.reversed();
    if (kind >= 5) {
      const double ring = random.between(0.1, 8) * (random.below(2) == 0 ? 1 : -1);
      const Vec2 center = at + left_of(ahead) * ring;
      const double sweep = std::copysign(random.between(0.05, 5.5), ring);
      path = Edge::arc(at, center + rotated(at - center, sweep), center,
                       ring > 0 ? Turn::kCounterClockwise : Turn::kClockwise);
    }
    moves.push_back(flat(path, -static_cast<double>(1 + random.below(4) / 3)));
    at = path.to;
    ahead = path.tangent_at(1);
  }
  return moves;
}

// Sweeps that go on share their discs at the joints or need none. Those run backwards and in any other order do not: both
// must tell the same of every circle.
TEST(Material, JoinedSweepsCoverWhatTheyCoverApart) {
  Random random(17);
  for (int round = 0; round < 150; ++round) {
    const std::vector<Move> moves = random_chain(random, 24);
    Material joined(std::nullopt, 0, {3}), apart(std::nullopt, 0, {3});
    for (const Move& move : moves) {
      joined.add(move, 3);
      if (random.below(4) != 0) continue;
      const std::size_t sweeps = joined.sweeps();
      joined.add(flat(Edge::line(move.path.to, move.path.to + move.path.tangent_at(1)), move.z_to), 3);
      for (const Move& other : random_chain(random, 3)) joined.add(other, 3);
      joined.forget_beyond(sweeps);
    }
    for (std::size_t i = 0; i < moves.size(); ++i) {
      Move move = moves[i * 7 % moves.size()];
      move.path = move.path.reversed();
      apart.add(move, 3);
    }
    for (int k = 0; k < 100; ++k) {
      const Vec2 p = random.below(2) == 0 ? Vec2{random.between(-12, 12), random.between(-12, 12)}
                                          : moves[random.below(moves.size())].path.at(random.between(0, 1));
      const double radius = random.below(2) == 0 ? 2.9998 : random.between(0.3, 2.9),
                   z = -random.between(0.5, 2.5);
      const Vec2 ahead = direction_of(random.between(-3, 3));
      const CutterEngagement engagement = joined.engagement(p, ahead, radius, z);
      ASSERT_NEAR(engagement.angle, apart.engagement(p, ahead, radius, z).angle, 1e-9) << round;
      const EngagementSize size = joined.engagement_size(p, ahead, radius, z);
      ASSERT_NEAR(size.angle, engagement.angle, 1e-12);
      ASSERT_EQ(size.parts, static_cast<int>(engagement.angles.intervals().size()));
      const AngleSet circle = joined.circle_in_material(p, radius, z);
      ASSERT_NEAR(circle.measure(), apart.circle_in_material(p, radius, z).measure(), 1e-9) << round;
      const auto touch = joined.circle_touch(p, radius, z);
      ASSERT_EQ(touch.has_value(), !circle.empty());
      if (!touch || touch->angle < 1e-3) continue;
      ASSERT_NEAR(touch->angle, circle.measure(), 1e-12);
      ASSERT_FALSE(joined.is_removed(p + touch->toward * radius, z));
    }
  }
}

TEST(Material, TrendOfTheContactIsItsDerivative) {
  Random random(23);
  const double r = 2.9998, step = 1e-5;
  int checked = 0, smooth = 0;
  for (int round = 0; round < 100; ++round) {
    Material material(Box{{-10, -9}, {9, 10}}, 0, {3});
    for (const Move& move : random_chain(random, 12)) material.add(move, 3);
    for (int k = 0; k < 40; ++k) {
      const Vec2 p{random.between(-10, 10), random.between(-10, 10)},
          ahead = direction_of(random.between(-3, 3));
      const EngagementTrend trend = material.engagement_trend(p, ahead, r, -1);
      const auto moved = [&](double by) {
        return material.engagement_size(p + ahead * by, ahead, r, -1).angle;
      };
      const auto turned = [&](double by) {
        return material.engagement_size(p, rotated(ahead, by), r, -1).angle;
      };
      if (trend.size.angle == 0) continue;
      ++checked;
      const double onwards = (moved(step) - trend.size.angle) / step,
                   backwards = (trend.size.angle - moved(-step)) / step;
      // Elsewhere a part begins or ends within a step, or runs away nearly along an outline.
      if (std::abs(onwards - backwards) > 1e-3 || std::abs(onwards) > 3) continue;
      ++smooth;
      EXPECT_NEAR(trend.change.per_mm, (onwards + backwards) / 2, 1e-4) << round << ' ' << k;
      EXPECT_NEAR(trend.change.per_radian, (turned(step) - turned(-step)) / (2 * step), 1e-4)
          << round << ' ' << k;
    }
  }
  EXPECT_GT(smooth, checked * 9 / 10);
  EXPECT_GT(checked, 1000);
}

TEST(Material, OrderOfQuestionsAndRadiiDoesNotMatter) {
  Random random(3);
  const Scene scene = random_scene(random);
  Material fine(std::nullopt, 0, {2}), coarse(std::nullopt, 0, {2, 20});
  for (std::size_t i = 0; i < scene.moves.size(); ++i) {
    fine.add(scene.moves[i], scene.radii[i]);
    coarse.add(scene.moves[i], scene.radii[i]);
  }
  for (int i = 0; i < 500; ++i) {
    const Vec2 p{random.between(-20, 20), random.between(-20, 20)};
    EXPECT_EQ(fine.engagement(p, {0, 1}, 2, -1).angle, coarse.engagement(p, {0, 1}, 2, -1).angle);
    EXPECT_EQ(fine.is_removed(p, -2), coarse.is_removed(p, -2));
  }
}

}  // namespace
}  // namespace clearcut::stock
