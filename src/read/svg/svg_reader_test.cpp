#include "read/svg/svg_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "base/units.h"
#include "read/drawing/layer_rules.h"
#include "read/job/read_part.h"
#include "read/svg/svg_style.h"

namespace clearcut::read {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A page of 100 x 80 mm with user units of a millimetre.
std::string page(const std::string& content) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"80mm\" viewBox=\"0 0 100 "
         "80\">\n" +
         content + "\n</svg>";
}

Part read(const std::string& text, ReadOptions options = {}) {
  if (!options.depth && !options.depth_if_missing && options.layer_rules.empty())
    options.depth_if_missing = 2;
  return read_svg(text, "plate.svg", options);
}

double all_area(const Part& part) {
  double sum = 0;
  for (const Feature& feature : part.features) sum += area(feature.target);
  return sum;
}
double area_of(const std::string& content) {
  return all_area(read(page(content)));
}
Box box_of(const std::string& content) {
  Box all;
  for (const Feature& feature : read(page(content)).features) all.add(box(feature.target));
  return all;
}

int said(const Part& part, Severity severity, const std::string& text) {
  return static_cast<int>(std::count_if(
      part.diagnostics.items().begin(), part.diagnostics.items().end(),
      [&](const Diagnostic& d) { return d.severity == severity && d.what.find(text) != std::string::npos; }));
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

TEST(Svg, TheLowerLeftCornerOfThePageIsTheOriginAndYPointsUp) {
  const Box box = box_of("<rect x='10' y='5' width='20' height='15'/>");
  EXPECT_NEAR(box.min.x, 10, 1e-9);
  EXPECT_NEAR(box.max.x, 30, 1e-9);
  EXPECT_NEAR(box.min.y, 60, 1e-9);
  EXPECT_NEAR(box.max.y, 75, 1e-9);
}

TEST(Svg, Shapes) {
  EXPECT_NEAR(area_of("<rect x='10' y='5' width='20' height='15'/>"), 300, 1e-9);
  EXPECT_NEAR(area_of("<rect x='10' y='5' width='20' height='15' rx='3'/>"), 300 - 9 * (4 - kPi), 1e-9);
  EXPECT_NEAR(area_of("<rect x='10' y='5' width='20' height='15' rx='40' ry='2'/>"), 300 - 20 * (4 - kPi),
              0.1);
  EXPECT_NEAR(area_of("<circle cx='50' cy='40' r='10'/>"), 100 * kPi, 1e-9);
  EXPECT_NEAR(area_of("<ellipse cx='50' cy='40' rx='20' ry='10'/>"), 200 * kPi, 0.2);
  EXPECT_NEAR(area_of("<polygon points='0,0 10,0 10 10'/>"), 50, 1e-9);
  EXPECT_NEAR(area_of("<polyline points='0,0 10,0 10,10'/>"), 50, 1e-9);
  EXPECT_NEAR(area_of("<rect width='50%' height='25%'/>"), 1000, 1e-9);
  EXPECT_NEAR(area_of("<circle cx='2cm' cy='2cm' r='1in'/>"), kPi * std::pow(96, 2), 1e-6);
}

TEST(Svg, PathCommandsAbsoluteAndRelative) {
  const double square = 100;
  EXPECT_NEAR(area_of("<path d='M10 10 L20 10 L20 20 L10 20 Z'/>"), square, 1e-9);
  EXPECT_NEAR(area_of("<path d='m10 10 10 0 0 10-10 0z'/>"), square, 1e-9);
  EXPECT_NEAR(area_of("<path d='M10,10H20V20H10Z'/>"), square, 1e-9);
  EXPECT_NEAR(area_of("<path d='M10 10h10v10h-10'/>"), square, 1e-9);  // filled paths close themselves
  EXPECT_NEAR(area_of("<path d='M10 10h10v10h-10zm20 0h10v10h-10z'/>"), 2 * square, 1e-9);
  EXPECT_NEAR(area_of("<path d='M1e1.5e1L20 5 20 15z'/>"), 50, 1e-9);
  EXPECT_NEAR(area_of("<path d='M30 40a10 10 0 1 0 20 0a10 10 0 1 0-20 0z'/>"), 100 * kPi, 1e-9);
  EXPECT_NEAR(area_of("<path d='M30 40a10,10,0,1020,0a10 10 0 10-20,0z'/>"), 100 * kPi, 1e-9);
  EXPECT_NEAR(area_of("<path d='M40 40A10 5 90 0 1 50 40A10 5 90 0 1 40 40'/>"), 50 * kPi, 0.1);
  EXPECT_NEAR(area_of("<path d='M40 40A1 1 0 0 1 60 40A1 1 0 0 1 40 40'/>"), 100 * kPi,
              1e-9);  // radii grow to fit
  const double k = 0.5522847498;
  const std::string c = std::to_string(10 * k), d = std::to_string(10 - 10 * k);
  EXPECT_NEAR(area_of("<path d='M50 30c" + c + " 0 10 " + d + " 10 10s-" + d + " 10-10 10s-10-" + d +
                      "-10-10s" + d + "-10 10-10'/>"),
              100 * kPi, 0.2);
  EXPECT_NEAR(area_of("<path d='M0 0Q20 0 20 20T40 40L0 40z'/>"), 800, 0.1);
}

TEST(Svg, ArcsWhoseEndsLieADiameterApartButForRoundingAreHalfTurns) {
  // A circle of radius 4.56789 by two arcs, as drawing programs write it. The center would lie 0.02 beside the chord.
  for (const char* path : {"m 12.3456,20 a 4.5679,4.5679 0 1 1 -9.1357,0 4.5679,4.5679 0 1 1 9.1357,0 z",
                           "M12.346 20A4.568 4.568 0 1 0 3.211 20 4.568 4.568 0 1 0 12.346 20Z",
                           "M 12.345678,20 A 4.5678912,4.5678912 0 0 1 7.7777868,24.567891 "
                           "4.5678912,4.5678912 0 0 1 3.2098956,20 "
                           "4.5678912,4.5678912 0 1 1 12.345678,20 Z"}) {
    const Part part =
        read(page("<g id='HOLE_D5'><path fill='none' stroke='black' d='" + std::string(path) + "'/></g>"));
    ASSERT_EQ(part.features.size(), 1U) << path;
    const Box box = geometry::box(part.features.front().target);
    EXPECT_NEAR(box.max.y - box.min.y, 9.1358, 2e-3) << path;
    EXPECT_NEAR(box.min.y, 60 - 4.5679, 1e-3) << path;
  }
  // Chords that differ by more than the digits' rounding, and numbers of a few digits, are meant as they stand.
  EXPECT_NEAR(box_of("<path d='M12.3456 20 A4.5679 4.5679 0 0 1 3.2199 20'/>").min.y, 60 - 4.3532, 1e-3);
  EXPECT_NEAR(box_of("<path d='M14.5 20 A4.5 4.5 0 0 1 5.6 20'/>").min.y, 60 - 3.8310, 1e-3);
}

TEST(Svg, FillRules) {
  const std::string same_way = "d='M0 0h40v40h-40zM10 10h20v20h-20z'";
  const std::string other_way = "d='M0 0h40v40h-40zM10 10v20h20v-20z'";
  EXPECT_NEAR(area_of("<path " + same_way + "/>"), 1600, 1e-9);
  EXPECT_NEAR(area_of("<path " + other_way + "/>"), 1200, 1e-9);
  EXPECT_NEAR(area_of("<path fill-rule='evenodd' " + same_way + "/>"), 1200, 1e-9);
  EXPECT_NEAR(area_of("<g style='fill-rule:evenodd'><path " + same_way + "/></g>"), 1200, 1e-9);
  const std::string star = "d='M50 10L62 46L31 24L69 24L38 46z'";
  EXPECT_GT(area_of("<path " + star + "/>"),
            1.2 * area_of("<path fill='none' stroke='red' d='M50 10L55 24L45 24z'/>"));
  EXPECT_NEAR(area_of("<path " + other_way + "/><rect x='12' y='12' width='6' height='6'/>"), 1236, 1e-9);
}

TEST(Svg, FilledPathsThatCrossThemselvesFollowTheirFillRule) {
  std::string star = "<polygon points='";
  for (int i = 0; i < 5; ++i) {
    const Vec2 p = Vec2{50, 40} + direction_of(kPi / 2 + 4 * kPi * i / 5) * 20;
    star += std::to_string(p.x) + "," + std::to_string(p.y) + " ";
  }
  // A pentagram of radius R covers 1.12257 R^2; the pentagon inside it has the radius R / 2.61803.
  const double whole = 1.122570 * 400, pentagon = 2.377641 * 400 / 6.854102;
  EXPECT_NEAR(area_of(star + "'/>"), whole, 1e-3);
  EXPECT_NEAR(area_of(star + "' fill-rule='evenodd'/>"), whole - pentagon, 1e-3);
  EXPECT_NEAR(area_of("<path fill-rule='evenodd' d='M10 10h20v20h-20zM20 20h20v20h-20z'/>"), 600, 1e-6);
}

TEST(Svg, WhatIsWhollyTransparentIsNoOutline) {
  const std::string seen = "<rect x='10' y='10' width='10' height='10'/>";
  for (const char* hidden : {"fill='white' fill-opacity='0'", "style='opacity:0.0;display:inline'",
                             "fill='transparent'", "fill='none' stroke='red' stroke-opacity='0%'"}) {
    EXPECT_NEAR(area_of("<rect width='50' height='40' " + std::string(hidden) + "/>" + seen), 100, 1e-9)
        << hidden;
  }
  EXPECT_NEAR(area_of("<rect width='5' height='4' fill-opacity='0' stroke='red'/>"), 20, 1e-9);
}

TEST(Svg, TransformsNest) {
  EXPECT_NEAR(area_of("<g transform='scale(2)'><g transform='translate(5 5) rotate(30)'><rect width='5' "
                      "height='4'/></g></g>"),
              80, 1e-9);
  EXPECT_NEAR(area_of("<rect width='5' height='4' transform='matrix(1 0 .5 1 10 10) skewX(10)'/>"), 20, 1e-9);
  const Box turned = box_of("<rect x='40' y='40' width='10' height='4' transform='rotate(90, 40, 40)'/>");
  EXPECT_NEAR(turned.min.x, 36, 1e-9);
  EXPECT_NEAR(turned.max.y, 40, 1e-9);
  const Part mirrored = read(page("<circle cx='-20' cy='20' r='5' transform='scale(-1 1)'/>"));
  EXPECT_NEAR(all_area(mirrored), 25 * kPi, 1e-9);
  EXPECT_TRUE(mirrored.features[0].target[0].outer()[0].is_arc());
}

TEST(Svg, UseSymbolAndNestedViewBoxes) {
  EXPECT_NEAR(area_of("<defs><rect id='a' width='5' height='4'/></defs><use href='#a' x='10'/>"
                      "<use xlink:href='#a' transform='translate(30 30) scale(2)'/>"),
              100, 1e-9);
  EXPECT_NEAR(area_of("<symbol id='s' viewBox='0 0 10 10'><rect width='10' height='10'/></symbol>"
                      "<use href='#s' x='5' y='5' width='20' height='20'/>"),
              400, 1e-9);
  EXPECT_NEAR(area_of("<svg x='10' y='10' width='20' height='40' viewBox='0 0 10 10'><rect width='10' "
                      "height='10'/></svg>"),
              400, 1e-9);
}

TEST(Svg, PhysicalSizesAndAssumptions) {
  const std::string rect = "<rect width='10' height='10'/>";
  const auto side = [&](const std::string& attributes, const ReadOptions& options = {}) {
    return std::sqrt(all_area(read("<svg " + attributes + ">" + rect + "</svg>", options)));
  };
  EXPECT_NEAR(side("width='10cm' height='10cm' viewBox='0 0 100 100'"), 10, 1e-9);
  EXPECT_NEAR(side("width='1in' height='1in' viewBox='0 0 10 10'"), 25.4, 1e-9);
  EXPECT_NEAR(side("width='72pt' height='72pt' viewBox='0 0 10 10'"), 25.4, 1e-9);
  EXPECT_NEAR(side("width='1in' viewBox='0 0 10 20'"), 25.4, 1e-9);
  EXPECT_NEAR(side("width='96' height='96' viewBox='0 0 10 10'"), 25.4, 1e-9);
  EXPECT_NEAR(side(""), 10 * 25.4 / 96, 1e-9);
  ReadOptions mm;
  mm.unit = "mm";
  EXPECT_NEAR(side("width='96' height='96' viewBox='0 0 33 33'", mm), 10, 1e-9);
  const Part assumed = read("<svg>" + rect + "</svg>");
  EXPECT_EQ(said(assumed, Severity::kWarning, "96 px per inch assumed"), 1);
  EXPECT_EQ(said(read(page(rect)), Severity::kWarning, "96 px per inch"), 0);
}

TEST(Svg, TakesPixelsOfOtherSizesFromTheProgramThatWroteThem) {
  const std::string square =
      "width='72' height='72' viewBox='0 0 72 72'><rect width='36' height='36'/></svg>";
  const auto side = [&](const std::string& head) { return std::sqrt(all_area(read(head + square))); };
  EXPECT_NEAR(side("<svg "), 36 * 25.4 / 96, 1e-9);
  EXPECT_NEAR(side("<!-- Generator: Adobe Illustrator 26.0.1, SVG Export Plug-In --><svg "), 12.7, 1e-9);
  EXPECT_NEAR(side("<svg xmlns:inkscape='i' inkscape:version='0.91 r13725' "), 36 * 25.4 / 90, 1e-9);
  EXPECT_NEAR(side("<svg xmlns:inkscape='i' inkscape:version='1.2 (b0a848)' "), 36 * 25.4 / 96, 1e-9);
}

TEST(Svg, ReadsNamesThatIllustratorEscapes) {
  const Part part = read(page("<g id='POCKET_x5F_D3'><rect width='10' height='10'/></g>"));
  EXPECT_EQ(part.features.front().name, "POCKET_D3");
  EXPECT_DOUBLE_EQ(part.features.front().floor_z, -3);
}

TEST(Svg, DepthByAttributeLayerNameColourAndOption) {
  const Part part = read(page(
      "<g data-depth='5' data-top='-1'><rect width='10' height='10'/>"
      "<rect x='20' width='10' height='10' data-depth='0.5cm'/></g>"
      "<g inkscape:groupmode='layer' inkscape:label='Pocket D3'><rect x='40' width='10' height='10'/></g>"
      "<g id='island'><circle cx='45' cy='5' r='2'/></g>"));
  ASSERT_EQ(part.features.size(), 3u);
  EXPECT_DOUBLE_EQ(part.features[0].floor_z, -3);
  EXPECT_NEAR(area(part.features[0].target), 100 - 4 * kPi, 1e-3);
  EXPECT_DOUBLE_EQ(part.features[1].floor_z, -6);
  EXPECT_DOUBLE_EQ(part.features[1].top_z, -1);
  ReadOptions by_color;
  by_color.layer_rules = {{"#ff0000", std::nullopt, 4.0, std::nullopt},
                          {"#0000ff", LayerRole::kIgnore, {}, {}}};
  const Part colors = read(
      page("<rect fill='red' width='10' height='10'/><rect style='fill:#00F' x='20' width='9' height='9'/>"),
      by_color);
  ASSERT_EQ(colors.features.size(), 1u);
  EXPECT_DOUBLE_EQ(colors.features[0].floor_z, -4);
}

TEST(Svg, WhatIsNotShownOrNoOutlineIsCountedAndNamed) {
  const Part part = read(page(
      "<rect width='10' height='10'/><text>hi</text><image/><text>ho</text>"
      "<rect display='none' width='5' height='5'/><g style='display:none'><rect width='5' height='5'/></g>"
      "<circle r='3' fill='none'/><rect visibility='hidden' width='5' height='5'/>"
      "<clipPath><rect width='5' height='5'/></clipPath>"));
  EXPECT_NEAR(all_area(part), 100, 1e-9);
  EXPECT_EQ(said(part, Severity::kSkipped, "no outlines: 1 image"), 1);
  EXPECT_EQ(said(part, Severity::kSkipped, "(--text outlines draws them): 2 text"), 1);
  EXPECT_EQ(said(part, Severity::kSkipped, "not displayed: 1 circle, 1 g, 2 rect"), 1);
}

/// The corners of the rectangle lie on the circle, where it is tangent to the sides.
TEST(Svg, AFilledPathWhoseCornersLieOnATangentCircleIsResolved) {
  for (const char* turn : {"0", "34.4", "90", "123"}) {
    EXPECT_NEAR(area_of("<path d='M0 -10H40V10H0zM10 0A10 10 0 0 1 -10 0A10 10 0 0 1 10 0z' "
                        "transform='translate(60 60) rotate(" +
                        std::string(turn) + ")'/>"),
                800 + 50 * kPi, 1e-3)
        << turn;
  }
}

TEST(Svg, StrokesWithoutFillAreOutlinesToBeChained) {
  const Part part = read(page(
      "<g fill='none' stroke='black'><path d='M10 10H30V30'/><line x1='30' y1='30' x2='10' y2='10'/></g>"));
  EXPECT_NEAR(all_area(part), 200, 1e-9);
  EXPECT_EQ(said(part, Severity::kNote, "2 shapes with a stroke and no fill"), 1);
  EXPECT_THAT(refusal(page("<path fill='none' stroke='black' d='M10 10H30V30'/>")),
              HasSubstr("the outline is open at"));
}

TEST(Svg, StyleSheetsWithSimpleSelectors) {
  const Part part =
      read(page("<style>/* x */ .hidden{display:none} rect, .b { fill : #F00 } svg > g {fill:red}</style>"
                "<rect class='hidden' width='10' height='10'/><rect x='20' width='10' height='10'/>"));
  EXPECT_NEAR(all_area(part), 100, 1e-9);
  EXPECT_EQ(said(part, Severity::kWarning, "rules that are not read"), 1);
}

TEST(Svg, PercentagesWithinAViewportAreOfItsViewBox) {
  EXPECT_NEAR(
      area_of("<svg width='40' height='20' viewBox='0 0 400 200'><rect width='50%' height='50%'/></svg>"),
      200, 1e-9);
  EXPECT_NEAR(area_of("<symbol id='s' viewBox='0 0 10 10'><circle cx='50%' cy='50%' r='50%'/></symbol>"
                      "<use href='#s' width='20' height='20'/>"),
              100 * kPi, 1e-9);
}

TEST(Svg, StylesSayPlaceAndSize) {
  EXPECT_NEAR(area_of("<rect width='10' height='10' style='width:20px;height:30px !important'/>"), 600, 1e-9);
  EXPECT_NEAR(area_of("<style>.c{r:5px;cx:20px;cy:20px} rect{rx:2px}</style><circle class='c' r='1'/>"),
              25 * kPi, 1e-9);
  EXPECT_NEAR(area_of("<path d='M0 0H1V1z' style='d: path(\"M0 0H10V10z\")'/>"), 50, 1e-9);
  EXPECT_NEAR(area_of("<ellipse cx='10' cy='10' rx='5'/>"), 25 * kPi, 1e-9);
  EXPECT_THAT(refusal(page("<rect height='5' style='width:calc(1px + 2px)'/>")), HasSubstr("is no length"));
  const std::string shape = "<rect width='50%' height='50%'/></svg>";
  EXPECT_NEAR(all_area(read("<svg style='width:40mm;height:20mm'>" + shape)), 200, 1e-9);
  // A page as wide as the window keeps the size of its attributes.
  EXPECT_NEAR(all_area(read("<svg width='40mm' height='20mm' style='width:100%;height:auto'>" + shape)), 200,
              1e-9);
}

TEST(Svg, WhatStylesSayAndIsNotReadIsRefusedOrWarnedOf) {
  const std::string square = "<rect width='10' height='10' ";
  EXPECT_THAT(refusal(page(square + "style='transform:rotate(5deg);transform-box:fill-box'/>")),
              HasSubstr("transform-box 'fill-box' is not read"));
  EXPECT_THAT(refusal(page(square + "style='rotate:5deg'/>")),
              HasSubstr("property rotate of a style is not read"));
  const Part part = read(page(square + "style='clip-path:inset(2px)' marker-end='url(#m)'/>"));
  EXPECT_EQ(said(part, Severity::kWarning, "1 elements have a clip-path"), 1);
  EXPECT_EQ(said(part, Severity::kWarning, "1 shapes have markers"), 1);
  EXPECT_EQ(said(read("<?xml-stylesheet href='a.css'?>" + page(square + "/>")), Severity::kWarning,
                 "a style sheet"),
            1);
}

/// The open condition that what is drawn and not read is, or "".
std::string open_condition(const Part& part) {
  for (const Diagnostic& one : part.diagnostics.items())
    if (!one.condition.empty()) return one.condition;
  return "";
}

TEST(Svg, WhatMayBePartOfTheWorkAndIsNotReadIsAnOpenCondition) {
  const std::string square = "<rect width='10' height='10'/>";
  const std::string more = "xmlns:v='urn:v' ";
  EXPECT_EQ(open_condition(read(page(square))), "");
  EXPECT_EQ(
      open_condition(read(page(square + "<image width='9' height='9'/><animate/><v:props " + more + "/>"))),
      "");
  EXPECT_EQ(open_condition(read(page(square + "<flowRoot/>"))), "left-out");
  EXPECT_EQ(open_condition(read(page(square + "<path d='M20 0h9v9z' marker-end='url(#m)'/>"))), "left-out");
  EXPECT_EQ(open_condition(read(page(square + "<polygon points='20,0 30,0 30,10 20,10 7'/>"))),
            "not-as-drawn");
  EXPECT_EQ(open_condition(read(page("<style>g > rect {display:none}</style>" + square))), "not-as-drawn");
}

/// A drawing of ten in ten in ten ... uses is refused before it is drawn.
TEST(Svg, WhatDrawsTooMuchIsRefusedAtOnce) {
  std::string levels = "<g id='g0'><rect width='1' height='1'/></g>";
  for (int i = 1; i < 100; ++i) {
    levels += "<g id='g" + std::to_string(i) + "'>";
    for (int k = 0; k < 10; ++k) levels += "<use href='#g" + std::to_string(i - 1) + "'/>";
    levels += "</g>";
  }
  EXPECT_THAT(refusal(page("<defs>" + levels + "</defs><use href='#g99'/>")),
              HasSubstr("more than 1 million elements"));
}

TEST(Svg, WhatHasNoSizeAndHalfPointsAreSaid) {
  const Part part =
      read(page("<rect width='10' height='10'/><rect width='-5' height='5'/><circle r='0'/>"
                "<polygon points='20,0 30,0 30,10 20,10 7'/>"));
  EXPECT_NEAR(all_area(part), 200, 1e-9);
  EXPECT_EQ(said(part, Severity::kSkipped, "1 circle without size, 1 rect without size"), 1);
  EXPECT_EQ(said(part, Severity::kWarning, "half a point"), 1);
}

TEST(Svg, Colors) {
  EXPECT_EQ(normal_color("#F0a"), "#ff00aa");
  EXPECT_EQ(normal_color("Red"), "#ff0000");
  EXPECT_EQ(normal_color("rgb(255, 128,0)"), "#ff8000");
  EXPECT_EQ(normal_color("rgb(100%,0%,50%)"), "#ff0080");
  EXPECT_EQ(normal_color("url(#x)"), "url(#x)");
}

TEST(Svg, PathsThatEndInAnErrorAreRefusedHoweverTheyAreDrawn) {
  for (const bool areas : {false, true}) {
    ReadOptions options;
    options.stroke_areas = areas;
    const auto broken = [&] {
      read(page("<path d='M5 35L15 5L x' fill='none' stroke='black' stroke-width='4'/>"), options);
    };
    EXPECT_THAT(broken, ::testing::ThrowsMessage<InputError>(HasSubstr("correct it"))) << areas;
  }
}

TEST(Svg, BadFilesGiveOneLineSayingWhere) {
  EXPECT_THAT(refusal(""), HasSubstr("plate.svg:1: not SVG"));
  EXPECT_THAT(refusal("<svg>\n<g>\n<rect></g></svg>"), StartsWith("plate.svg:3: not SVG"));
  EXPECT_THAT(refusal("<html></html>"), HasSubstr("outermost element is not <svg>"));
  EXPECT_THAT(refusal("\x1f\x8b"
                      "abc"),
              HasSubstr("compressed SVG"));
  EXPECT_THAT(refusal(page("<path d='M0 0 L5'/>")),
              StartsWith("plate.svg:2: a number was expected at character"));
  EXPECT_THAT(refusal(page("<path d='L5 5'/>")), HasSubstr("does not begin with M"));
  EXPECT_THAT(refusal(page("<path d='M0 0 X5'/>")), HasSubstr("command letter"));
  EXPECT_THAT(refusal(page("<path d='M0 0 L nan 5'/>")), HasSubstr("a number was expected"));
  EXPECT_THAT(refusal(page("<path d='M0 0 L1e300 5 L 5 5z'/>")), HasSubstr("beyond 1000 m"));
  EXPECT_THAT(refusal(page("<rect width='5' height='5' transform='spin(3)'/>")),
              HasSubstr("'spin(3)' is not understood"));
  EXPECT_THAT(refusal(page("<rect x='1em' width='5' height='5'/>")), HasSubstr("x '1em' is no length"));
  EXPECT_THAT(refusal(page("<use href='#nobody'/>")), HasSubstr("'#nobody', which the file does not define"));
  EXPECT_THAT(refusal(page("<g id='a'><use href='#a'/></g>")), HasSubstr("refers to itself"));
  EXPECT_THAT(refusal(page("<rect data-depth='deep' width='5' height='5'/>")),
              HasSubstr("'deep' is no length"));
  EXPECT_THAT(refusal(page("")), HasSubstr("nothing to mill"));
  EXPECT_THAT(refusal(page("<text>hi</text>")),
              HasSubstr("because letters are no outlines (--text outlines draws them): 1 text)"));
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<g>";
  EXPECT_THAT(refusal("<svg>" + deep), HasSubstr("not SVG"));
}

/// A layer of texts alone, which are not read.
TEST(SvgText, ItsLayerMayBeIgnored) {
  ReadOptions options;
  options.depth = 3;
  options.layer_rules = {rule_of_option("ignore:Notes", "--op")};
  const std::string text =
      "<svg xmlns='http://www.w3.org/2000/svg' xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape' "
      "width='50mm' height='50mm' "
      "viewBox='0 0 50 50'><rect width='20' height='20'/><g inkscape:groupmode='layer' "
      "inkscape:label='Notes'><text>a</text></g></svg>";
  EXPECT_EQ(read(text, options).features.size(), 1U);
}

}  // namespace
}  // namespace clearcut::read
