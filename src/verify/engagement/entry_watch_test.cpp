// What counts as an entry into material and what does not.
#include <gtest/gtest.h>

#include <cmath>

#include "verify/test_findings.h"
#include "verify/verify.h"

namespace clearcut::verify {
namespace {

using namespace clearcut::testing;

Findings under_limit(const Part& part, Toolpath program, double limit = 60) {
  VerifyOptions options;
  options.engagement_limit_deg = limit;
  return verify_program(part, program, options);
}

/// A groove along y 25 from x 5, entered upright there, that goes down by `sink` mm as far as 2 mm, and back level.
Toolpath sinking_groove(double sink) {
  Writer writer;
  writer.enter({5, 25}, 0, -2 + sink).feed({45, 25}, -2).feed({5, 25}, -2);
  return writer.done();
}

TEST(Entries, PassesThatSinkCountAndSoDoesTheirWayBack) {
  for (const double degrees : {0.05, 0.21, 0.6, 2.0}) {
    const double sink = 40 * std::tan(degrees * kPi / 180);
    const Findings found = under_limit(square_part(), sinking_groove(sink));
    EXPECT_TRUE(has(found, FaultKind::kOverEngagement)) << degrees;
    EXPECT_GT(found.all.engagement.max_deg, 170) << degrees;
  }
}

TEST(Entries, ASteepWayDownFromAboveIsOneOfItsOwn) {
  // A zigzag of 8 mm from above the material down to 2 mm, then level over it to and fro.
  Writer writer;
  writer.enter({20, 25}, 0, 0.2);
  double z = 0.2;
  for (int i = 0; i < 10; ++i) writer.feed({i % 2 ? 20.0 : 28.0, 25}, std::max(-2.0, z -= 0.25));
  writer.feed({28, 25}).feed({20, 25});
  const Findings found = under_limit(square_part(), writer.done());
  EXPECT_FALSE(has(found, FaultKind::kOverEngagement)) << report_of(found);
  EXPECT_EQ(found.all.entries.count, 1);
  EXPECT_GT(found.all.entries.length_mm, 60);
  EXPECT_GT(found.all.entries.max_deg, 170);
  EXPECT_LT(found.all.engagement.max_deg, 10);
}

TEST(Entries, JointsOfMicrometresAreNoEndOfAWayDown) {
  // As with helices in Klartext: each turn ends half a micrometre beside the place whose digits are printed.
  const auto zigzag_down = [](double joint) {
    Writer writer;
    writer.enter({20, 25}, 0, 0.2);
    double z = 0.2;
    for (int i = 0; i < 10; ++i)
      writer.feed({i % 2 ? 20.0 : 28.0, 25}, std::max(-2.0, z -= 0.25))
          .feed({i % 2 ? 20 + joint : 28 - joint, 25});
    return under_limit(square_part(), writer.feed({28, 25}).feed({20, 25}).done());
  };
  const Findings joined = zigzag_down(0.0005);
  EXPECT_FALSE(has(joined, FaultKind::kOverEngagement)) << report_of(joined);
  EXPECT_EQ(joined.all.entries.count, 1);
  EXPECT_GT(zigzag_down(0.5).all.entries.count, 1);
}

TEST(Entries, AWayBackOverALongRampCounts) {
  Writer writer;
  writer.enter({5, 25}, 0, 0).feed({45, 25}, -2).feed({5, 25}, -2);
  EXPECT_TRUE(has(under_limit(square_part(), writer.done()), FaultKind::kOverEngagement));
  Writer alone;
  alone.enter({5, 25}, 0, 0).feed({45, 25}, -2);
  const Findings found = under_limit(square_part(), alone.done());
  EXPECT_FALSE(has(found, FaultKind::kOverEngagement)) << report_of(found);
  EXPECT_NEAR(found.all.entries.length_mm, std::hypot(40, 2), 0.5);
}

TEST(Entries, ThatGoDownThroughAirBeginWhereTheyMeetMaterial) {
  // Down beside the material in a groove that is there already, then sideways into it, still sinking.
  Writer writer;
  writer.enter({5, 10}, 0, -2).feed({45, 10});
  writer.leave()
      .rapid({5, 10}, 10)
      .rapid({5, 10}, 1)
      .feed({5, 10}, 0.1)
      .feed({10, 10}, -1.7)
      .feed({30, 14}, -2);
  EXPECT_TRUE(has(under_limit(square_part(), writer.done()), FaultKind::kOverEngagement));
}

/// A groove cut in short pieces, each from above down to 2 mm and beside the last; `apart`: mm between them.
Toolpath stepping_groove(double apart, double deeper = 0) {
  Writer writer;
  double z = -2;
  for (double x = 5; x < 40; x += apart, z -= deeper) {
    writer.rapid({x, 25}, 10).rapid({x, 25}, 1).feed({x, 25}, 0.05).feed({x + 4, 25}, z).feed({x + 4, 25}, 1);
  }
  return writer.done();
}

TEST(Entries, WaysDownBesideEachOtherIntoOneLayerCount) {
  for (const double apart : {2.0, 4.0, 8.0})
    for (const double deeper : {0.0, 0.01, -0.01}) {
      const Findings found = under_limit(square_part(), stepping_groove(apart, deeper));
      EXPECT_TRUE(has(found, FaultKind::kOverEngagement)) << apart << " " << deeper;
    }
  // Each beside what stays, or each below the last, is an entry of its own.
  const Findings apart = under_limit(square_part(), stepping_groove(14.2));
  EXPECT_FALSE(has(apart, FaultKind::kOverEngagement)) << report_of(apart);
  Writer deeper;
  deeper.enter({20, 25}, 0, 0.1);
  for (const double z : {-1.0, -2.0}) deeper.feed({24, 25}, z).feed({20, 25}).feed({24, 25}).feed({20, 25});
  const Findings below = under_limit(square_part(), deeper.done());
  EXPECT_FALSE(has(below, FaultKind::kOverEngagement)) << report_of(below);
}

TEST(Entries, RampsSinkNoFasterThanThePlungeFeed) {
  Part part = square_part();
  part.workplan[0].operation.cutting.plunge_feed = MmPerMin::of(150);
  const auto ramp = [](double feed) {
    Writer writer;
    writer.enter({20, 25}, 0, 0.1).feed({24, 25}, -1.85, feed).feed({28, 25}, -1.85);
    return writer.done();
  };
  EXPECT_TRUE(has(verify_program(part, ramp(500), {}), FaultKind::kPlungeTooFast));
  const Findings slow = verify_program(part, ramp(330), {});
  EXPECT_FALSE(has(slow, FaultKind::kPlungeTooFast)) << report_of(slow);
}

}  // namespace
}  // namespace clearcut::verify
