// Letters of SVG drawings: where they stand, how large, and what is said of them.
#include "read/svg/svg_text.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "read/lettering/test_font.h"
#include "read/svg/svg_reader.h"

namespace clearcut::read {
namespace {

Part part_of(const std::string& content, bool outlines = true) {
  ReadOptions options;
  options.depth = 1;
  options.text_outlines = outlines;
  return read_svg(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"80mm\" viewBox=\"0 0 100 80\">"
      "<g font-family=\"DejaVu Sans\" font-size=\"10\">" +
          content + "</g></svg>",
      "plate.svg", options);
}

Box box_of(const std::string& content) {
  Box all;
  for (const Feature& feature : part_of(content).features) all.add(box(feature.target));
  return all;
}

std::string said(const Part& part) {
  std::string all;
  for (const Diagnostic& item : part.diagnostics.items()) all += item.what + "\n";
  return all;
}

/// Measures of "H" at a size of 10 mm.
struct CapitalH {
  double advance = 0, left = 0, right = 0, top = 0, blank = 0;
  CapitalH() {
    const Face face({{"DejaVu Sans"}});
    Box ink;
    for (const Path& loop : face.outline(U'H', Affine::scaling(10, 10))) ink.add(box(loop));
    advance = face.advance(U'H') * 10, left = ink.min.x, right = ink.max.x, top = ink.max.y;
    blank = face.advance(U' ') * 10;
  }
};

void expect_box(const std::string& content, double left, double bottom, double right, double top) {
  const Box box = box_of(content);
  EXPECT_NEAR(box.min.x, left, 0.005) << content;
  EXPECT_NEAR(box.min.y, bottom, 0.005) << content;
  EXPECT_NEAR(box.max.x, right, 0.005) << content;
  EXPECT_NEAR(box.max.y, top, 0.005) << content;
}

TEST(SvgText, StandsAtItsPlace) {
  NEEDS_THE_FONT;
  const CapitalH h;
  const double l = h.left, r = h.right, t = h.top, a = h.advance;
  expect_box("<text x=\"20\" y=\"30\">H</text>", 20 + l, 50, 20 + r, 50 + t);
  expect_box("<text transform=\"translate(20 30) rotate(-90)\">H</text>", 20 - t, 50 + l, 20, 50 + r);
  expect_box("<text x=\"20\" y=\"30\" font-size=\"200%\">H</text>", 20 + 2 * l, 50, 20 + 2 * r, 50 + 2 * t);
  expect_box("<text x=\"20\" y=\"30\" text-anchor=\"middle\">H</text>", 20 + l - a / 2, 50, 20 + r - a / 2,
             50 + t);
  expect_box("<text x=\"20\" y=\"30\" style=\"text-anchor:end\">H</text>", 20 + l - a, 50, 20 + r - a,
             50 + t);
  expect_box("<text x=\"20\" y=\"30\" letter-spacing=\"5\">HH</text>", 20 + l, 50, 25 + a + r, 50 + t);
  expect_box("<text x=\"20 40\" y=\"30 40\" dx=\"1\">HH</text>", 21 + l, 40, 40 + r, 50 + t);
  expect_box("<text x=\"20\" y=\"30\" rotate=\"-90\">H</text>", 20 - t, 50 + l, 20, 50 + r);
  expect_box("<text x=\"20\" y=\"30\"><tspan dy=\"-1em\">H</tspan></text>", 20 + l, 60, 20 + r, 60 + t);
  expect_box("<text x=\"20\" y=\"30\"><tspan x=\"30\">H</tspan><tspan x=\"30\" dy=\"20\">H</tspan></text>",
             30 + l, 30, 30 + r, 50 + t);
  expect_box("<text x=\"20\" y=\"30\" style=\"font:10px 'DejaVu Sans'\">H</text>", 20 + l, 50, 20 + r,
             50 + t);
}

TEST(SvgText, WhiteSpaceIsCollapsed) {
  NEEDS_THE_FONT;
  const CapitalH h;
  const double wide = 20 + h.advance + h.blank + h.right;
  expect_box("<text x=\"20\" y=\"30\">\n  H \n  H\n </text>", 20 + h.left, 50, wide, 50 + h.top);
  expect_box("<text x=\"20\" y=\"30\"><tspan>H</tspan> <tspan>H</tspan></text>", 20 + h.left, 50, wide,
             50 + h.top);
  expect_box("<text x=\"20\" y=\"30\" xml:space=\"preserve\">H  H</text>", 20 + h.left, 50, wide + h.blank,
             50 + h.top);
}

TEST(SvgText, OverlappingLettersAreOneArea) {
  NEEDS_THE_FONT;
  const Part part = part_of("<text x=\"20\" y=\"30\" letter-spacing=\"-4\">HOH</text>");
  EXPECT_EQ(part.features.size(), 1U);
}

TEST(SvgText, WhatIsNotReadIsNamed) {
  NEEDS_THE_FONT;
  const std::string rect = "<rect width=\"5\" height=\"5\"/>";
  EXPECT_NE(said(part_of(rect + "<text>H</text>", false))
                .find("letters are no outlines (--text outlines draws them): 1 text"),
            std::string::npos);
  EXPECT_NE(said(part_of(rect + "<text><textPath href=\"#a\">H</textPath></text>")).find("1 textPath"),
            std::string::npos);
  EXPECT_NE(said(part_of(rect + "<text writing-mode=\"vertical-rl\">H</text>")).find("runs downwards"),
            std::string::npos);
  EXPECT_NE(
      said(part_of("<text y=\"30\" dominant-baseline=\"middle\">H</text>")).find("dominant-baseline, which"),
      std::string::npos);
  EXPECT_NE(said(part_of("<text y=\"30\" font-family=\"Nowhere\">H</text>"))
                .find("asks for 'Nowhere' is drawn with"),
            std::string::npos);
  EXPECT_THROW(part_of("<text font-size=\"huge\">H</text>"), InputError);
}

TEST(SvgText, ColoursAndLayersOfPartsCount) {
  NEEDS_THE_FONT;
  const Part part = part_of(
      "<text y=\"30\" id=\"POCKET_D3\">H<tspan fill=\"none\" stroke=\"red\">H</tspan><tspan "
      "visibility=\"hidden\">H</tspan></text>");
  EXPECT_EQ(part.features.size(), 2U);
  EXPECT_NE(said(part).find("not displayed: 1 text"), std::string::npos);
}

}  // namespace
}  // namespace clearcut::read
