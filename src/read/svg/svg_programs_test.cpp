// Drawings as drawing programs write them, where reading by the letter of one attribute gives another size, place or area.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "base/error.h"
#include "base/units.h"
#include "read/svg/svg_reader.h"

namespace clearcut::read {
namespace {

Part read(const std::string& text) {
  ReadOptions options;
  options.depth = 2;
  return read_svg(text, "plate.svg", options);
}

std::string page(const std::string& content) {
  return "<svg width='100mm' height='80mm' viewBox='0 0 100 80'>" + content + "</svg>";
}

double all_area(const Part& part) {
  double sum = 0;
  for (const Feature& feature : part.features) sum += area(feature.target);
  return sum;
}

Box box_of(const std::string& content) {
  Box all;
  for (const Feature& feature : read(page(content)).features) all.add(box(feature.target));
  return all;
}

bool said(const Part& part, const std::string& text) {
  const auto& items = part.diagnostics.items();
  return std::any_of(items.begin(), items.end(),
                     [&](const Diagnostic& item) { return item.what.find(text) != std::string::npos; });
}

TEST(SvgPrograms, APageInMmOfAnOldInkscapeWithoutAViewBoxIsDrawnInNinetiethsOfAnInch) {
  const Part part = read(
      "<svg xmlns:inkscape='i' inkscape:version='0.48.4 r9939' width='210mm' height='297mm'>"
      "<rect x='90' y='90' width='180' height='45'/></svg>");
  const Box place = box(part.features.front().target);
  EXPECT_NEAR(place.min.x, 25.4, 1e-9);
  EXPECT_NEAR(place.max.x, 3 * 25.4, 1e-9);
  EXPECT_NEAR(place.max.y, 297 - 25.4, 1e-9);
  EXPECT_NEAR(place.min.y, 297 - 1.5 * 25.4, 1e-9);
  EXPECT_TRUE(said(part, "has a size and no viewBox: 90 px per inch assumed"));
}

TEST(SvgPrograms, StylesThatAreEntitiesArePutIn) {
  const Part part = read(
      "<?xml version='1.0'?><!DOCTYPE svg PUBLIC '-//W3C//DTD SVG 1.0//EN' 'svg10.dtd' [\n"
      "<!ENTITY ns \"http://www.w3.org/2000/svg\">\n<!ENTITY st0 \"display:none;\">\n"
      "<!ENTITY st1 'fill:none;stroke:#000;'>\n]>\n"
      "<svg xmlns='&ns;' width='100mm' height='80mm' viewBox='0 0 100 80'>"
      "<rect style='&st0;' width='9' height='9'/><rect style='&st1;' x='20' width='9' height='9' "
      "id='a&amp;b'/></svg>");
  EXPECT_NEAR(all_area(part), 81, 1e-9);
  EXPECT_TRUE(said(part, "1 shapes with a stroke and no fill"));
}

TEST(SvgPrograms, EntitiesThatMakeTheFileTooLargeAreRefused) {
  std::string text = "<!DOCTYPE svg [<!ENTITY a \"" + std::string(1'000'000, 'x') + "\">]><svg>";
  for (int i = 0; i < 300; ++i) text += "&a;";
  EXPECT_THROW(read(text + "</svg>"), InputError);
}

/// Whichever order an element names them in.
TEST(SvgPrograms, OfClassesTheOneLaterInTheStyleSheetCounts) {
  const Part part = read(
      page("<style>.off{fill:none} .on{fill:black} .out{display:none !important}</style>"
           "<rect class='on off' width='5' height='5'/><rect class='off on' x='10' width='5' height='5'/>"
           "<rect class='out' style='display:inline' x='20' width='5' height='5'/>"
           "<rect class='off' style='fill:black !important' x='30' width='5' height='5'/>"));
  EXPECT_NEAR(all_area(part), 75, 1e-9);
}

TEST(SvgPrograms, TransformsOfStylesCount) {
  const Box turned =
      box_of("<rect width='10' height='4' style='transform:translate(20px,30px) rotate(90deg)'/>");
  EXPECT_NEAR(turned.min.x, 16, 1e-9);
  EXPECT_NEAR(turned.max.x, 20, 1e-9);
  EXPECT_NEAR(turned.max.y, 50, 1e-9);
  const Box about = box_of("<rect width='10' height='4' transform='rotate(180)' transform-origin='10 4'/>");
  EXPECT_NEAR(about.min.x, 10, 1e-9);
  EXPECT_NEAR(about.max.x, 20, 1e-9);
  const Box by_sheet = box_of(
      "<style>.m{transform:translateX(10mm) scaleY(2)}</style><g class='m' transform='rotate(9)'>"
      "<rect width='5' height='5'/></g>");
  EXPECT_NEAR(by_sheet.min.x, 10 * 96 / 25.4, 1e-9);
  EXPECT_NEAR(by_sheet.height(), 10, 1e-9);
  EXPECT_THROW(box_of("<rect width='9' height='9' transform='rotate(9)' transform-origin='50% 50%'/>"),
               InputError);
  EXPECT_THROW(box_of("<rect width='9' height='9' style='transform:rotate3d(0,0,1,9deg)'/>"), InputError);
}

TEST(SvgPrograms, OfASwitchOneChildIsDrawn) {
  EXPECT_NEAR(
      all_area(read(page("<switch><foreignObject requiredExtensions='ai'><rect/></foreignObject>"
                         "<g systemLanguage='de'><rect width='9' height='9'/></g>"
                         "<g><rect width='5' height='5'/></g><g><rect width='7' height='7'/></g></switch>"))),
      25, 1e-9);
}

TEST(SvgPrograms, AUseGivesAPageWithinItsSize) {
  const Box place = box_of(
      "<defs><svg id='a' viewBox='0 0 10 10' width='5' height='5'><rect width='10' height='10'/></svg></defs>"
      "<use href='#a' width='20' height='20' x='20' y='20'/>");
  EXPECT_NEAR(place.width(), 20, 1e-9);
  EXPECT_NEAR(place.min.x, 20, 1e-9);
}

TEST(SvgPrograms, ColoursThatAreTransparentDrawNothing) {
  const Part part = read(
      page("<rect width='9' height='9' fill='rgba(0,0,0,0)'/><rect width='8' height='8' fill='#1230'/>"
           "<rect width='7' height='7' fill='#12345600'/><rect width='6' height='6' fill='rgb(9 9 9 / 0%)'/>"
           "<rect width='5' height='5' fill='rgba(0,0,0,0.5)'/>"));
  EXPECT_NEAR(all_area(part), 25, 1e-9);
  EXPECT_TRUE(said(part, "not displayed: 4 rect"));
}

/// Ctrl+G makes no layer.
TEST(SvgPrograms, WhatIsGroupedInALayerNestsInTheLayersOutlines) {
  const std::string grouped =
      "<g inkscape:groupmode='layer' inkscape:label='POCKET_D2' id='layer1'><rect width='60' height='50'/>"
      "<g id='g123' inkscape:label='two of them'><g id='g9'><circle cx='30' cy='25' r='8'/></g></g></g>";
  const Part part = read(page(grouped));
  ASSERT_EQ(part.features.size(), 1U);
  EXPECT_EQ(part.features.front().name, "POCKET_D2");
  EXPECT_NEAR(all_area(part), 3000 - 64 * kPi, 1e-3);
  // A group that a rule names is one to the user.
  ReadOptions options;
  options.layer_rules = {{"two of them", LayerRole::kPocket, 3.0, std::nullopt}};
  EXPECT_EQ(read_svg(page(grouped), "plate.svg", options).features.size(), 2U);
  options.layer_rules.clear();
  options.layers = {"two*"};
  EXPECT_NEAR(all_area(read_svg(page(grouped), "plate.svg", options)), 64 * kPi, 1e-3);
}

}  // namespace
}  // namespace clearcut::read
