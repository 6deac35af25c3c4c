// Letters of DXF drawings: where they stand, how large, and what is said of them.
#include "read/dxf/dxf_text.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "read/dxf/dxf_reader.h"
#include "read/lettering/test_font.h"

namespace clearcut::read {
namespace {

/// Groups as words; "~" in a value is a blank.
std::string groups(std::string words) {
  std::replace(words.begin(), words.end(), ' ', '\n');
  std::replace(words.begin(), words.end(), '~', ' ');
  return words + "\n";
}

std::string drawing(const std::string& entities, const std::string& blocks = "") {
  return groups(
      "0 SECTION 2 HEADER 9 $INSUNITS 70 4 0 ENDSEC 0 SECTION 2 TABLES 0 STYLE 2 D 3 DejaVuSans.ttf "
      "0 STYLE 2 SHX 3 txt.shx 0 ENDSEC 0 SECTION 2 BLOCKS" +
      blocks + " 0 ENDSEC 0 SECTION 2 ENTITIES" + entities + " 0 ENDSEC 0 EOF");
}

Part part_of(const std::string& entities, const std::string& blocks = "") {
  ReadOptions options;
  options.depth = 1;
  options.text_outlines = true;
  return read_dxf(drawing(entities, blocks), "plate.dxf", options);
}

Box box_of(const std::string& entities, const std::string& blocks = "") {
  Box all;
  for (const Feature& feature : part_of(entities, blocks).features) all.add(box(feature.target));
  return all;
}

double area_of(const Part& part) {
  double sum = 0;
  for (const Feature& feature : part.features) sum += area(feature.target);
  return sum;
}

void expect_box(const Box& box, double left, double bottom, double right, double top,
                const std::string& what = "") {
  EXPECT_NEAR(box.min.x, left, 0.005) << what;
  EXPECT_NEAR(box.min.y, bottom, 0.005) << what;
  EXPECT_NEAR(box.max.x, right, 0.005) << what;
  EXPECT_NEAR(box.max.y, top, 0.005) << what;
}

/// "H" with capitals of 10: its measures in mm.
struct CapitalH {
  double advance = 0, left = 0, right = 0, below = 0;
  CapitalH() {
    const Face face({{"DejaVu Sans"}});
    const double em = 10 / face.cap_height();
    Box ink;
    for (const Path& loop : face.outline(U'H', Affine::scaling(em, em))) ink.add(box(loop));
    advance = face.advance(U'H') * em, left = ink.min.x, right = ink.max.x;
    below = face.bottom_of(U'p') * em;
  }
};

TEST(DxfText, StandsOnItsPoint) {
  NEEDS_THE_FONT;
  const CapitalH h;
  expect_box(box_of(" 0 TEXT 8 0 7 D 10 50 20 30 40 10 1 H"), 50 + h.left, 30, 50 + h.right, 40);
  expect_box(box_of(" 0 TEXT 8 0 7 D 10 50 20 30 40 10 50 90 1 H"), 40, 30 + h.left, 50, 30 + h.right);
  expect_box(box_of(" 0 TEXT 8 0 7 D 10 50 20 30 40 10 41 2 1 H"), 50 + 2 * h.left, 30, 50 + 2 * h.right, 40);
  expect_box(box_of(" 0 TEXT 8 0 7 D 10 50 20 30 40 10 51 45 1 H"), 50 + h.left, 30, 60 + h.right, 40);
  expect_box(box_of(" 0 TEXT 8 0 7 D 10 50 20 30 40 10 71 2 1 H"), 50 - h.right, 30, 50 - h.left, 40);
  expect_box(box_of(" 0 TEXT 8 0 7 D 10 50 20 30 40 10 71 4 1 H"), 50 + h.left, 20, 50 + h.right, 30);
  expect_box(box_of(" 0 TEXT 8 0 7 D 10 50 20 30 40 10 230 -1 1 H"), -50 - h.right, 30, -50 - h.left, 40);
}

TEST(DxfText, IsJustified) {
  NEEDS_THE_FONT;
  const CapitalH h;
  for (int across = 0; across <= 2; ++across) {
    for (int along = 0; along <= 3; ++along) {
      if (across + along == 0) continue;
      const std::string what = " 72 " + std::to_string(across) + " 73 " + std::to_string(along);
      const double x = 50 - across * h.advance / 2;
      const double y = along == 0 ? 30 : along == 1 ? 30 + h.below : along == 2 ? 25 : 20;
      expect_box(box_of(" 0 TEXT 8 0 7 D 10 0 20 0 11 50 21 30 40 10 1 H" + what), x + h.left, y, x + h.right,
                 y + 10, what);
    }
  }
  const double middle = (10 - h.below) / 2, x = 50 - h.advance / 2;
  expect_box(box_of(" 0 TEXT 8 0 7 D 10 0 20 0 11 50 21 30 40 10 72 4 1 H"), x + h.left, 30 - middle,
             x + h.right, 40 - middle);
}

TEST(DxfText, FillsTheWayBetweenTwoPoints) {
  NEEDS_THE_FONT;
  const CapitalH h;
  const double s = 40 / h.advance;
  expect_box(box_of(" 0 TEXT 8 0 7 D 10 5 20 5 11 45 21 5 40 10 72 3 1 H"), 5 + s * h.left, 5,
             5 + s * h.right, 5 + s * 10);
  expect_box(box_of(" 0 TEXT 8 0 7 D 10 5 20 5 11 45 21 5 40 10 72 5 1 H"), 5 + s * h.left, 5,
             5 + s * h.right, 15);
  expect_box(box_of(" 0 TEXT 8 0 7 D 10 5 20 5 11 5 21 45 40 10 72 5 1 H"), -5, 5 + s * h.left, 5,
             5 + s * h.right);
}

TEST(DxfText, FollowsBlocks) {
  NEEDS_THE_FONT;
  const CapitalH h;
  const std::string block = " 0 BLOCK 2 B 10 0 20 0 0 TEXT 8 0 7 D 10 0 20 0 40 10 1 H 0 ENDBLK";
  expect_box(box_of(" 0 INSERT 8 0 2 B 10 50 20 50 50 90", block), 40, 50 + h.left, 50, 50 + h.right);
  expect_box(box_of(" 0 INSERT 8 0 2 B 10 50 20 50 41 -2 42 0.5", block), 50 - 2 * h.right, 50,
             50 - 2 * h.left, 55);
  // Attributes stand in the drawing, not in the block.
  const std::string hole = " 0 BLOCK 2 B 10 0 20 0 0 CIRCLE 8 C 10 0 20 0 40 1 0 ENDBLK";
  const Part part = part_of(
      " 0 INSERT 8 0 66 1 2 B 10 5 20 5 50 90 0 ATTRIB 8 A 7 D 10 50 20 30 40 10 2 TAG 1 H 0 SEQEND", hole);
  Box all;
  for (const Feature& feature : part.features) all.add(box(feature.target));
  expect_box(all, 4, 4, 50 + h.right, 40);
}

TEST(DxfText, CodesBecomeLetters) {
  EXPECT_EQ(words_of_text("%%c5%%D%%p1 %%065%%%").paragraphs[0], U"\u00D85\u00B0\u00B11 A%");
  EXPECT_EQ(words_of_text("a\\U+00E4\\b 50% ^I|^ 3").paragraphs[0], U"a\u00E4\\b 50%  |^3");
  EXPECT_EQ(words_of_text("\xD8 5").paragraphs[0], U"\u00D8 5");      // code page 1252
  EXPECT_EQ(words_of_text("\xC3\x98 5").paragraphs[0], U"\u00D8 5");  // UTF-8
  const DxfWords under = words_of_text("%%uab%%u");
  EXPECT_EQ(under.paragraphs[0], U"ab");
  EXPECT_EQ(under.ignored.size(), 1U);
}

TEST(DxfText, FormatCodesAreTakenOut) {
  const DxfWords words =
      words_of_mtext("{\\fArial|b1|i0|c0|p34;\\H2.5x;One\\~two}\\P\\C1;\\Lthree\\l \\S1/2; \\\\ \\{x\\}%%d");
  ASSERT_EQ(words.paragraphs.size(), 2U);
  EXPECT_EQ(words.paragraphs[0], U"One\u00A0two");
  EXPECT_EQ(words.paragraphs[1], U"three 1/2 \\ {x}\u00B0");
  EXPECT_EQ(words.font, "Arial");
  EXPECT_TRUE(words.bold);
  EXPECT_EQ(words.height_factor, 2.5);
  EXPECT_EQ(words.ignored, (std::set<std::string>{"\\L", "\\S"}));
  EXPECT_EQ(words_of_mtext("a\\H3;b").ignored, std::set<std::string>{"\\H"});
  for (const char* broken : {"\\", "\\f", "\\fArial", "{", "\\S", "%%", "%%1", "\\U+00", "^", "\\U+ZZZZ"})
    EXPECT_EQ(words_of_mtext(broken).paragraphs.size(), 1U) << broken;
}

TEST(DxfText, FontFilesNameFamilies) {
  EXPECT_EQ(face_of_font("C:\\Windows\\Fonts\\arialbd.ttf"), (FaceRequest{{"Arial"}, true, false}));
  EXPECT_EQ(face_of_font("timesi.TTF"), (FaceRequest{{"Times New Roman"}, false, true}));
  EXPECT_EQ(face_of_font("LiberationSans-BoldItalic.ttf"), (FaceRequest{{"LiberationSans"}, true, true}));
  EXPECT_EQ(face_of_font("txt.shx"), (FaceRequest{{"txt.shx"}}));
  EXPECT_EQ(face_of_font(""), FaceRequest{});
}

TEST(DxfMtext, StandsOnEachOfNinePoints) {
  NEEDS_THE_FONT;
  const CapitalH h;
  for (int attached = 1; attached <= 9; ++attached) {
    const double x = 50 - (attached - 1) % 3 * h.advance / 2, y = 20 + (attached - 1) / 3 * 5;
    expect_box(box_of(" 0 MTEXT 8 0 7 D 10 50 20 30 40 10 1 H 71 " + std::to_string(attached)), x + h.left, y,
               x + h.right, y + 10, std::to_string(attached));
  }
  // Lines are five thirds of the height apart, times group 44.
  expect_box(box_of(" 0 MTEXT 8 0 7 D 10 0 20 0 40 10 44 0.9 1 H\\PH\\PH"), h.left, -40, h.right, 0);
  expect_box(box_of(" 0 MTEXT 8 0 7 D 10 0 20 0 40 10 71 7 50 90 1 H"), -10, h.left, 0, h.right);
  expect_box(box_of(" 0 MTEXT 8 0 7 D 10 0 20 0 40 10 71 7 11 0 21 1 1 H"), -10, h.left, 0, h.right);
  // From below: its point and direction are the drawing's, and it reads mirrored.
  expect_box(box_of(" 0 MTEXT 8 0 7 D 10 50 20 0 40 10 71 7 11 -1 21 0 230 -1 1 H"), 50 - h.right, 0,
             50 - h.left, 10);
}

TEST(DxfMtext, IsWrappedAtItsWidth) {
  NEEDS_THE_FONT;
  const CapitalH h;
  const auto lines = [&](double letters) {
    const Box box = box_of(" 0 MTEXT 8 0 7 D 10 0 20 0 40 10 41 " + std::to_string(letters * h.advance) +
                           " 3 H~ 3 H~H~ 1 HH");
    return std::lround((box.height() - 10) * 3 / 50) + 1;
  };
  EXPECT_EQ(lines(0), 1);
  EXPECT_EQ(lines(2.5), 3);  // H H / H / HH, for a blank is less than half as wide
  EXPECT_EQ(lines(20), 1);
  EXPECT_EQ(lines(0.1), 4);
}

TEST(DxfText, WhatStandsForAFontIsSaid) {
  NEEDS_THE_FONT;
  const Part part = part_of(" 0 TEXT 8 0 7 SHX 10 0 20 0 40 10 1 %%uH");
  bool face = false, code = false;
  for (const Diagnostic& item : part.diagnostics.items()) {
    face = face || item.what.find("asks for 'txt.shx' is drawn with ") != std::string::npos;
    code = code || item.what.find("not followed (the letters are drawn without): 1 %%u") != std::string::npos;
  }
  EXPECT_TRUE(face);
  EXPECT_TRUE(code);
}

TEST(DxfText, LettersHaveHoles) {
  NEEDS_THE_FONT;
  const Part o = part_of(" 0 TEXT 8 0 7 D 10 0 20 0 40 10 1 O"),
             mirrored = part_of(" 0 TEXT 8 0 7 D 10 0 20 0 40 10 71 2 1 O");
  ASSERT_EQ(o.features.size(), 1U);
  ASSERT_EQ(o.features[0].target.size(), 1U);
  EXPECT_EQ(o.features[0].target[0].islands().size(), 1U);
  EXPECT_NEAR(area_of(o), area_of(mirrored), 1e-3);
}

TEST(DxfText, DamagedTextIsRefused) {
  NEEDS_THE_FONT;
  for (const char* entity :
       {" 0 TEXT 8 0 10 0 20 0 1 H", " 0 TEXT 8 0 10 0 20 0 40 0 1 H", " 0 MTEXT 8 0 40 3 1 H"})
    EXPECT_THROW(part_of(entity), InputError) << entity;
}

}  // namespace
}  // namespace clearcut::read
