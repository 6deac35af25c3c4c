// Programs that are wrong by little: the check must not call them clean.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "verify/test_findings.h"
#include "verify/test_program.h"
#include "verify/verify.h"

namespace clearcut::verify {
namespace {

using testing::circle_loop;
using testing::cut_square_rings;
using testing::has;
using testing::kRings;
using testing::pocket_part;
using testing::rectangle;
using testing::report_of;
using testing::square_part;
using testing::Writer;

const Vec2 kCenter{30, 30};

Writer& circle(Writer& writer, double radius, Turn turn = Turn::kCounterClockwise) {
  writer.feed(kCenter + Vec2{radius, 0}).arc(kCenter - Vec2{radius, 0}, kCenter, turn);
  return writer.arc(kCenter + Vec2{radius, 0}, kCenter, turn);
}

/// A round pocket of radius 20, 3 mm deep, cut by rings of a 10 mm cutter; the last of radius `last`.
Findings round_pocket(double last, double depth = 3) {
  const Part part = pocket_part({Region::from_valid_loops(circle_loop(kCenter, 20), {})}, 10, -3);
  Writer writer;
  writer.enter(kCenter + Vec2{4, 0}, 0, -depth);
  for (const double r : {4.0, 8.0, 12.0, last}) circle(writer, r);
  return verify_program(part, writer.done(), {});
}

/// A layer as far above the floor as may be left, but for rounding: the passes on the floor count, not that layer's.
TEST(Verify, ALayerJustAboveTheFloorDoesNotCountForIt) {
  Part part = square_part();
  part.features[0].floor_z = -1;
  ASSERT_GT(-0.99 - part.features[0].floor_z, Tolerances{}.uncut);
  Writer writer;
  cut_square_rings(writer, {25, 25}, kRings, 0, -0.99);
  cut_square_rings(writer, {25, 25}, kRings, 0, -1);
  const Findings both = verify_program(part, writer.done(), {});
  EXPECT_TRUE(both.all.clean) << report_of(both);
  EXPECT_LT(both.all.uncut_thickness_mm, 0.009);
}

TEST(SlightErrors, ASliverOfElevenMicrometresAlongAnArc) {
  EXPECT_TRUE(round_pocket(14.995).all.clean);
  const Findings findings = round_pocket(14.989);
  ASSERT_TRUE(has(findings, FaultKind::kUncut));
  EXPECT_GE(findings.all.uncut_thickness_mm, 0.011);
  EXPECT_GE(findings.all.uncut_mm2, 0.011 * 2 * kPi * 20 * 0.95);
}

TEST(SlightErrors, ALastLayerWrongByTwentyMicrometres) {
  EXPECT_TRUE(round_pocket(15, 3).all.clean);
  EXPECT_FALSE(round_pocket(15, 2.98).all.clean);
  const Findings deep = round_pocket(15, 3.02);
  ASSERT_TRUE(has(deep, FaultKind::kGouge));
  EXPECT_NEAR(deep.all.gouge_mm, 0.02, 1e-9);
}

/// One ring of the last layer is 20 micrometres too high: the ridge it leaves is not thin in plan.
TEST(SlightErrors, OneRingTooHigh) {
  const Part part = pocket_part({Region::from_valid_loops(circle_loop(kCenter, 20), {})}, 10, -3);
  Writer writer;
  writer.enter(kCenter + Vec2{4, 0}, 0, -3);
  circle(writer, 4).feed(kCenter + Vec2{11, 0}, -2.98);
  circle(writer, 11).feed(kCenter + Vec2{15, 0}, -3);
  circle(writer, 15);
  EXPECT_TRUE(has(verify_program(part, writer.done(), {}), FaultKind::kUncut));
}

/// 60 x 60 x 2 with a round island of radius `island` about the middle, cut by a 10 mm cutter.
Part island_part(double island) {
  const Region outer = rectangle(0, 0, 60, 60)[0];
  return pocket_part({Region::from_valid_loops(outer.outer(), {circle_loop(kCenter, island)})}, 10, -2);
}

TEST(SlightErrors, AnIslandGougedByTwoMicrometresOnTheWayDown) {
  for (const double too_near : {0.0, 0.002}) {
    const double r = 15 - too_near;
    Writer writer;
    writer.rapid(kCenter + Vec2{r, 0}, 10).rapid(kCenter + Vec2{r, 0}, 1);
    // Round the island in half turns, down to the floor and once more level.
    for (int half = 0; half < 4; ++half) {
      writer.helix(kCenter + Vec2{half % 2 == 0 ? -r : r, 0}, kCenter, 1 - 0.75 * (half + 1));
    }
    circle(writer, 15);
    cut_square_rings(writer, kCenter, {19.5, 24, 25}, 0, -2);
    writer.feed({10, 10}).feed({5, 5}).feed({55, 5}).feed({50, 10});
    const Findings findings = verify_program(island_part(10), writer.done(), {});
    EXPECT_EQ(has(findings, FaultKind::kGouge), too_near > 0) << report_of(findings);
    EXPECT_NEAR(findings.all.gouge_mm, too_near, 1e-9);
  }
}

TEST(SlightErrors, ARapidThroughAnIslandBelowItsTop) {
  for (const double z : {0.001, -0.002, -1.5}) {
    Writer writer;
    circle(writer.enter({45, 30}, 0, -2), 15);
    writer.rapid({45, 30}, z).rapid({15, 30}, z);
    const Findings findings = verify_program(island_part(10), writer.done(), {});
    EXPECT_EQ(has(findings, FaultKind::kGouge), z < 0) << z << report_of(findings);
    if (z < -0.1) {
      EXPECT_TRUE(has(findings, FaultKind::kRapidInMaterial));
    }
  }
}

TEST(SlightErrors, AnArcTheWrongWayRound) {
  for (const Turn turn : {Turn::kCounterClockwise, Turn::kClockwise}) {
    Writer writer;
    writer.enter({55, 50}, 0, -2).arc({55, 40}, {55, 45}, turn);
    const Findings findings = verify_program(island_part(10), writer.done(), {});
    EXPECT_EQ(has(findings, FaultKind::kGouge), turn == Turn::kClockwise) << report_of(findings);
  }
}

/// A ring left out of a pocket is a fault wherever the ring lies and whatever else is cut twice.
TEST(SlightErrors, NoRingMayBeMissing) {
  const std::vector<double> rings{5, 13, 21, 29, 37, 45};
  const Part part = pocket_part(rectangle(-20, -20, 80, 80), 10, -2);
  for (std::size_t missing = 0; missing <= rings.size(); ++missing) {
    std::vector<double> kept = rings;
    if (missing < rings.size()) kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(missing));
    kept.push_back(kept.back());
    Writer writer;
    cut_square_rings(writer, kCenter, kept, 0, -2);
    const Findings findings = verify_program(part, writer.done(), {});
    EXPECT_EQ(findings.all.clean, missing == rings.size()) << missing << "\n" << report_of(findings);
  }
}

/// Rings of random width with one gap: uncut exactly when the gap is wider than the cutter.
TEST(SlightErrors, GapsBetweenRingsByMicrometres) {
  Random random(5);
  for (int round = 0; round < 20; ++round) {
    const double gap = random.between(-0.02, 0.04), first = random.between(2, 4.9);
    const std::vector<double> radii{first, first + 10 + gap, 15};
    const Part part = pocket_part({Region::from_valid_loops(circle_loop(kCenter, 20), {})}, 10, -3);
    Writer writer;
    writer.enter(kCenter + Vec2{first, 0}, 0, -3);
    for (const double r : radii) circle(writer, r);
    const Findings findings = verify_program(part, writer.done(), {});
    if (gap > 0.0101) {
      EXPECT_FALSE(findings.all.clean) << gap;
    }
    if (gap < 0.006) {
      EXPECT_TRUE(findings.all.clean) << gap << report_of(findings);
    }
    EXPECT_GE(findings.all.uncut_thickness_mm, gap - 1e-9);
  }
}

}  // namespace
}  // namespace clearcut::verify
