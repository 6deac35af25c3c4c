// Boundaries of hatches and solids: their areas by formula, and when they are outlines.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "base/units.h"
#include "read/dxf/dxf_reader.h"

namespace clearcut::read {
namespace {

std::string groups(std::string words) {
  std::replace(words.begin(), words.end(), ' ', '\n');
  return words + "\n";
}

std::string drawing(const std::string& entities, const std::string& blocks = {}) {
  return groups("0 SECTION 2 HEADER 9 $INSUNITS 70 4 0 ENDSEC") +
         groups("0 SECTION 2 BLOCKS" + blocks + " 0 ENDSEC") +
         groups("0 SECTION 2 ENTITIES" + entities + " 0 ENDSEC 0 EOF");
}

const std::string kHatch = " 0 HATCH 8 D5 10 0 20 0 30 0 210 0 220 0 230 1 2 SOLID 70 1 71 0";
const std::string kEnd = " 97 0 75 1 76 1 98 1 10 3 20 3";
/// A square of 10 mm as a polyline, at x and y.
std::string square(const std::string& x, const std::string& y, const std::string& far_x,
                   const std::string& far_y) {
  return " 92 3 72 0 73 1 93 4 10 " + x + " 20 " + y + " 10 " + far_x + " 20 " + y + " 10 " + far_x + " 20 " +
         far_y + " 10 " + x + " 20 " + far_y;
}
const std::string kSquare = square("0", "0", "10", "10");
const std::string kLines = " 0 LWPOLYLINE 8 D2 90 4 70 1 10 50 20 0 10 60 20 0 10 60 20 10 10 50 20 10";

Part read(const std::string& text, ReadOptions options = {}) {
  return read_dxf(text, "hatched.dxf", options);
}

/// Layer D5 is a pocket, so that its fills are outlines.
ReadOptions fills_asked() {
  ReadOptions asked;
  LayerRule rule;
  rule.pattern = "D5";
  rule.role = LayerRole::kPocket;
  asked.layer_rules.push_back(rule);
  return asked;
}

double area_of(const Part& part) {
  double sum = 0;
  for (const Feature& feature : part.features) sum += area(feature.target);
  return sum;
}

std::string left_out(const Part& part) {
  std::string text;
  for (const Diagnostic& item : part.diagnostics.items())
    if (item.severity == Severity::kSkipped) text += item.what + "\n";
  return text;
}

TEST(DxfFill, APathOfVerticesMayHaveBulgesAndAHoleIsAnIsland) {
  EXPECT_NEAR(area_of(read(drawing(kHatch + " 91 1" + kSquare + kEnd))), 100, 1e-9);
  EXPECT_NEAR(
      area_of(read(drawing(kHatch + " 91 2" + kSquare + " 97 0" + square("2", "2", "6", "5") + kEnd))),
      100 - 12, 1e-9);
  const std::string disc = " 92 3 72 1 73 1 93 2 10 0 20 0 42 1 10 8 20 0 42 1";
  EXPECT_NEAR(area_of(read(drawing(kHatch + " 91 1" + disc + kEnd))), 16 * kPi, 1e-6);
}

/// Squares of 10, 6 and 2 mm within each other: all count in the normal style, the outer two in style 1, the outermost in 2.
TEST(DxfFill, TheStyleSaysWhichBoundariesCount) {
  const std::string nested =
      " 91 3" + square("4", "4", "6", "6") + " 97 0" + kSquare + " 97 0" + square("2", "2", "8", "8");
  const auto area_in_style = [&](const std::string& style) {
    return area_of(read(drawing(kHatch + nested + " 97 0 75 " + style + " 76 1 98 0")));
  };
  EXPECT_NEAR(area_in_style("0"), 100 - 36 + 4, 1e-9);
  EXPECT_NEAR(area_in_style("1"), 100 - 36, 1e-9);
  EXPECT_NEAR(area_in_style("2"), 100, 1e-9);
}

/// A slot: two lines and two half circles, the second one written clockwise, which mirrors its angles.
TEST(DxfFill, APathOfEdgesMayRunEitherWay) {
  const std::string slot =
      " 92 1 93 4 72 1 10 0 20 0 11 20 21 0 72 2 10 20 20 4 40 4 50 270 51 90 73 1 72 1 10 0 20 8 11 20 21 8"
      " 72 2 10 0 20 4 40 4 50 90 51 270 73 0";
  EXPECT_NEAR(area_of(read(drawing(kHatch + " 91 1" + slot + kEnd))), 20 * 8 + 16 * kPi, 1e-6);
  const std::string circle = " 92 1 93 1 72 2 10 5 20 5 40 3 50 0 51 360 73 0";
  EXPECT_NEAR(area_of(read(drawing(kHatch + " 91 1" + circle + kEnd))), 9 * kPi, 1e-6);
}

/// Ends of elliptical edges are angles seen from the centre. From 0 to 45 degrees of an ellipse of 10 by 5 mm to its centre: the
/// area up to parameter t is a b t / 2 with tan t = 2 tan 45 degrees.
TEST(DxfFill, EllipticalEdgesEndWhereTheyAreSeen) {
  const double t = std::atan(2.0), x = 10 * std::cos(t), y = 5 * std::sin(t);
  const std::string sector =
      " 92 1 93 3 72 1 10 0 20 0 11 10 21 0 72 3 10 0 20 0 11 10 21 0 40 0.5 50 0 51 45 73 1 72 1 10 " +
      std::to_string(x) + " 20 " + std::to_string(y) + " 11 0 21 0";
  EXPECT_NEAR(area_of(read(drawing(kHatch + " 91 1" + sector + kEnd))), 10 * 5 * t / 2, 0.01);
  const std::string whole = " 92 1 93 1 72 3 10 0 20 0 11 0 21 8 40 0.25 50 0 51 360 73 0";
  EXPECT_NEAR(area_of(read(drawing(kHatch + " 91 1" + whole + kEnd))), 16 * kPi, 0.05);
}

/// A parabola as a spline of degree 2 over its chord: two thirds of the box around it.
TEST(DxfFill, SplinesBoundHatches) {
  const std::string dome =
      " 92 1 93 2 72 4 94 2 73 0 74 0 95 6 96 3 40 0 40 0 40 0 40 1 40 1 40 1 10 0 20 0 10 6 20 8 10 12 20 0"
      " 72 1 10 12 20 0 11 0 21 0";
  EXPECT_NEAR(area_of(read(drawing(kHatch + " 91 1" + dome + kEnd))), 12 * 4 * 2.0 / 3, 0.02);
}

TEST(DxfFill, SolidsHaveTheirThirdAndFourthCornerTheOtherWayRound) {
  const std::string solid = " 0 SOLID 8 D5 10 0 20 0 11 10 21 0 12 0 22 6 13 10 23 6";
  EXPECT_NEAR(area_of(read(drawing(solid))), 60, 1e-9);
  const std::string triangle = " 0 TRACE 8 D5 10 0 20 0 11 10 21 0 12 10 22 6 13 10 23 6";
  EXPECT_NEAR(area_of(read(drawing(triangle))), 30, 1e-9);
}

TEST(DxfFill, BlocksPutThemInPlaceAndTurnTheirSize) {
  const std::string block = " 0 BLOCK 2 B 10 0 20 0" + kHatch + " 91 1" + kSquare + kEnd + " 0 ENDBLK";
  const Part part = read(drawing(" 0 INSERT 8 D5 2 B 10 100 20 0 41 2 42 -2", block));
  EXPECT_NEAR(area_of(part), 400, 1e-9);
  EXPECT_NEAR(box(part.features.at(0).target).min.x, 100, 1e-9);
  EXPECT_NEAR(box(part.features.at(0).target).min.y, -20, 1e-9);
}

TEST(DxfFill, WhatLiesBesideLinesOfItsLayerIsDecoration) {
  const Part part = read(drawing(" 0 CIRCLE 8 D5 10 5 20 5 40 2" + kHatch + " 91 1" + kSquare + kEnd));
  EXPECT_NEAR(area_of(part), 4 * kPi, 1e-6);
  EXPECT_THAT(left_out(part), testing::HasSubstr("no outlines: 1 HATCH on layer D5"));
}

/// Beside lines of a layer with a stated role.
TEST(DxfFill, WhatNoLinesBoundMayBePartOfTheWork) {
  const auto open_conditions = [](const std::string& lines) {
    const Part part = read(drawing(lines + kHatch + " 91 1" + kSquare + kEnd), fills_asked());
    return std::count_if(part.diagnostics.items().begin(), part.diagnostics.items().end(),
                         [](const Diagnostic& item) { return item.condition == "left-out"; });
  };
  const std::string elsewhere = " 0 CIRCLE 8 D5 10 50 20 5 40 2";
  EXPECT_EQ(open_conditions(elsewhere), 1);
  const std::string around = " 0 LWPOLYLINE 8 D7 90 4 70 1 10 0 20 0 10 10 20 0 10 10 20 10 10 0 20 10";
  EXPECT_EQ(open_conditions(elsewhere + around), 0);
}

TEST(DxfFill, BesideLinesOfOtherLayersSomebodyHasToAsk) {
  const std::string text = drawing(kLines + kHatch + " 91 1" + kSquare + kEnd);
  const Part part = read(text);
  EXPECT_NEAR(area_of(part), 100, 1e-9);
  EXPECT_THAT(left_out(part),
              testing::HasSubstr("--op pocket:LAYER reads the boundaries of fills): 1 HATCH on layer D5"));
  EXPECT_NEAR(area_of(read(text, fills_asked())), 200, 1e-9);
  EXPECT_EQ(left_out(read(text, fills_asked())), "");
}

TEST(DxfFill, DamageInDecorationRefusesNoDrawing) {
  const std::string damaged = kHatch + " 91 1 92 1 93 1 72 9 10 0 20 0" + kEnd;
  EXPECT_THAT(left_out(read(drawing(kLines + damaged))), testing::HasSubstr("1 HATCH on layer D5"));
  EXPECT_THROW(read(drawing(kLines + damaged), fills_asked()), InputError);
}

TEST(DxfFill, FewerPathsThanTheFileCountsAreNotRead) {
  const Part part = read(drawing(kLines + kHatch + " 91 3" + kSquare + kEnd), fills_asked());
  EXPECT_NEAR(area_of(part), 100, 1e-9);
  EXPECT_THAT(left_out(part), testing::HasSubstr("1 HATCH without boundary on layer D5"));
}

}  // namespace
}  // namespace clearcut::read
