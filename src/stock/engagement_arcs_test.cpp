#include "stock/engagement_arcs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/random.h"

namespace clearcut::stock {
namespace {

/// Directions within `half` of `center`, taken away.
struct Arc {
  double center = 0;
  double half = 0;
};

EngagementArcs all_round() {
  return {{0, 0}, 1, {1, 0}, EngagementArcs::Part::kWhole};
}

EngagementArcs front() {
  return {{0, 0}, 1, {1, 0}, EngagementArcs::Part::kFront};
}

void remove(EngagementArcs& arcs, const Arc& arc) {
  arcs.remove_beyond({std::cos(arc.center), std::sin(arc.center)}, std::cos(arc.half));
}

TEST(EngagementArcs, BeginsWhole) {
  EXPECT_DOUBLE_EQ(front().angles().measure(), kPi);
}

TEST(EngagementArcs, RemovesAcrossTheSeam) {
  EngagementArcs arcs = all_round();
  remove(arcs, {kPi, 0.5});  // half of it at each end of the domain
  const AngleSet set = arcs.angles();
  ASSERT_EQ(set.intervals().size(), 1u);
  EXPECT_DOUBLE_EQ(set.intervals()[0].from, -kPi + 0.5);
  EXPECT_DOUBLE_EQ(set.intervals()[0].to, kPi - 0.5);
}

TEST(EngagementArcs, TurnsMayBeAddedToAnInterval) {
  for (const int turns : {-3, -1, 0, 1, 5}) {
    EngagementArcs arcs = front();
    remove(arcs, {0.2 + 2 * kPi * turns, 0.1});
    const AngleSet set = arcs.angles();
    ASSERT_EQ(set.intervals().size(), 2u) << turns;
    EXPECT_NEAR(set.measure(), kPi - 0.2, 1e-12);
  }
}

TEST(EngagementArcs, KeepsOnlyTheArcsThatNothingCovers) {
  EngagementArcs arcs = all_round();
  // All but 0.25 to both sides of 0 and 0.5 to both sides of pi.
  for (const double side : {1.0, -1.0}) remove(arcs, {side * (kPi - 0.25) / 2, (kPi - 0.75) / 2});
  EXPECT_NEAR(arcs.angles().measure(), 1.5, 1e-12);
  arcs.clear();
  EXPECT_TRUE(arcs.angles().empty());
}

// What correct means: after any sequence of removals a direction is in the set exactly when no removed arc
// holds it. Checked at 2000 directions, away from arc ends.
TEST(EngagementArcs, AgreesWithMembershipOfDirections) {
  Random random(7);
  for (int round = 0; round < 300; ++round) {
    EngagementArcs arcs = front();
    std::vector<Arc> removed;
    for (int i = 0; i < 8; ++i) {
      removed.push_back({random.between(-9, 9), random.between(0, 0.4)});
      remove(arcs, removed.back());
    }
    const AngleSet set = arcs.angles();
    for (int i = 0; i < 2000; ++i) {
      const double angle = -kPi / 2 + kPi * (i + 0.5) / 2000;
      bool expected = true, unclear = false;
      for (const Arc& arc : removed) {
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
}  // namespace clearcut::stock
