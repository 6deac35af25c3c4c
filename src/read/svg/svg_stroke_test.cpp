// Areas of strokes: by formula, and beside dense sampling of the pen.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/error.h"
#include "base/random.h"
#include "base/text.h"
#include "base/units.h"
#include "read/svg/svg_reader.h"

namespace clearcut::read {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string page(const std::string& shapes) {
  return "<svg xmlns='http://www.w3.org/2000/svg' width='200mm' height='200mm' viewBox='0 0 200 200'>" +
         shapes + "</svg>";
}

Part read(const std::string& shapes) {
  ReadOptions options;
  options.depth = 2;
  options.stroke_areas = true;
  return read_svg(page(shapes), "strokes.svg", options);
}

double area_of(const std::string& shapes) {
  double sum = 0;
  for (const Feature& feature : read(shapes).features) sum += area(feature.target);
  return sum;
}

const std::string kPen = "fill='none' stroke='black' stroke-width='4' ";

TEST(SvgStroke, CapsEndALine) {
  const std::string line = "<path d='M10 10H30' " + kPen;
  EXPECT_NEAR(area_of(line + "/>"), 80, 1e-6);
  EXPECT_NEAR(area_of(line + "stroke-linecap='square'/>"), 96, 1e-6);
  EXPECT_NEAR(area_of(line + "style='stroke-linecap:round'/>"), 80 + 4 * kPi, 1e-6);
}

TEST(SvgStroke, JoinsFillCorners) {
  const std::string corner = "<path d='M10 10H30V30' " + kPen;
  EXPECT_NEAR(area_of(corner + "/>"), 80 + 80, 1e-6) << "a miter of a right angle fills the square";
  EXPECT_NEAR(area_of(corner + "stroke-linejoin='bevel'/>"), 160 - 2, 1e-6);
  EXPECT_NEAR(area_of(corner + "stroke-linejoin='round'/>"), 160 - 4 + kPi, 1e-6);
  EXPECT_NEAR(area_of(corner + "stroke-miterlimit='1.4'/>"), 160 - 2, 1e-6) << "1.4142 is needed";
}

TEST(SvgStroke, ClosedLinesAreRings) {
  EXPECT_NEAR(area_of("<rect x='10' y='10' width='20' height='30' " + kPen + "/>"), 24 * 34 - 16 * 26, 1e-6);
  EXPECT_NEAR(area_of("<circle cx='50' cy='50' r='10' " + kPen + "/>"), kPi * (144 - 64), 1e-5);
  EXPECT_NEAR(area_of("<circle cx='50' cy='50' r='1' " + kPen + "/>"), kPi * 9, 1e-5)
      << "the pen covers the middle";
}

TEST(SvgStroke, WithAFillTheyAddTheirOuterHalf) {
  EXPECT_NEAR(
      area_of("<rect x='10' y='10' width='20' height='30' fill='red' stroke='black' stroke-width='4'/>"),
      24 * 34, 1e-6);
}

TEST(SvgStroke, AFillMayRunEitherWayAndHaveHoles) {
  const std::string pen = "fill='red' stroke='black' stroke-width='2'/>";
  const std::string hole = "M20 20H30V30H20z";
  for (const char* outer : {"M10 10H40V40H10z", "M10 10V40H40V10z"})
    EXPECT_NEAR(area_of("<path d='" + std::string(outer) + "' " + pen), 32 * 32, 1e-6);
  EXPECT_NEAR(area_of("<path d='M10 10V40H40V10z" + hole + "' " + pen), 32 * 32 - 8 * 8, 1e-6);
  EXPECT_NEAR(area_of("<g transform='scale(3 1)'><path d='M10 10V40H40V10z' " + pen + "</g>"), 3 * 32 * 32,
              1e-6);
}

TEST(SvgStroke, StrokesOfEvenOddFillsAreSaid) {
  const Part part = read("<path d='M10 10H40V40H10z' fill-rule='evenodd' fill='red' stroke='black'/>");
  EXPECT_NEAR(area(part.features.at(0).target), 900, 1e-6);
  EXPECT_TRUE(
      std::any_of(part.diagnostics.items().begin(), part.diagnostics.items().end(), [](const Diagnostic& d) {
        return d.what.find("1 strokes of shapes filled by the even-odd rule") != std::string::npos;
      }));
}

TEST(SvgStroke, StrokesOfALayerAreOneArea) {
  EXPECT_NEAR(area_of("<path d='M10 20H50' " + kPen + "/><path d='M30 5V35' " + kPen + "/>"), 160 + 120 - 16,
              1e-6);
  EXPECT_NEAR(area_of("<path d='M10 20H50' " + kPen + "/><path d='M20 20H30' " + kPen + "/>"), 160, 1e-6);
}

/// A track that ends in a pad, as boards and icons have them: one area where their colour is one.
TEST(SvgStroke, StrokesAndFillsOfOneColourAreOneArea) {
  const std::string pad = "<rect x='10' y='10' width='20' height='20' fill='#000'/>";
  const auto track = [](const std::string& color) {
    return "<path d='M20 20H50' fill='none' stroke-width='4' stroke='" + color + "'/>";
  };
  EXPECT_NEAR(area_of(pad + track("black")), 400 + 20 * 4, 1e-6);
  EXPECT_NEAR(area_of(track("#000000") + pad), 400 + 20 * 4, 1e-6);
  EXPECT_THROW(read(pad + track("red")), InputError);
  EXPECT_THROW(read(pad + track("black") + "<path d='M60 60H70' fill='none' stroke-width='4' stroke='red'/>"),
               InputError)
      << "strokes of two colours have none";
}

TEST(SvgStroke, TheDrawingStretchesThePen) {
  EXPECT_NEAR(area_of("<g transform='scale(2)'><path d='M5 5H15' " + kPen + "/></g>"), 160, 1e-6);
  EXPECT_NEAR(area_of("<g transform='scale(3 1)'><path d='M5 5V15' " + kPen + "/></g>"), 120, 1e-6);
  EXPECT_NEAR(
      area_of("<g transform='scale(3 1)'><path d='M5 5H15' stroke-linecap='round' " + kPen + "/></g>"),
      120 + 3 * 4 * kPi, 0.05);
}

TEST(SvgStroke, DashesAreSaid) {
  const Part part = read("<path d='M10 10H30' stroke-dasharray='2 1' " + kPen + "/>");
  const auto& items = part.diagnostics.items();
  EXPECT_TRUE(std::any_of(items.begin(), items.end(), [](const Diagnostic& d) {
    return d.severity == Severity::kWarning && d.what.find("1 dashed strokes") != std::string::npos;
  }));
}

/// Round pens cover what is no farther than half their width from the line.
TEST(SvgStroke, RoundPensCoverWhatIsNear) {
  Random random(7);
  for (int n = 0; n < 200; ++n) {
    std::string data;
    Path line;
    Vec2 at{random.between(40, 160), random.between(40, 160)};
    data = "M" + trimmed(at.x, 9) + " " + trimmed(200 - at.y, 9);
    for (std::uint64_t k = 1 + random.below(5); k > 0; --k) {
      const Vec2 to{random.between(40, 160), random.between(40, 160)};
      data += "L" + trimmed(to.x, 9) + " " + trimmed(200 - to.y, 9);
      line.push_back(Edge::line(at, to));
      at = to;
    }
    const double width = random.between(1, 20);
    SCOPED_TRACE(data + " width " + trimmed(width, 9));
    const Part part = read("<path d='" + data +
                           "' fill='none' stroke='black' stroke-linecap='round' stroke-linejoin='round' " +
                           "stroke-width='" + trimmed(width, 9) + "'/>");
    for (int i = 0; i < 200; ++i) {
      const Vec2 p{random.between(10, 190), random.between(10, 190)};
      double near = HUGE_VAL;
      for (const Edge& edge : line) near = std::min(near, distance(edge, p));
      if (std::abs(near - width / 2) < 1e-3) continue;
      bool covered = false;
      for (const Feature& feature : part.features)
        for (const Region& region : feature.target) covered = covered || region.contains(p);
      ASSERT_EQ(covered, near < width / 2) << p.x << " " << p.y;
    }
  }
}

std::string refusal_of_lines(const std::string& shapes) {
  ReadOptions options;
  options.depth = 2;
  try {
    read_svg(page(shapes), "lines.svg", options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
}

/// Lines that are no outlines: what is proposed works.
TEST(SvgStroke, LinesThatCrossOrEndAreOfferedAsLinesAndAsStrokes) {
  const std::string star = "<polygon points='50,5 79,90 5,38 95,38 21,90' " + kPen + "/>";
  const std::string two = "<rect x='10' y='10' width='50' height='50' " + kPen +
                          "/><rect x='40' y='40' width='50' height='50' " + kPen + "/>";
  const std::string open = "<path d='M10 10L90 90' " + kPen + "/>";
  for (const std::string& lines : {star, two, open}) {
    EXPECT_THAT(refusal_of_lines(lines), HasSubstr("--op engrave:'*'"));
    EXPECT_THAT(refusal_of_lines(lines), HasSubstr("--strokes areas"));
    ReadOptions areas;
    areas.depth = 2;
    areas.stroke_areas = areas.ask_if_unclear = true;
    EXPECT_EQ(read_svg(page(lines), "lines.svg", areas).features.size(), 1U);
  }
  EXPECT_THAT(refusal_of_lines("<path d='M10 10L90 90L90 10L10 90' fill='red'/>"
                               "<path d='M40 10L90 10L90 40Z' fill='blue'/>"),
              Not(HasSubstr("--strokes")))
      << "areas have no strokes";
}

/// The line comes back close to itself at the tip, so that many pieces of the band run along each other.
TEST(SvgStroke, ThinHalfEllipsesAreOneBand) {
  Random random(11);
  for (const auto& [rx, ry, width] : {std::array{80.0, 10.0, 6.0}, {70.0, 10.0, 4.0}, {60.0, 3.0, 5.0}}) {
    SCOPED_TRACE(fmt::format("{} by {}, {} wide", rx, ry, width));
    const Part part = read(
        fmt::format("<path d='M50 {}A{} {} 0 0 1 50 {}' fill='none' stroke='black' stroke-linecap='round' "
                    "stroke-width='{}'/>",
                    100 - ry, rx, ry, 100 + ry, width));
    ASSERT_EQ(part.features.size(), 1u);
    std::vector<Vec2> line;
    for (int i = 0; i <= 2000; ++i) {
      const double t = kPi * i / 2000;
      line.push_back({50 + rx * std::sin(t), 100 + ry * std::cos(t)});
    }
    for (int i = 0; i < 300; ++i) {
      const Vec2 p{random.between(40, 140), random.between(80, 120)};
      double near = HUGE_VAL;
      for (const Vec2 on : line) near = std::min(near, distance(on, p));
      if (std::abs(near - width / 2) < 0.02) continue;
      EXPECT_EQ(contains(part.features.front().target, p), near < width / 2) << p.x << " " << p.y;
    }
  }
}

}  // namespace
}  // namespace clearcut::read
