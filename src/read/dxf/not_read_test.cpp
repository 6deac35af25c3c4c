// Drawings of which something is not read: each says so in one line, whatever it is.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "base/error.h"
#include "read/drawing/layer_rules.h"
#include "read/dxf/dxf_reader.h"
#include "read/job/read_part.h"

namespace clearcut::read {
namespace {

struct Drawing {
  const char* name;
  const char* entities;  ///< beside a square on layer D5; one code and one value after the other
  const char* blocks;
  const char* layers;
  const char* said;       ///< in the one line about what is left out
  bool is_shape = false;  ///< it may be part of the work: the condition `left-out`
};

const Drawing kDrawings[] = {
    {"Text", " 0 TEXT 8 NOTES 10 0 20 0 40 3 1 x", "", "",
     "letters are no outlines (--text outlines draws them): 1 TEXT on layer NOTES"},
    {"MText", " 0 MTEXT 8 NOTES 10 0 20 0 40 3 1 x", "", "",
     "letters are no outlines (--text outlines draws them): 1 MTEXT on layer NOTES"},
    {"Hatch", " 0 HATCH 8 D5 2 SOLID 70 1 91 0", "", "", "no outlines: 1 HATCH"},
    {"MPolygon", " 0 MPOLYGON 8 D5 70 1", "", "", "no outlines: 1 MPOLYGON on layer D5", true},
    {"Dimension", " 0 DIMENSION 8 MASS 2 *D1 10 0 20 0 70 32", "", "",
     "no outlines: 1 DIMENSION on layer MASS"},
    {"Leader", " 0 LEADER 8 MASS 76 2 10 0 20 0 10 5 20 5", "", "", "no outlines: 1 LEADER on layer MASS"},
    {"MultiLeader", " 0 MULTILEADER 8 MASS", "", "", "no outlines: 1 MULTILEADER on layer MASS"},
    {"Face", " 0 3DFACE 8 D5 10 0 20 0 11 1 21 0 12 1 22 1 13 0 23 1", "", "",
     "no outlines: 1 3DFACE on layer D5", true},
    {"Solid", " 0 SOLID 8 D5 10 0 20 0 11 1 21 0", "", "", "no outlines: 1 SOLID"},
    {"Body", " 0 3DSOLID 8 0 70 1", "", "", "no outlines: 1 3DSOLID", true},
    {"Region", " 0 REGION 8 D5 70 1", "", "", "no outlines: 1 REGION on layer D5", true},
    {"Proxy", " 0 ACAD_PROXY_ENTITY 8 D5 90 498", "", "", "no outlines: 1 ACAD_PROXY_ENTITY on layer D5",
     true},
    {"Image", " 0 IMAGE 8 D5 10 0 20 0", "", "", "no outlines: 1 IMAGE on layer D5"},
    {"Table", " 0 ACAD_TABLE 8 D5 2 *T1", "", "", "no outlines: 1 ACAD_TABLE on layer D5"},
    {"Point", " 0 POINT 8 D5 10 1 20 1", "", "", "1 POINT"},
    {"InfiniteLine", " 0 XLINE 8 D5 10 1 20 1 11 1 21 0", "", "", "no outlines: 1 XLINE on layer D5"},
    {"ThreeTexts", " 0 TEXT 8 A 1 x 0 TEXT 8 A 1 y 0 MTEXT 8 B 1 z", "", "",
     "1 MTEXT on layer B, 2 TEXT on layer A"},
    {"EllipseOnEdge", " 0 ELLIPSE 8 D5 10 5 20 5 11 3 21 0 40 0.5 210 0 220 -1 230 0", "", "",
     "no outlines: 1 ELLIPSE that is not flat", true},
    {"LayerOff", " 0 CIRCLE 8 O 10 5 20 5 40 2", "", " 0 LAYER 2 O 62 -7 70 0",
     "off or frozen, or they are invisible: 1 O"},
    {"LayerFrozen", " 0 CIRCLE 8 F 10 5 20 5 40 2", "", " 0 LAYER 2 F 62 7 70 1",
     "off or frozen, or they are invisible: 1 F"},
    {"BlockOnAFrozenLayer", " 0 INSERT 8 F 2 B 10 5 20 5",
     " 0 BLOCK 2 B 10 0 20 0 0 CIRCLE 8 D5 10 0 20 0 40 2 0 ENDBLK", " 0 LAYER 2 F 62 7 70 1",
     "off or frozen, or they are invisible: 1 F"},
    {"FrozenLayerInABlock", " 0 INSERT 8 D5 2 B 10 5 20 5",
     " 0 BLOCK 2 B 10 0 20 0 0 CIRCLE 8 F 10 0 20 0 40 2 0 ENDBLK", " 0 LAYER 2 F 62 7 70 1",
     "off or frozen, or they are invisible: 1 F"},
    {"Invisible", " 0 CIRCLE 8 D5 60 1 10 5 20 5 40 2", "", "", "off or frozen, or they are invisible: 1 D5"},
    {"PaperSpace", " 0 CIRCLE 8 D5 67 1 10 5 20 5 40 2", "", "",
     "no outlines: 1 CIRCLE of the paper layout on layer D5"},
    {"ExternalDrawing", " 0 INSERT 8 D5 2 BASE 10 0 20 0",
     " 0 BLOCK 2 BASE 70 4 10 0 20 0 1 base.dwg 0 ENDBLK", "",
     "drawings in files of their own (bind them, then export again): 1 base.dwg", true},
    {"OverlaidDrawing", " 0 INSERT 8 D5 2 BASE 10 0 20 0",
     " 0 BLOCK 2 BASE 70 8 10 0 20 0 1 base.dwg 0 ENDBLK", "",
     "drawings in files of their own (bind them, then export again): 1 base.dwg", true},
};

std::string groups(std::string words) {
  std::replace(words.begin(), words.end(), ' ', '\n');
  return words + "\n";
}

std::string text_of(const Drawing& drawing, const std::string& square) {
  return groups("0 SECTION 2 HEADER 9 $INSUNITS 70 4 0 ENDSEC") +
         groups("0 SECTION 2 TABLES" + std::string(drawing.layers) + " 0 ENDSEC") +
         groups("0 SECTION 2 BLOCKS" + std::string(drawing.blocks) + " 0 ENDSEC") +
         groups("0 SECTION 2 ENTITIES" + square + drawing.entities + " 0 ENDSEC 0 EOF");
}

class NotRead : public ::testing::TestWithParam<Drawing> {};

TEST_P(NotRead, IsSaidInOneLine) {
  const Drawing& drawing = GetParam();
  const std::string square = " 0 LWPOLYLINE 8 D5 90 4 70 1 10 0 20 0 10 10 20 0 10 10 20 10 10 0 20 10";
  const Part part = read_dxf(text_of(drawing, square), "plate.dxf", {});
  ASSERT_EQ(part.features.size(), 1U);
  EXPECT_NEAR(area(part.features[0].target), 100, 1e-9);
  int skipped = 0;
  for (const Diagnostic& item : part.diagnostics.items()) {
    if (item.severity != Severity::kSkipped && item.condition != "left-out") continue;
    ++skipped;
    EXPECT_EQ(item.condition, drawing.is_shape ? "left-out" : "") << item.what;
    EXPECT_NE(item.what.find(drawing.said), std::string::npos) << item.what;
    EXPECT_EQ(item.what.find('\n'), std::string::npos);
  }
  EXPECT_EQ(skipped, 1);
}

/// Where there is nothing else, the refusal says what was there.
TEST_P(NotRead, IsNamedWhereNothingElseIsThere) {
  try {
    read_dxf(text_of(GetParam(), ""), "plate.dxf", {});
    ADD_FAILURE() << "not refused";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(GetParam().said), std::string::npos) << error.what();
  }
}

/// What is not read may be told to be left out, and nothing else can be made of it.
TEST(NotReadLayers, MayBeIgnoredAndNothingElse) {
  const std::string square = " 0 LWPOLYLINE 8 D5 90 4 70 1 10 0 20 0 10 10 20 0 10 10 20 10 10 0 20 10";
  for (const std::size_t k : {0U, 1U, 4U}) {  // texts, a dimension
    const Drawing& drawing = kDrawings[k];
    const std::string text = text_of(drawing, square), layer = k == 4 ? "MASS" : "NOTES";
    ReadOptions options;
    options.layer_rules = {rule_of_option("ignore:" + layer, "--op")};
    EXPECT_EQ(read_dxf(text, "plate.dxf", options).features.size(), 1U) << drawing.name;
    options.layer_rules = {rule_of_option("pocket:" + layer, "--op")};
    try {
      read_dxf(text, "plate.dxf", options);
      ADD_FAILURE() << "not refused: " << drawing.name;
    } catch (const InputError& error) {
      EXPECT_EQ(
          std::string(error.what()),
          "--op: layer '" + layer + "' has no outlines that are read; `clearcut info` says what is on it");
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Drawings, NotRead, ::testing::ValuesIn(kDrawings),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace clearcut::read
