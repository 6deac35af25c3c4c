// Drill files as several programs write them.
#include "read/board/excellon_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/elementary.h"
#include "base/error.h"
#include "base/units.h"
#include "geometry/region.h"

namespace clearcut::read {
namespace {

using ::testing::HasSubstr;

ReadOptions board() {
  ReadOptions options;
  options.depth = 1.6;
  return options;
}

Part read(const std::string& text) {
  return read_excellon(text, "b.drl", board());
}

Vec2 center_of(const Feature& feature) {
  return box(feature.target).center();
}

std::string refusal(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "not refused";
}

TEST(Excellon, DecimalsAreWhatTheySay) {
  const Part part =
      read("M48\n; by KiCad\nFMAT,2\nMETRIC\nT1C0.800\nT2C1.0\n%\nG90\nG05\nT1\nX25.0Y-15.5\nT2\nX1.\nM30\n");
  ASSERT_EQ(part.features.size(), 2U);
  EXPECT_EQ(part.features[0].name, "T1 0.8 mm");
  EXPECT_EQ(part.features[0].kind, FeatureKind::kRoundHole);
  EXPECT_TRUE(part.features[0].through);
  EXPECT_NEAR(*part.features[0].hole_diameter, 0.8, 1e-9);
  EXPECT_NEAR(center_of(part.features[0]).y, -15.5, 1e-9);
  // What is left out stays.
  EXPECT_NEAR(center_of(part.features[1]).x, 1, 1e-9);
  EXPECT_NEAR(center_of(part.features[1]).y, -15.5, 1e-9);
}

TEST(Excellon, ZerosAreLeftOutAtEitherEnd) {
  const auto x_of = [](const std::string& head, const std::string& x) {
    return center_of(read("M48\n" + head + "\nT1C0.04\n%\nT1\nX" + x + "Y0\nM30\n").features.front()).x;
  };
  EXPECT_NEAR(x_of("METRIC,TZ", "12500"), 12.5, 1e-9);
  EXPECT_NEAR(x_of("METRIC,LZ", "0125"), 12.5, 1e-9);
  EXPECT_NEAR(x_of("INCH,TZ", "12500"), 31.75, 1e-9);
  EXPECT_NEAR(x_of("INCH,LZ", "0125"), 31.75, 1e-9);
  EXPECT_NEAR(x_of("METRIC,TZ,0000.00", "1250"), 12.5, 1e-9);
  EXPECT_NEAR(x_of(";FILE_FORMAT=4:4\nMETRIC,TZ", "125000"), 12.5, 1e-9);
  EXPECT_NEAR(x_of("M72\nFMAT,2", "12500"), 31.75, 1e-9);
}

TEST(Excellon, SaysWhatItAssumes) {
  const Part part = read("M48\nMETRIC\nT1C1\n%\nT1\nX12500Y0\nM30\n");
  ASSERT_FALSE(part.diagnostics.items().empty());
  EXPECT_THAT(part.diagnostics.items().front().what, HasSubstr("3 digits after the point assumed"));
}

TEST(Excellon, SlotsAreAsWideAsTheirTool) {
  const double slot = 3 * 1 + kPi / 4;
  const Part canned = read("M48\nMETRIC\nT2C1.0\n%\nT2\nX30.0Y-18.0G85X33.0Y-18.0\nM30\n");
  ASSERT_EQ(canned.features.size(), 1U);
  EXPECT_NEAR(area(canned.features[0].target), slot, 1e-9);
  const Part routed = read(
      "M48\nMETRIC\nT2C1.0\n%\nT2\nG00X30.0Y-18.0\nM15\nG01X31.5Y-18.0\nG01X33.0Y-18.0\nM16\nG05\nX0.0Y0."
      "0\nM30\n");
  ASSERT_EQ(routed.features.size(), 2U);
  const Feature& feature =
      routed.features[0].kind == FeatureKind::kRoundHole ? routed.features[1] : routed.features[0];
  EXPECT_NEAR(area(feature.target), slot, 1e-6);
  EXPECT_NEAR(center_of(feature).x, 31.5, 1e-9);
}

/// The only slot that these lines of a body make with a tool of 1 mm.
Feature slot_of(const std::string& body) {
  const Part part = read("M48\nMETRIC\nT2C1.0\n%\nT2\n" + body + "T0\nM30\n");
  EXPECT_EQ(part.features.size(), 1U);
  EXPECT_EQ(part.features.front().name, "T2 1 mm slot");
  return part.features.front();
}

TEST(Excellon, RoutedArcsAreArcs) {
  const double quarter = kPi / 2 * 4, ends = kPi / 4;
  const Feature ccw = slot_of("G00X4.0Y0.0\nM15\nG03X0.0Y4.0A4.0\nM16\n");
  EXPECT_NEAR(area(ccw.target), quarter + ends, 1e-6);
  EXPECT_NEAR(box(ccw.target).max.x, 4.5, 1e-6) << "about the origin";
  const Feature clockwise = slot_of("G00X4.0Y0.0\nM15\nG02X0.0Y4.0A4.0\nM16\n");
  EXPECT_NEAR(box(clockwise.target).min.x, -0.5, 1e-6) << "about (4, 4)";
  EXPECT_NEAR(area(clockwise.target), quarter + ends, 1e-6);
  const Feature ring = slot_of("G00X4.0Y0.0\nM15\nG03X4.0Y0.0I-4.0J0.0\nM17\n");
  EXPECT_NEAR(area(ring.target), 2 * kPi * 4, 1e-6);
  const Feature both = slot_of("G00X0.0Y0.0\nM15\nG01X5.0\nG02X9.0Y-4.0A4.0\nG01Y-9.0\nM16\n");
  EXPECT_NEAR(area(both.target), 5 + quarter + 5 + ends, 1e-6);
}

TEST(Excellon, RoutesNeedNotSayThatTheToolIsDown) {
  EXPECT_NEAR(area(slot_of("G00X0.0Y0.0\nG01X5.0\n").target), 5 + kPi / 4, 1e-6);
  EXPECT_NEAR(area(slot_of("G00X0.0Y0.0\nM15\nG01X5.0\nM16\nG01X9.0\n").target), 5 + kPi / 4, 1e-6);
  EXPECT_THAT(refusal("M48\nMETRIC\nT1C1\n%\nT1\nG01X1.0Y1.0\nX3.0\nM30\n"), HasSubstr("holes or slots"));
}

TEST(Excellon, HolesThatOverlapAreSlots) {
  const double lens = 2 * base::acos(0.8) * 0.25 - 0.8 * std::sqrt(0.25 - 0.16);  // of circles 0.8 mm apart
  EXPECT_NEAR(area(slot_of("X0.0Y0.0\nX0.8\n").target), kPi / 2 - lens, 1e-6);
  EXPECT_NEAR(area(slot_of("X0.0Y0.0G85X5.0Y0.0\nX0.0Y0.0\nX5.0Y0.0\n").target), 5 + kPi / 4, 1e-6);
  const Part part = read(
      "M48\nMETRIC\nT1C1\nT2C3\n%\nT1\nX0.0Y0.0\nX0.0Y0.001\nX1.0\nX2.0Y4.0\nT2\nX0.0Y4.0G85X5.0Y4.0\nM30\n");
  ASSERT_EQ(part.features.size(), 3U) << "two that touch, and a slot that takes one away";
  EXPECT_EQ(std::count_if(part.features.begin(), part.features.end(),
                          [](const Feature& feature) { return feature.kind == FeatureKind::kRoundHole; }),
            2);
}

TEST(Excellon, RepeatsAndIncrements) {
  const Part part = read("M48\nMETRIC,TZ\nT1C0.5\n%\nT1\nX1.0Y1.0\nR3X2.0Y0\nG91\nX0.0Y5.0\nM30\n");
  ASSERT_EQ(part.features.size(), 5U);
  Box all;
  for (const Feature& feature : part.features) all.add(center_of(feature));
  EXPECT_NEAR(all.max.x, 7, 1e-9);
  EXPECT_NEAR(all.max.y, 6, 1e-9);
}

TEST(Excellon, DamageIsRefusedWithItsPlace) {
  EXPECT_THAT(refusal("M48\nMETRIC\nT1C1\n%\nT1\nX1.0Y1.0\n"), HasSubstr("cut short"));
  EXPECT_THAT(refusal("M48\nMETRIC\n%\nT3\nX1.0Y1.0\nM30\n"), HasSubstr("T3 has no diameter"));
  EXPECT_THAT(refusal("M48\nT1C1\n%\nT1\nX1.0Y1.0\nM30\n"), HasSubstr("unit"));
  EXPECT_THAT(refusal("M48\nMETRIC\nT1C1\n%\nT1\nG02X1.0Y1.0Q5\nM30\n"), HasSubstr("b.drl:6: "));
  EXPECT_THAT(refusal("M48\nMETRIC\nT1C1\n%\nG93X1.0Y0\nT1\nX1.0Y1.0\nM30\n"), HasSubstr("G93"));
  EXPECT_THAT(refusal("M48\nMETRIC\nT1C-1\n%\nM30\n"), HasSubstr("not understood"));
  EXPECT_THAT(refusal("M48\nMETRIC\nT1C1\n%\nT55555555555555555555\nM30\n"), HasSubstr("not understood"));
}

TEST(Excellon, LinesMayEndInCarriageReturnsAlone) {
  const Part part = read("M48\rMETRIC\rT1C0.8\r%\rT1\rX25.0Y-15.5\rX1.0Y1.0\rM30\r");
  EXPECT_EQ(part.features.size(), 2U);
}

}  // namespace
}  // namespace clearcut::read
