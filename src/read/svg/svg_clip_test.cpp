// Clip paths and viewports: by formula, and beside dense sampling.
#include "read/svg/svg_clip.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/random.h"
#include "base/units.h"
#include "read/svg/svg_reader.h"

namespace clearcut::read {
namespace {

using ::testing::HasSubstr;

std::string page(const std::string& shapes) {
  return "<svg xmlns='http://www.w3.org/2000/svg' width='200mm' height='200mm' viewBox='0 0 200 200'>" +
         shapes + "</svg>";
}

Part read(const std::string& shapes, bool strokes = false) {
  ReadOptions options;
  options.depth = 2;
  options.stroke_areas = strokes;
  return read_svg(page(shapes), "clips.svg", options);
}

double area_of(const Part& part) {
  double sum = 0;
  for (const Feature& feature : part.features) sum += area(feature.target);
  return sum;
}

double area_of(const std::string& shapes, bool strokes = false) {
  return area_of(read(shapes, strokes));
}

/// What is said and counts in the verdict.
std::string doubts(const Part& part) {
  std::string all;
  for (const Diagnostic& one : part.diagnostics.items())
    if (one.condition == kNotAsDrawn) all += one.what + "\n";
  return all;
}

std::string notes(const Part& part) {
  std::string all;
  for (const Diagnostic& one : part.diagnostics.items()) all += one.what + "\n";
  return all;
}

const std::string kLeft = "<clipPath id='c'><rect width='50' height='200'/></clipPath>";

TEST(SvgClip, OfAShapeTheRestIsLeftOut) {
  const Part half = read(kLeft + "<circle cx='50' cy='60' r='20' clip-path='url(#c)'/>");
  EXPECT_NEAR(area_of(half), 200 * kPi, 1e-3);
  EXPECT_NEAR(box(half.features.at(0).target).max.x, 50, 1e-6);
  EXPECT_EQ(doubts(half), "");
  EXPECT_THAT(notes(half), HasSubstr("1 shapes reach beyond a clip path"));
  EXPECT_NEAR(
      area_of(kLeft + "<g style='clip-path:url(\"#c\")'><rect x='40' y='5' width='30' height='10'/></g>"),
      100, 1e-9);
}

TEST(SvgClip, WhatIsSeenWhollyStaysAsItIs) {
  const std::string shape = "<path d='M10 10C20 5 30 30 40 10V40A8 8 0 0 1 20 40z' ";
  const Part plain = read(shape + "/>"), clipped = read(kLeft + shape + "clip-path='url(#c)'/>");
  EXPECT_EQ(plain.features.at(0).target.at(0).outer(), clipped.features.at(0).target.at(0).outer());
  EXPECT_EQ(notes(plain), notes(clipped));
  const std::string round = "<clipPath id='r'><circle cx='25' cy='25' r='40'/></clipPath>";
  const Part in_circle = read(round + shape + "clip-path='url(#r)'/>");
  EXPECT_EQ(plain.features.at(0).target.at(0).outer(), in_circle.features.at(0).target.at(0).outer());
}

TEST(SvgClip, WhatIsHiddenWhollyIsListed) {
  const Part part = read(
      kLeft +
      "<g clip-path='url(#c)'><rect x='60' width='9' height='9'/><rect x='5' width='9' height='9'/></g>");
  EXPECT_NEAR(area_of(part), 81, 1e-9);
  EXPECT_THAT(notes(part), HasSubstr("not displayed: 1 rect"));
}

TEST(SvgClip, ClipsNestAndHaveClipsThemselves) {
  const std::string defs =
      kLeft +
      "<clipPath id='d'><rect y='20' width='200' height='10'/></clipPath>"
      "<clipPath id='e' clip-path='url(#c)'><rect y='20' width='200' height='10'/></clipPath>"
      "<clipPath id='f'><rect y='20' width='200' height='10' clip-path='url(#c)'/></clipPath>";
  const std::string square = "<rect x='40' y='10' width='100' height='100' ";
  EXPECT_NEAR(area_of(defs + "<g clip-path='url(#c)'>" + square + "clip-path='url(#d)'/></g>"), 100, 1e-9);
  EXPECT_NEAR(area_of(defs + square + "clip-path='url(#e)'/>"), 100, 1e-9);
  EXPECT_NEAR(area_of(defs + square + "clip-path='url(#f)'/>"), 100, 1e-9);
}

TEST(SvgClip, TransformsMoveTheClipWithItsShapes) {
  EXPECT_NEAR(
      area_of(kLeft + "<rect width='30' height='10' transform='translate(40 0)' clip-path='url(#c)'/>"), 300,
      1e-9);
  EXPECT_NEAR(area_of("<clipPath id='c' transform='translate(10 0)'><rect width='50' height='200' "
                      "transform='scale(.5 1)'/></clipPath>"
                      "<rect width='100' height='10' clip-path='url(#c)'/>"),
              250, 1e-9);
}

TEST(SvgClip, RulesAndUsesOfClipShapes) {
  const std::string two = "d='M10 10H60V60H10zM20 20H50V50H20z'";
  const std::string shape = "<rect width='100' height='100' clip-path='url(#c)'/>";
  EXPECT_NEAR(area_of("<clipPath id='c'><path " + two + "/></clipPath>" + shape), 2500, 1e-9);
  EXPECT_NEAR(area_of("<clipPath id='c'><path clip-rule='evenodd' " + two + "/></clipPath>" + shape), 1600,
              1e-9);
  EXPECT_NEAR(
      area_of("<defs><rect id='q' width='10' height='10'/></defs><clipPath id='c'><use href='#q' x='5'/>"
              "<circle cx='70' cy='50' r='5' style='display:none'/></clipPath>" +
              shape),
      100, 1e-9);
}

TEST(SvgClip, ReferencesToNothingHideNothing) {
  for (const char* clip : {"url(#gone)", "none", "url(#q)"}) {
    const Part part = read("<rect id='q' width='10' height='10' clip-path='" + std::string(clip) + "'/>");
    EXPECT_NEAR(area_of(part), 100, 1e-9);
    EXPECT_EQ(doubts(part), "") << clip;
  }
  EXPECT_NEAR(
      area_of(
          kLeft +
          "<style>.c{clip-path:none}</style><rect class='c' width='90' height='10' clip-path='url(#c)'/>"),
      900, 1e-9);
}

TEST(SvgClip, WhatIsNotReadCountsInTheVerdict) {
  const std::string shape = "<rect width='100' height='100' clip-path='url(#c)'/>";
  for (const std::string& clip :
       {std::string("<clipPath id='c'><text>A</text></clipPath>"),
        std::string(
            "<clipPath id='c' clipPathUnits='objectBoundingBox'><rect width='.5' height='1'/></clipPath>"),
        std::string("<clipPath id='c'><rect width='5' height='5' clip-path='url(#c)'/></clipPath>")}) {
    const Part part = read(clip + shape);
    EXPECT_THAT(doubts(part), HasSubstr("1 elements have a clip-path, which is not applied")) << clip;
    EXPECT_NEAR(area_of(part), 10000, 1e-9);
  }
  EXPECT_THAT(doubts(read("<rect width='9' height='9' style='clip-path:inset(2px)'/>")),
              HasSubstr("clip-path"));
  EXPECT_THAT(doubts(read("<rect width='9' height='9' mask='url(#m)'/>")),
              HasSubstr("1 elements have a mask"));
}

TEST(SvgClip, FiltersAreNotAppliedAndSaid) {
  const Part part = read("<g style='filter:url(#f)'><rect width='9' height='9'/></g>");
  EXPECT_NEAR(area_of(part), 81, 1e-9);
  EXPECT_EQ(doubts(part), "");
  const auto& items = part.diagnostics.items();
  EXPECT_EQ(
      std::count_if(items.begin(), items.end(),
                    [](const Diagnostic& item) { return item.what.find("filter") != std::string::npos; }),
      1);
}

TEST(SvgClip, LinesSeenInPartAreReadWholeAndCount) {
  const std::string pen = "fill='none' stroke='black' clip-path='url(#c)'/>";
  const Part across = read(kLeft + "<rect x='40' y='5' width='30' height='10' " + pen);
  EXPECT_NEAR(area_of(across), 300, 1e-9);
  EXPECT_THAT(doubts(across), HasSubstr("1 lines reach beyond a clip path"));
  const Part on_edge = read(kLeft + "<rect x='0' y='0' width='50' height='200' " + pen);
  EXPECT_EQ(doubts(on_edge), "");
  const Part strokes = read(kLeft + "<path d='M40 10H60' stroke-width='2' " + pen, true);
  EXPECT_NEAR(area_of(strokes), 20, 1e-9);
  EXPECT_EQ(doubts(strokes), "");
}

TEST(SvgClip, AFillAndItsStrokeAreClippedTogether) {
  const std::string shape =
      "<rect x='40' y='10' width='30' height='10' stroke='red' stroke-width='2' clip-path='url(#c)'/>";
  EXPECT_NEAR(area_of(kLeft + shape, true), 11 * 12, 1e-9);
}

TEST(SvgClip, ViewportsHideWhatReachesBeyondThem) {
  const auto seen = [](const std::string& attributes, const std::string& shape) {
    return area_of("<g transform='rotate(20) scale(2 3)'><svg x='60' width='10' height='10' " + attributes +
                   ">" + shape + "</svg></g>");
  };
  EXPECT_NEAR(seen("", "<rect x='1' y='1' width='8' height='8'/>"), 6 * 64, 1e-6);
  const std::string beyond = "<rect x='4' y='4' width='8' height='3'/>";
  EXPECT_NEAR(seen("", beyond), 6 * 18, 1e-6);
  EXPECT_NEAR(seen("overflow='visible'", beyond), 6 * 24, 1e-6);
  EXPECT_NEAR(seen("style='overflow:visible'", beyond), 6 * 24, 1e-6);
  EXPECT_NEAR(seen("viewBox='0 0 5 5'", beyond), 6 * 4, 1e-4);
}

/// A polygon about the origin's neighbourhood, and whether it holds a point by the crossings of a ray.
struct Polygon {
  std::vector<Vec2> corners;
  std::string text() const {
    std::string all;
    for (const Vec2 p : corners) all += fmt::format("{} {} ", p.x, p.y);
    return all;
  }
  bool holds(Vec2 p) const {
    bool in = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec2 a = corners[i], b = corners[(i + 1) % corners.size()];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) * (b.x - a.x) / (b.y - a.y)) in = !in;
    }
    return in;
  }
};

Polygon star(Random& random) {
  Polygon out;
  const int count = 3 + static_cast<int>(random.below(7));
  const Vec2 center{random.between(60, 140), random.between(60, 140)};
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * kPi * i / count, radius = random.between(15, 60);
    out.corners.push_back(center + Vec2{std::cos(angle), std::sin(angle)} * radius);
  }
  return out;
}

/// 300 shapes under two clips, one of them moved, are where both hold the points of a grid.
TEST(SvgClip, RandomPolygonsAreCutAsSamplesSay) {
  Random random(11);
  for (int n = 0; n < 300; ++n) {
    const Polygon shape = star(random), outer = star(random), inner = star(random);
    const Vec2 by{random.between(-20, 20), random.between(-20, 20)};
    const std::string drawing = fmt::format(
        "<clipPath id='o'><polygon points='{}'/></clipPath><clipPath id='i'><polygon points='{}' "
        "transform='translate({} {})'/></clipPath><g clip-path='url(#o)'><polygon points='{}' "
        "clip-path='url(#i)'/></g>"
        "<rect x='199' y='199' width='1' height='1'/>",
        outer.text(), inner.text(), by.x, by.y, shape.text());
    const Part part = read(drawing);
    for (double x = 1.03; x < 198; x += 6.1) {
      for (double y = 1.07; y < 198; y += 6.3) {
        const Vec2 p{x, y}, up{x, 200 - y};
        const bool wanted = shape.holds(p) && outer.holds(p) && inner.holds(p - by);
        const bool found = std::any_of(part.features.begin(), part.features.end(),
                                       [&](const Feature& feature) { return contains(feature.target, up); });
        const bool near_edge = std::any_of(
            part.features.begin(), part.features.end(),
            [&](const Feature& feature) { return feature.target.front().boundary_distance(up) < 1e-3; });
        ASSERT_TRUE(wanted == found || near_edge) << "drawing " << n << " at " << x << ", " << y;
      }
    }
  }
}

}  // namespace
}  // namespace clearcut::read
