#include "stock/cutting_load.h"

#include <gtest/gtest.h>

#include <cmath>

namespace clearcut::stock {
namespace {

CutterEngagement contact_of(double from_deg, double to_deg) {
  const double from = from_deg * kPi / 180, to = to_deg * kPi / 180;
  return {AngleSet(from, to), to - from, 0, to - from};
}

TEST(CuttingLoad, BesideAStraightWallTheEngagementSaysAll) {
  for (const double angle : {5.0, 30.0, 60.0, 90.0, 120.0, 180.0}) {
    const CutterEngagement contact = contact_of(90 - angle, 90);
    for (const FeedBy by : {FeedBy::kChip, FeedBy::kRemoval})
      EXPECT_NEAR(load_at_feed_of_one(by, contact), load_at_feed_of_one(by, Radians::of_degrees(angle)),
                  1e-12);
  }
  EXPECT_NEAR(load_at_feed_of_one(FeedBy::kChip, Radians::of_degrees(30)), 0.5, 1e-12);
  EXPECT_NEAR(load_at_feed_of_one(FeedBy::kChip, Radians::of_degrees(120)), 1, 1e-12);
  EXPECT_NEAR(load_at_feed_of_one(FeedBy::kRemoval, Radians::of_degrees(60)), 0.5, 1e-12);
  EXPECT_NEAR(load_at_feed_of_one(FeedBy::kRemoval, Radians::of_degrees(180)), 2, 1e-12);
}

TEST(CuttingLoad, AheadTheChipIsAsThickAsTheFeed) {
  EXPECT_NEAR(load_at_feed_of_one(FeedBy::kChip, contact_of(-10, 10)), 1, 1e-12);
  EXPECT_NEAR(load_at_feed_of_one(FeedBy::kRemoval, contact_of(-30, 30)), 1, 1e-12);
}

/// Within a circular wall of radius p + R that the last pass left at p + R - w, the area taken for each mm of the centre is that of
/// the ring: w (p + R - w / 2) / p.
TEST(CuttingLoad, InsideAnArcTheLongerWallIsInTheContact) {
  const double cutter = 3, path = 4, width = 0.5;
  const double inner = path + cutter - width;
  const double edge = std::acos((inner * inner - path * path - cutter * cutter) / (2 * path * cutter));
  const CutterEngagement contact = contact_of(90 - edge * 180 / kPi, 90);
  EXPECT_NEAR(cutter * load_at_feed_of_one(FeedBy::kRemoval, contact),
              width * (path + cutter - width / 2) / path, 1e-9);
}

TEST(CuttingLoad, InTheAirThereIsNone) {
  EXPECT_EQ(load_at_feed_of_one(FeedBy::kChip, CutterEngagement{AngleSet(0, 0), 0, 0, 0}), 0);
}

}  // namespace
}  // namespace clearcut::stock
