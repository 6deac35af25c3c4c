// What `--op` makes of a solid's features.
#include "read/step_solid/asked_features.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "geometry/region.h"
#include "read/drawing/layer_rules.h"
#include "read/job/read_part.h"

namespace clearcut::read {
namespace {

using ::testing::HasSubstr;

constexpr double kBreak = 0.5;  // mm below the solid

Feature hole(double diameter, double floor, bool through) {
  Feature feature;
  feature.kind = FeatureKind::kRoundHole;
  feature.name = name_of(feature.kind);
  feature.hole_diameter = diameter;
  feature.target = feature.allowed = {disc_about({20, 20}, diameter / 2)};
  feature.floor_z = through ? floor - kBreak : floor;
  feature.through = through;
  return feature;
}

Feature window() {
  Feature feature;
  feature.name = name_of(feature.kind);
  feature.target = feature.allowed = {rectangular_region({{30, 10}, {50, 30}})};
  feature.floor_z = -10 - kBreak;
  feature.through = true;
  return feature;
}

std::vector<Feature> made(std::vector<Feature> features, const std::vector<std::string>& operations) {
  ReadOptions options;
  for (const std::string& text : operations) options.layer_rules.push_back(rule_of_option(text, "--op"));
  Diagnostics diagnostics;
  name_features(features);
  apply_operations(features, {{{0, 0}, {60, 40}}, -10, 0}, options, diagnostics);
  return features;
}

std::string refusal(std::vector<Feature> features, const std::string& operation) {
  try {
    made(std::move(features), {operation});
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
}

TEST(AskedFeatures, AThroughHoleIsTappedAndBringsItsOwnDrill) {
  const auto features = made({hole(5, -10, true)}, {"tap_m6_thru:round_hole*"});
  ASSERT_EQ(features.size(), 1u);
  ASSERT_TRUE(features[0].hole);
  EXPECT_EQ(features[0].hole->kind, HoleKind::kTapped);
  EXPECT_EQ(features[0].hole->thread->name, "M6");
  EXPECT_TRUE(features[0].through);
  EXPECT_EQ(*features[0].hole_diameter, 6);
}

TEST(AskedFeatures, ABlindHoleStaysUnderItsThread) {
  const auto features = made({hole(5, -8, false)}, {"tap_m6:1"});
  ASSERT_EQ(features.size(), 2u);
  EXPECT_FALSE(features[0].hole);
  ASSERT_TRUE(features[1].hole);
  EXPECT_NEAR(features[1].hole->full_z, -5, 1e-9) << "three pitches stay free for the tap's lead";
  EXPECT_THAT(refusal({hole(5, -8, false)}, "tap_m6_d6:round_hole"), HasSubstr("ask for at most 5 mm"));
}

TEST(AskedFeatures, WhatCannotBeIsRefusedWithWhatThereIs) {
  EXPECT_THAT(refusal({hole(5, -10, true)}, "tap_m6_thru:bore*"), HasSubstr("it has round_hole"));
  EXPECT_THAT(refusal({hole(12, -10, true)}, "tap_m6_thru:round_hole"), HasSubstr("it is 12 mm wide"));
  EXPECT_THAT(refusal({hole(5, -8, false)}, "tap_m6_thru:round_hole"), HasSubstr("has a floor at z -8"));
  EXPECT_THAT(refusal({window()}, "drill:closed_pocket"), HasSubstr("no round hole"));
  EXPECT_THAT(refusal({window()}, "engrave:closed_pocket"), HasSubstr("features of a solid are made so"));
  EXPECT_THAT(refusal({hole(5, -8, false)}, "inside:round_hole"), HasSubstr("does not go through"));
  EXPECT_THAT(refusal({hole(5, -10, true)}, "csk:round_hole"), HasSubstr("says no width"));
  EXPECT_THAT(refusal({hole(5, -10, true)}, "drill:3"), HasSubstr("numbers count them"));
}

TEST(AskedFeatures, AWindowIsCutOutAlongItsWall) {
  const auto features = made({window(), hole(5, -10, true)}, {"inside:closed_pocket", "ignore:round_hole"});
  ASSERT_EQ(features.size(), 1u);
  EXPECT_EQ(features[0].kind, FeatureKind::kInsideProfile);
  ASSERT_TRUE(features[0].profile);
  EXPECT_EQ(features[0].profile->side, ProfileSide::kInside);
  EXPECT_NEAR(features[0].profile->beyond, kBreak, 1e-9);
  EXPECT_NEAR(features[0].floor_z, -10 - kBreak, 1e-9);
}

TEST(AskedFeatures, AnEdgeIsBrokenAtTheTopOfAPocket) {
  const auto features = made({window()}, {"chamfer_d0.4:closed_pocket"});
  ASSERT_EQ(features.size(), 2u);
  EXPECT_FALSE(features[0].chamfer);
  ASSERT_TRUE(features[1].chamfer);
  EXPECT_NEAR(features[1].chamfer->depth, 0.4, 1e-12);
}

}  // namespace
}  // namespace clearcut::read
