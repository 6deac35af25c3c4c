#include "stock/angle_set.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/random.h"

namespace clearcut {
namespace {

TEST(AngleSet, BeginsWhole) {
  const AngleSet set(-kPi / 2, kPi / 2);
  EXPECT_DOUBLE_EQ(set.measure(), kPi);
}

TEST(AngleSet, RemovesAcrossTheSeam) {
  AngleSet set(-kPi, kPi);
  set.remove(kPi, 0.5);  // half of it at each end of the domain
  ASSERT_EQ(set.intervals().size(), 1u);
  EXPECT_DOUBLE_EQ(set.intervals()[0].from, -kPi + 0.5);
  EXPECT_DOUBLE_EQ(set.intervals()[0].to, kPi - 0.5);
}

TEST(AngleSet, TurnsMayBeAddedToAnInterval) {
  for (const int turns : {-3, -1, 0, 1, 5}) {
    AngleSet set(-1, 1);
    set.remove(0.2 + 2 * kPi * turns, 0.1);
    ASSERT_EQ(set.intervals().size(), 2u) << turns;
    EXPECT_NEAR(set.measure(), 1.8, 1e-12);
  }
}

TEST(AngleSet, KeepsOnlyTheArcsGiven) {
  AngleSet set(-kPi, kPi);
  const std::vector<AngleSet::Arc> arcs{{0, 0.25}, {kPi, 0.5}};
  set.keep(arcs);
  EXPECT_NEAR(set.measure(), 1.5, 1e-12);
  set.keep({});
  EXPECT_TRUE(set.empty());
}

// What correct means: after any sequence of removals a direction is in the set exactly when no removed arc
// holds it. Checked at 2000 directions, away from arc ends.
TEST(AngleSet, AgreesWithMembershipOfDirections) {
  Random random(7);
  for (int round = 0; round < 300; ++round) {
    AngleSet set(-kPi / 2, kPi / 2);
    std::vector<AngleSet::Arc> removed;
    for (int i = 0; i < 8; ++i) {
      removed.push_back({random.between(-9, 9), random.between(0, 0.4)});
      set.remove(removed.back().center, removed.back().half);
    }
    for (int i = 0; i < 2000; ++i) {
      const double angle = -kPi / 2 + kPi * (i + 0.5) / 2000;
      bool expected = true, unclear = false;
      for (const AngleSet::Arc& arc : removed) {
        const double gap = std::abs(std::remainder(angle - arc.center, 2 * kPi)) - arc.half;
        expected = expected && gap > 0;
        unclear = unclear || std::abs(gap) < 1e-9;
      }
      bool found = false;
      for (const AngleInterval& item : set.intervals())
        found = found || (item.from <= angle && angle <= item.to);
      if (!unclear) {
        ASSERT_EQ(found, expected) << "angle " << angle << " round " << round;
      }
    }
  }
}

}  // namespace
}  // namespace clearcut
