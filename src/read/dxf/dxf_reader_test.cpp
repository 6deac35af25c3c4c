#include "read/dxf/dxf_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "base/units.h"
#include "read/drawing/drawing.h"
#include "read/drawing/layer_rules.h"
#include "read/job/read_part.h"

namespace clearcut::read {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// "0 LINE 8 0 10 1.5 ..." as groups, one code and one value a line.
std::string groups(const std::string& words) {
  std::string out = words;
  std::replace(out.begin(), out.end(), ' ', '\n');
  return out + "\n";
}

std::string dxf(const std::string& entities, const std::string& blocks = "", int insunits = 4,
                const std::string& layers = "") {
  return groups("0 SECTION 2 HEADER 9 $INSUNITS 70 " + std::to_string(insunits) + " 0 ENDSEC") +
         groups("0 SECTION 2 TABLES" + layers + " 0 ENDSEC") +
         groups("0 SECTION 2 BLOCKS" + blocks + " 0 ENDSEC") +
         groups("0 SECTION 2 ENTITIES" + entities + " 0 ENDSEC 0 EOF");
}

const std::string kSquare = " 0 LWPOLYLINE 8 D5 90 4 70 1 10 0 20 0 10 10 20 0 10 10 20 10 10 0 20 10";
const std::string kCircle = " 0 CIRCLE 8 D5 10 5 20 5 40 2";

Part read(const std::string& text, const ReadOptions& options = {}) {
  return read_dxf(text, "plate.dxf", options);
}

double all_area(const Part& part) {
  double sum = 0;
  for (const Feature& feature : part.features) sum += area(feature.target);
  return sum;
}

int said(const Part& part, Severity severity, const std::string& text) {
  return static_cast<int>(std::count_if(
      part.diagnostics.items().begin(), part.diagnostics.items().end(),
      [&](const Diagnostic& d) { return d.severity == severity && d.what.find(text) != std::string::npos; }));
}

std::string refusal(const std::string& text, const ReadOptions& options = {}) {
  try {
    read(text, options);
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "not refused";
}

TEST(Dxf, PolylineWithIslandOnALayerWithDepth) {
  const Part part = read(dxf(kSquare + kCircle));
  ASSERT_EQ(part.features.size(), 1u);
  EXPECT_EQ(part.features[0].name, "D5");
  EXPECT_NEAR(all_area(part), 100 - 4 * kPi, 1e-9);
  EXPECT_DOUBLE_EQ(part.features[0].floor_z, -5);
  EXPECT_TRUE(part.diagnostics.items().empty());
}

TEST(Dxf, BulgesAboveOneAndNegativeOnes) {
  // Three quarters of a circle of radius 5 and the corner it leaves open; then a dent.
  const double three_quarters = 1 + std::sqrt(2.0);
  const Part part = read(
      dxf(" 0 LWPOLYLINE 8 D1 70 1 10 5 20 0 42 " + std::to_string(three_quarters) +
          " 10 0 20 -5 42 0 0 LWPOLYLINE 8 D1 70 1 10 20 20 0 10 40 20 0 42 -1 10 40 20 10 10 20 20 10"));
  EXPECT_NEAR(all_area(part), 0.75 * 25 * kPi + 12.5 + 200 - 12.5 * kPi, 1e-4);
}

TEST(Dxf, LooseLinesAndArcsAreChained) {
  const Part part =
      read(dxf(" 0 LINE 8 D1 10 0 20 0 11 20 21 0 0 ARC 8 D1 10 20 20 5 40 5 50 270 51 90"
               " 0 LINE 8 D1 10 0 20 10 11 20 21 10 0 ARC 8 D1 10 0 20 5 40 5 50 90 51 270"));
  EXPECT_NEAR(all_area(part), 200 + 25 * kPi, 1e-9);
}

TEST(Dxf, EllipseAndSpline) {
  const Part ellipse = read(dxf(" 0 ELLIPSE 8 D1 10 0 20 0 11 30 21 0 40 0.5 41 0 42 6.283185307179586"));
  EXPECT_NEAR(all_area(ellipse), kPi * 30 * 15, 0.002 * 150);
  // A full circle of radius 10 as a rational quadratic spline of nine points.
  const std::string w = "0.7071067811865476";
  const Part circle = read(
      dxf(" 0 SPLINE 8 D1 70 4 71 2 72 12 73 9 40 0 40 0 40 0 40 1 40 1 40 2 40 2 40 3 40 3 40 4 40 4 40 4"
          " 41 1 41 " +
          w + " 41 1 41 " + w + " 41 1 41 " + w + " 41 1 41 " + w +
          " 41 1"
          " 10 10 20 0 10 10 20 10 10 0 20 10 10 -10 20 10 10 -10 20 0 10 -10 20 -10 10 0 20 -10"
          " 10 10 20 -10 10 10 20 0"));
  EXPECT_NEAR(all_area(circle), 100 * kPi, 0.002 * 63);
}

TEST(Dxf, SplineThroughFitPointsAlone) {
  std::string points;
  for (int i = 0; i < 32; ++i) {
    const Vec2 p = direction_of(2 * kPi * i / 32) * 20;
    points += " 11 " + std::to_string(p.x) + " 21 " + std::to_string(p.y) + " 31 0";
  }
  const Part circle = read(dxf(" 0 SPLINE 8 D1 70 11 71 3 72 0 73 0 74 32" + points));
  EXPECT_NEAR(all_area(circle), 400 * kPi, 0.002 * 126);
  // Half a circle by its ends' tangents, and the line between its ends.
  const Part half = read(dxf(
      " 0 SPLINE 8 D1 70 8 71 3 74 3 12 0 22 1 32 0 13 0 23 -1 33 0 11 -5 21 0 31 0 11 0 21 5 31 0 11 5 21 0"
      " 0 LINE 8 D1 10 5 20 0 11 -5 21 0"));
  EXPECT_NEAR(all_area(half), 12.5 * kPi, 2);
  EXPECT_NEAR(box(half.features[0].target).max.y, 5, 0.002);
}

TEST(Dxf, TextsOfBlocksAreSaidByTheirLayer) {
  const Part part = read(
      dxf(kSquare + " 0 INSERT 8 D5 66 1 2 B 10 5 20 5 0 ATTRIB 8 LABELS 1 x 0 ATTRIB 8 LABELS 1 y 0 SEQEND",
          " 0 BLOCK 2 B 10 0 20 0 0 CIRCLE 8 0 10 0 20 0 40 2 0 MTEXT 8 NOTES 1 x 0 ENDBLK"));
  EXPECT_EQ(said(part, Severity::kSkipped, "2 ATTRIB on layer LABELS, 1 MTEXT on layer NOTES"), 1);
}

TEST(Dxf, OldPolylineWithBulgesAndSequenceEnd) {
  const Part part = read(
      dxf(" 0 POLYLINE 8 D1 66 1 70 1 0 VERTEX 8 D1 10 0 20 0 42 1 0 VERTEX 8 D1 10 10 20 0 42 1 0 SEQEND"));
  EXPECT_NEAR(all_area(part), 25 * kPi, 1e-9);
}

TEST(Dxf, BlocksAreScaledTurnedMirroredRepeatedAndNested) {
  const std::string unit_square = " 0 LWPOLYLINE 8 0 70 1 10 0 20 0 10 2 20 0 10 2 20 1 42 0.5 10 0 20 1";
  const std::string blocks =
      " 0 BLOCK 2 inner 10 1 20 1" + unit_square + " 0 ENDBLK" +
      " 0 BLOCK 2 OUTER 10 0 20 0 0 INSERT 8 0 2 INNER 10 5 20 5 41 -1 42 1 50 90 0 ENDBLK";
  const double one = all_area(read(dxf(" 0 INSERT 8 D3 2 INNER 10 0 20 0", blocks)));
  const Part part =
      read(dxf(" 0 INSERT 8 D3 2 OUTER 10 100 20 0 41 3 42 3 50 30 70 3 71 2 44 10 45 20", blocks));
  EXPECT_EQ(part.features.size(), 6u);
  EXPECT_NEAR(all_area(part), 6 * 9 * one, 1e-9);
  EXPECT_DOUBLE_EQ(part.features[0].floor_z, -3);  // layer 0 in a block is the layer of the INSERT
  const Part stretched = read(dxf(" 0 INSERT 8 D3 2 INNER 10 0 20 0 41 2 42 1", blocks));
  EXPECT_NEAR(all_area(stretched), 2 * one, 0.02);
}

TEST(Dxf, ExtrusionDownMirrors) {
  const Part part = read(dxf(" 0 CIRCLE 8 D1 10 -20 20 5 40 3 210 0 220 0 230 -1"));
  EXPECT_NEAR(box(part.features[0].target).center().x, 20, 1e-12);
}

TEST(Dxf, UnitsComeFromTheFileTheOptionOrAreAssumedAloud) {
  EXPECT_NEAR(all_area(read(dxf(kSquare, "", 1))), 100 * 25.4 * 25.4, 1e-6);
  EXPECT_NEAR(read(dxf(kSquare, "", 1)).features[0].floor_z, -5 * 25.4, 1e-9);
  ReadOptions cm;
  cm.unit = "cm";
  EXPECT_NEAR(all_area(read(dxf(kSquare, "", 1), cm)), 10000, 1e-6);
  const Part assumed = read(dxf(kSquare, "", 0));
  EXPECT_NEAR(all_area(assumed), 100, 1e-9);
  EXPECT_EQ(said(assumed, Severity::kWarning, "millimetres assumed; the drawing is 10 x 10 mm"), 1);
}

TEST(Dxf, LayersAreChosenByPatternAndTheOthersCounted) {
  ReadOptions options;
  options.layers = {"pocket*"};
  const std::string other = " 0 CIRCLE 8 FRAME 10 5 20 5 40 99 0 CIRCLE 8 POCKET_D2 10 5 20 5 40 3";
  const Part part = read(dxf(kSquare + other), options);
  ASSERT_EQ(part.features.size(), 1u);
  EXPECT_EQ(part.features[0].name, "POCKET_D2");
  EXPECT_EQ(said(part, Severity::kSkipped, "layers were not chosen: 1 D5, 1 FRAME"), 1);
}

TEST(Dxf, LayerNamesSayDepthTopAndRole) {
  const Part part =
      read(dxf(" 0 LWPOLYLINE 8 POCKET-TOP-2_D3.5 70 1 10 0 20 0 10 90 20 0 10 90 20 90 10 0 20 90"
               " 0 CIRCLE 8 ISLANDS 10 50 20 50 40 10 0 CIRCLE 8 HOLES_D8 10 20 20 20 40 3"
               " 0 CIRCLE 8 construction 10 20 20 20 40 30"));
  ASSERT_EQ(part.features.size(), 2u);
  EXPECT_NEAR(area(part.features[0].target), 8100 - 100 * kPi, 1e-3);
  EXPECT_DOUBLE_EQ(part.features[0].floor_z, -5.5);
  EXPECT_EQ(part.features[1].kind, FeatureKind::kRoundHole);
  EXPECT_DOUBLE_EQ(*part.features[1].hole_diameter, 6);
  EXPECT_EQ(part.workplan[1].operation.kind, OperationKind::kDrilling);
  EXPECT_EQ(said(part, Severity::kSkipped, "1 construction"), 1);
}

TEST(Dxf, ADeeperPocketInAShallowOneStartsOnItsFloor) {
  const Part part = read(dxf(" 0 CIRCLE 8 D6 10 5 20 5 40 2" + kSquare));
  ASSERT_EQ(part.features.size(), 2u);
  EXPECT_EQ(part.features[0].name, "D5");  // shallow first
  EXPECT_DOUBLE_EQ(part.features[1].top_z, -5);
  EXPECT_DOUBLE_EQ(part.features[1].floor_z, -6);
}

TEST(Dxf, RulesGoBeforeNamesAndTheDepthOptionBeforeAll) {
  ReadOptions options;
  options.layer_rules = {{"D5", std::nullopt, 7.0, -1.0}};
  EXPECT_DOUBLE_EQ(read(dxf(kSquare), options).features[0].floor_z, -8);
  options.depth = 1;
  EXPECT_DOUBLE_EQ(read(dxf(kSquare), options).features[0].floor_z, -2);
}

TEST(Dxf, AMissingDepthIsRefusedOrAssumedWhenAsked) {
  const std::string circle = dxf(" 0 CIRCLE 8 0 10 5 20 5 40 2");
  EXPECT_THAT(refusal(circle), StartsWith("plate.dxf: layer 0: no depth given"));
  ReadOptions options;
  options.depth_if_missing = 1;
  EXPECT_EQ(said(read(circle, options), Severity::kWarning, "1 mm assumed"), 1);
}

TEST(Dxf, HiddenAndPaperEntitiesAreNotMilledButCounted) {
  const Part part =
      read(dxf(kSquare + " 0 CIRCLE 8 OFF 10 5 20 5 40 2 0 CIRCLE 8 FROZEN 10 5 20 5 40 2"
                         " 0 CIRCLE 8 D5 67 1 10 5 20 5 40 2 0 TEXT 8 D5 1 x 0 TEXT 8 D5 1 y 0 HATCH 8 D5",
               "", 4, " 0 LAYER 2 OFF 62 -7 70 0 0 LAYER 2 FROZEN 62 7 70 1"));
  EXPECT_NEAR(all_area(part), 100, 1e-9);
  EXPECT_EQ(said(part, Severity::kSkipped, "1 FROZEN, 1 OFF"), 1);
  EXPECT_EQ(said(part, Severity::kSkipped, "1 CIRCLE of the paper layout on layer D5, 1 HATCH on layer D5"),
            1);
  EXPECT_EQ(said(part, Severity::kSkipped, "(--text outlines draws them): 2 TEXT on layer D5"), 1);
}

TEST(Dxf, LayersThatAreNotPlottedAreReadAndNamed) {
  const Part part = read(dxf(kSquare + " 0 CIRCLE 8 D3 10 50 20 0 40 2", "", 4,
                             " 0 LAYER 2 d5 62 7 70 0 290 0 0 LAYER 2 D3 62 7 70 0 290 1"));
  EXPECT_EQ(part.features.size(), 2u);
  EXPECT_EQ(said(part, Severity::kNote, "not plotted: the layer(s) D5 (--op"), 1);
}

TEST(Dxf, CurvesWithoutLengthAreLeftOutAndCounted) {
  const Part part = read(dxf(kSquare + " 0 CIRCLE 8 D5 10 5 20 5 40 0 0 ARC 8 D5 10 5 20 5 40 0 50 0 51 90"));
  EXPECT_NEAR(all_area(part), 100, 1e-9);
  EXPECT_EQ(
      said(part, Severity::kSkipped, "1 ARC without length on layer D5, 1 CIRCLE without length on layer D5"),
      1);
}

TEST(Dxf, BadFilesGiveOneLineSayingWhere) {
  EXPECT_THAT(refusal(""), HasSubstr("no ENTITIES section"));
  EXPECT_THAT(refusal("hello\nworld\n"), StartsWith("plate.dxf:1: a DXF group code was expected"));
  EXPECT_THAT(refusal(std::string("AutoCAD Binary DXF\r\n\x1a\0", 22)), HasSubstr("binary DXF; save"));
  EXPECT_THAT(refusal("0\nSECTION\n2"), HasSubstr("ends in the middle"));
  EXPECT_THAT(refusal(dxf(" 0 CIRCLE 8 D1 10 x 20 5 40 2")), HasSubstr("'x' is not a number"));
  EXPECT_THAT(refusal(dxf(" 0 CIRCLE 8 D1 10 nan 20 5 40 2")), HasSubstr("'nan' is not a number"));
  EXPECT_THAT(refusal(dxf(" 0 CIRCLE 8 D1 10 1 20 5")), HasSubstr("CIRCLE lacks its group 40"));
  EXPECT_THAT(refusal(dxf(" 0 CIRCLE 8 D1 10 1 20 5 40 -2")), HasSubstr("radius below 0"));
  EXPECT_THAT(refusal(dxf(" 0 SPLINE 8 D1 71 3 40 0 40 1 10 0 20 0 10 1 20 1")),
              HasSubstr("2 knots for 2 control"));
  EXPECT_THAT(refusal(dxf(" 0 INSERT 8 D1 2 NOWHERE 10 0 20 0")),
              HasSubstr("'NOWHERE', which the file does not define"));
  EXPECT_THAT(
      refusal(dxf(" 0 INSERT 8 D1 2 A 10 0 20 0", " 0 BLOCK 2 A 10 0 20 0 0 INSERT 2 A 10 1 20 0 0 ENDBLK")),
      HasSubstr("may contain itself"));
  EXPECT_THAT(refusal(dxf(" 0 LINE 8 D1 10 0 20 0 11 5 21 0")), HasSubstr("the outline is open at"));
  EXPECT_THAT(refusal(dxf(" 0 TEXT 8 D1 1 hi")), HasSubstr("nothing to mill was found (not read"));
  EXPECT_THAT(refusal(dxf(kSquare),
                      [] {
                        ReadOptions o;
                        o.unit = "parsec";
                        return o;
                      }()),
              HasSubstr("unknown unit"));
}

TEST(Dxf, RareUnitsAreUnitsToo) {
  const std::string dot = " 0 CIRCLE 8 D1 10 0 20 0 40 1";
  for (const auto& [code, mm] :
       {std::pair(21, 1200.0 / 3937 * 1000), std::pair(15, 1e4), std::pair(3, 1609344.0)}) {
    ReadOptions tiny;
    tiny.scale = 1e-4;
    const Part part = read(dxf(dot, "", code), tiny);
    EXPECT_NEAR(box(part.features[0].target).width(), 2e-4 * mm, 1e-9 * mm) << code;
    EXPECT_EQ(said(part, Severity::kWarning, "names no unit"), 0);
  }
}

TEST(Dxf, OutlinesAtSeveralHeightsAreSaid) {
  const auto heights = [](const std::string& entities) {
    return said(read(dxf(entities)), Severity::kWarning, "at heights from -5 to 0 mm");
  };
  EXPECT_EQ(heights(kSquare + " 0 CIRCLE 8 D5 10 5 20 5 30 -5 40 2"), 1);
  EXPECT_EQ(heights(kSquare + " 0 CIRCLE 8 D5 10 -5 20 5 30 5 40 2 230 -1"), 1);
  EXPECT_EQ(heights(kSquare + " 0 LWPOLYLINE 8 D5 38 -5 70 1 10 3 20 3 10 5 20 3 10 4 20 5"), 1);
  EXPECT_EQ(heights(kSquare + kCircle), 0);
  EXPECT_EQ(said(read(dxf(" 0 CIRCLE 8 D5 10 5 20 5 30 -5 40 2")), Severity::kWarning, "height"), 0);
}

/// A ring of AutoCAD's DONUT is a polyline with a width.
TEST(Dxf, WidthsOfPolylinesAreAQuestionUntilTheyAreAnswered) {
  const auto asked = [](const std::string& entities, std::optional<bool> areas = {}) {
    ReadOptions options;
    options.stroke_areas = areas;
    const Part part = read(dxf(entities), options);
    return std::count_if(part.diagnostics.items().begin(), part.diagnostics.items().end(),
                         [](const Diagnostic& one) { return one.condition == "not-as-drawn"; });
  };
  const std::string ends = " 10 0 20 0 42 1 10 9 20 0 42 1";
  const std::string wide = " 0 LWPOLYLINE 8 D5 70 1 43 2" + ends;
  EXPECT_EQ(asked(wide), 1);
  EXPECT_EQ(asked(wide, false), 0);
  EXPECT_EQ(asked(wide, true), 0);
  EXPECT_EQ(asked(" 0 LWPOLYLINE 8 D5 70 1 43 0" + ends), 0);
  EXPECT_EQ(asked(" 0 LWPOLYLINE 8 ENGRAVE_D1 70 1 43 2" + ends), 0) << "the cutter follows the line";
  EXPECT_EQ(asked(" 0 POLYLINE 8 D5 70 1 40 2 41 2 0 VERTEX 10 0 20 0 42 1 0 VERTEX 10 9 20 0 42 1 0 SEQEND"),
            1);
  EXPECT_EQ(asked(" 0 LWPOLYLINE 8 D5 70 1 10 0 20 0 42 1 40 1 41 2 10 9 20 0 42 1 40 2 41 1", true), 1)
      << "a width that changes";
}

TEST(Dxf, PolylinesAreAsWideAsDrawnWhereThatIsAsked) {
  const auto area_of = [](const std::string& entities) {
    ReadOptions options;
    options.stroke_areas = true;
    double sum = 0;
    for (const Feature& feature : read(dxf(entities), options).features) sum += area(feature.target);
    return sum;
  };
  EXPECT_NEAR(area_of(" 0 LWPOLYLINE 8 D5 70 1 43 2 10 0 20 0 42 1 10 9 20 0 42 1"),
              kPi * (5.5 * 5.5 - 3.5 * 3.5), 1e-6)
      << "a ring";
  EXPECT_NEAR(area_of(" 0 LWPOLYLINE 8 D5 70 0 43 2 10 0 20 0 10 10 20 0 10 10 20 5"), 10 * 2 + 5 * 2 - 1 + 1,
              1e-6)
      << "an open line: square ends, one mitred corner";
  EXPECT_NEAR(area_of(" 0 LWPOLYLINE 8 D5 70 0 43 2 10 0 20 0 10 10 20 0"
                      " 0 LWPOLYLINE 8 D5 70 0 10 5 20 -5 40 2 41 2 10 5 20 5 40 9 41 9"),
              20 + 20 - 4, 1e-6)
      << "two that cross are one area; the last vertex of an open line has no edge";
}

TEST(Dxf, ManyInsertsOfInsertsAreRefusedNotExpanded) {
  std::string blocks = " 0 BLOCK 2 B0 10 0 20 0" + kSquare + " 0 ENDBLK";
  for (int i = 1; i < 12; ++i) {
    blocks += " 0 BLOCK 2 B" + std::to_string(i) + " 10 0 20 0";
    for (int k = 0; k < 10; ++k) blocks += " 0 INSERT 2 B" + std::to_string(i - 1) + " 10 0 20 0";
    blocks += " 0 ENDBLK";
  }
  EXPECT_THAT(refusal(dxf(" 0 INSERT 2 B11 10 0 20 0", blocks)), HasSubstr("simplify the drawing"));
}

/// A rectangle from (x, y) on layer D5.
std::string rectangle_at(double x, double y, double width, double height) {
  std::string text = " 0 LWPOLYLINE 8 D5 90 4 70 1";
  for (const auto& [px, py] : {std::pair{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}})
    text += " 10 " + std::to_string(px) + " 20 " + std::to_string(py);
  return text;
}

TEST(Dxf, LinesMayEndInAnyWay) {
  const std::string text = dxf(kSquare);
  std::string cr = text, crlf;
  std::replace(cr.begin(), cr.end(), '\n', '\r');
  for (const char c : text) crlf += c == '\n' ? "\r\n" : std::string(1, c);
  for (const std::string& written : {cr, crlf}) EXPECT_NEAR(all_area(read(written)), 100, 1e-9);
}

TEST(Dxf, EveryOutermostOutlineIsAskedAbout) {
  const std::string holed = rectangle_at(0, 0, 50, 30) + rectangle_at(5, 5, 5, 5);
  const std::string other = rectangle_at(80, 0, 40, 30) + rectangle_at(90, 5, 5, 5);
  const std::string plain = rectangle_at(0, 50, 20, 10);
  ReadOptions asks;
  asks.ask_if_unclear = true;
  EXPECT_THAT(refusal(dxf(plain + holed), asks),
              HasSubstr("50 x 30 mm (layer D5) holds 1 other, as 1 of 2 outermost outlines does"));
  EXPECT_THAT(refusal(dxf(other + plain + holed), asks), HasSubstr("as 2 of 3 outermost outlines do"));
  EXPECT_THAT(refusal(dxf(other + holed), asks), HasSubstr("as each of 2 outermost outlines does"));
  EXPECT_EQ(refusal(dxf(plain + rectangle_at(0, 80, 20, 10)), asks), "not refused");
  asks.layer_rules = {rule_of_option("profile:outer", "--op")};
  const Part part = read(dxf(plain + holed), asks);
  const auto profiles = std::count_if(part.features.begin(), part.features.end(), [](const Feature& feature) {
    return feature.kind == FeatureKind::kOutsideProfile;
  });
  EXPECT_EQ(profiles, 2);
  EXPECT_EQ(part.features.size(), 3U);
}

/// An option for one outline says nothing of those beside it, and the layer of what is in the parts nothing of a part.
TEST(Dxf, OptionsForOthersAnswerNoQuestion) {
  const auto on = [](const char* layer, double x, double w) {
    const std::string name = layer;
    std::string text = rectangle_at(x, 0, w, 20);
    for (std::size_t at = 0; (at = text.find(" 8 D5", at)) != std::string::npos; at += name.size() + 3)
      text.replace(at, 5, " 8 " + name);
    return text;
  };
  const std::string plates = on("0", 0, 30) + on("0", 50, 40);
  const std::string holed = plates + " 0 CIRCLE 8 0 10 70 20 10 40 8";
  ReadOptions asks;
  asks.ask_if_unclear = true;
  asks.depth = 3;
  const auto refused = [&](const std::string& text, const std::string& op) {
    asks.layer_rules = {rule_of_option(op, "--op")};
    return refusal(dxf(text), asks);
  };
  for (const char* op : {"ignore:3", "drill:3", "inside:3", "ignore:1", "profile:1", "pocket_d2:1"})
    EXPECT_THAT(refused(holed, op), HasSubstr("nothing says what")) << op;
  EXPECT_THAT(refused(plates + " 0 CIRCLE 8 MARK 10 200 20 10 40 2", "ignore:MARK"),
              HasSubstr("the drawing has 2 outlines beside each other"));
  EXPECT_THAT(refused(plates, "profile_d3:2"), HasSubstr("30 x 20 mm (layer 0) stands beside others"));
  EXPECT_THAT(refused(plates, "ignore:1"), HasSubstr("40 x 20 mm (layer 0) stands beside others"));
  for (const char* op : {"pocket:outer", "pocket:0", "profile:1,2"})
    EXPECT_EQ(refused(plates, op), "not refused") << op;
  asks.layer_rules = {rule_of_option("profile:outer", "--op"), rule_of_option("pocket:0", "--op")};
  const Part part = read(dxf(holed), asks);
  ASSERT_EQ(part.features.size(), 3U);
  EXPECT_EQ(std::count_if(part.features.begin(), part.features.end(),
                          [](const Feature& one) { return one.kind == FeatureKind::kOutsideProfile; }),
            2);
}

/// An island stands whether its layer or its number is named, and what no word is said of is not milled with a pocket.
TEST(Dxf, IslandsOfPocketsStandOrAreAskedAbout) {
  ReadOptions asks;
  asks.ask_if_unclear = true;
  asks.depth = 3;
  for (const char* layer : {"A", "B"}) {
    const std::string text =
        dxf(" 0 LWPOLYLINE 8 A 90 4 70 1 10 0 20 0 10 80 20 0 10 80 20 50 10 0 20 50"
            " 0 CIRCLE 8 " +
            std::string(layer) + " 10 20 20 20 40 8");
    const auto taken = [&](std::vector<std::string> said) {
      asks.layer_rules.clear();
      for (const std::string& one : said) asks.layer_rules.push_back(rule_of_option(one, "--op"));
      return all_area(read(text, asks));
    };
    const double whole = 80 * 50, island = whole - 64 * kPi;
    for (const std::vector<std::string>& said :
         {std::vector<std::string>{"island:2"}, {"pocket:outer", "island:2"}, {"pocket:1", "island:2"}})
      EXPECT_NEAR(taken(said), island, 1e-6) << layer << said.front();
    EXPECT_NEAR(taken({"pocket:1", "pocket:2"}), whole, 1e-6);
    asks.layer_rules = {rule_of_option("pocket:1", "--op")};
    EXPECT_THAT(refusal(text, asks), HasSubstr("lies in a pocket of the same depth"));
  }
  const std::string own =
      dxf(" 0 LWPOLYLINE 8 A 90 4 70 1 10 0 20 0 10 80 20 0 10 80 20 50 10 0 20 50"
          " 0 CIRCLE 8 B 10 20 20 20 40 8");
  asks.layer_rules = {rule_of_option("pocket:A", "--op")};
  EXPECT_THAT(refusal(own, asks), HasSubstr("--op island:B"));
}

TEST(Dxf, WhatAClipHidesIsADoubt) {
  const auto drawing = [](const std::string& switched) {
    const std::string filter =
        "0 SECTION 2 OBJECTS 0 DICTIONARY 5 40 102 {ACAD_REACTORS 330 99 102 } 330 30 0 DICTIONARY 5 41 330 "
        "40 "
        "0 SPATIAL_FILTER 5 42 330 41 70 2 10 -1 20 -1 10 4 20 4 71 " +
        switched + " 0 ENDSEC 0 EOF";
    std::string text =
        dxf(" 0 INSERT 5 30 8 0 2 B 10 0 20 0", " 0 BLOCK 2 B 10 0 20 0" + kSquare + " 0 ENDBLK");
    return text.substr(0, text.size() - std::string("0\nEOF\n").size()) + groups(filter);
  };
  for (const bool on : {true, false}) {
    const Part part = read(drawing(on ? "1" : "0"));
    EXPECT_NEAR(all_area(part), 100, 1e-9);
    const auto& items = part.diagnostics.items();
    EXPECT_EQ(std::any_of(items.begin(), items.end(),
                          [](const Diagnostic& item) { return item.condition == "not-as-drawn"; }),
              on);
  }
}

/// Of two outlines that cross the smaller is the one that crosses.
TEST(Dxf, OutlinesThatCrossAreListedAndMayBeLeftOut) {
  const std::string bow = " 0 LWPOLYLINE 8 D5 90 4 70 1 10 60 20 0 10 70 20 8 10 70 20 0 10 60 20 8";
  const std::string other = rectangle_at(5, 5, 10, 8);
  for (const std::string& crossing : {bow, other}) {
    const std::string text = dxf(kSquare + crossing);
    DrawingOverview overview;
    ReadOptions options;
    options.overview = &overview;
    read(text, options);
    ASSERT_EQ(overview.outlines.size(), 2U);
    EXPECT_EQ(overview.outlines[0].role, "pocket");
    EXPECT_EQ(overview.outlines[1].role, "crossing");
    EXPECT_THAT(overview.missing, HasSubstr("cross"));
    EXPECT_EQ(refusal(text), overview.missing);
    options.overview = nullptr;
    options.layer_rules = {rule_of_option("ignore:2", "--op")};
    EXPECT_NEAR(all_area(read(text, options)), 100, 1e-9);
    options.layer_rules = {rule_of_option("ignore:1", "--op")};
    if (crossing == bow) {
      EXPECT_EQ(refusal(text, options), overview.missing);
    } else {
      EXPECT_NEAR(all_area(read(text, options)), 80, 1e-9);
    }
  }
}

TEST(Dxf, LayersAreCalledByTheirDepthsInManyWays) {
  const auto meant = [](const std::string& layer) { return meaning_of_layer(layer).depth.value_or(0); };
  for (const char* layer :
       {"Pocket 6mm", "6mm pocket", "POCKET_6_MM", "pocket-6", "pocket_d6", "Engrave 6mm"})
    EXPECT_EQ(meant(layer), 6) << layer;
  EXPECT_EQ(meant("pocket 2,5mm"), 2.5);
  for (const char* layer : {"Pocket", "Pocket 2", "Drill 6mm", "6mm", "M6mm pocket", "pocket mm", "pocket-x"})
    EXPECT_EQ(meant(layer), 0) << layer;
  EXPECT_EQ(meaning_of_layer("Outline").role, LayerRole::kProfile);
  // In an inch drawing the name is right, and an option that goes before it is said.
  const std::string circle = " 0 CIRCLE 8 POCKET-6MM 10 5 20 5 40 2";
  EXPECT_NEAR(read(dxf(circle, "", 1)).features[0].floor_z, -6, 1e-9);
  ReadOptions deep;
  deep.depth = 18;
  EXPECT_EQ(said(read(dxf(circle), deep), Severity::kWarning,
                 "it says a depth of 6 mm, and --depth 18 goes before"),
            1);
}

}  // namespace
}  // namespace clearcut::read
