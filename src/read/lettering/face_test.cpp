// Outlines and measures of letters beside FreeType's own pixels. Skipped where DejaVu Sans or the libraries are absent.
#include "read/lettering/face.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/error.h"
#include "read/lettering/lettering.h"
#include "read/repair/repair.h"

#if __has_include(<ft2build.h>)
#include <ft2build.h>
#include FT_FREETYPE_H

namespace clearcut::read {
namespace {

constexpr const char* kFile = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr double kSize = 100;  // mm of an em

const char* missing() {
  return std::filesystem::exists(kFile) ? nullptr : "DejaVu Sans (fonts-dejavu-core) is not installed";
}

/// FreeType's own drawing of a letter, 2000 pixels an em.
struct Pixels {
  double area = 0;     ///< em2
  double advance = 0;  ///< em
};

Pixels drawn(char32_t letter) {
  constexpr unsigned kPixels = 2000;
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  FT_Init_FreeType(&library);
  FT_New_Face(library, kFile, 0, &face);
  FT_Set_Pixel_Sizes(face, 0, kPixels);
  FT_Load_Char(face, letter, FT_LOAD_RENDER | FT_LOAD_NO_HINTING);
  const FT_Bitmap& bitmap = face->glyph->bitmap;
  double sum = 0;
  for (unsigned y = 0; y < bitmap.rows; ++y) {
    const unsigned char* row = bitmap.buffer + static_cast<std::ptrdiff_t>(y) * bitmap.pitch;
    for (unsigned x = 0; x < bitmap.width; ++x) sum += row[x] / 255.0;
  }
  const double advance = static_cast<double>(face->glyph->linearHoriAdvance) / 65536;
  FT_Done_Face(face);
  FT_Done_FreeType(library);
  return {sum / (double{kPixels} * kPixels), advance / kPixels};
}

double area_of(const Face& face, char32_t letter) {
  TextLoops loops;
  loops.add(face, letter, Affine::scaling(kSize, kSize));
  Diagnostics diagnostics;
  return area(repair(loops.take("letter", Compound{0, true}), {}, diagnostics)) / (kSize * kSize);
}

TEST(Face, LettersHaveTheAreaAndWidthOfFreeTypesPixels) {
  if (const char* why = missing()) GTEST_SKIP() << why;
  const Face face({{"DejaVu Sans"}});
  EXPECT_EQ(face.file_name(), "DejaVuSans.ttf");
  EXPECT_EQ(face.family(), "DejaVu Sans");
  for (const char32_t letter : U"ABRg8&@%äØ°±ß") {
    if (letter == 0) continue;
    const Pixels pixels = drawn(letter);
    EXPECT_NEAR(area_of(face, letter), pixels.area, 5e-4 * pixels.area) << std::uint32_t{letter};
    EXPECT_NEAR(face.advance(letter), pixels.advance, 1e-4) << std::uint32_t{letter};
  }
}

TEST(Face, AFaceThatIsBoldOrItalicIsFound) {
  if (const char* why = missing()) GTEST_SKIP() << why;
  const Face bold({{"DejaVu Sans"}, true});
  EXPECT_TRUE(bold.is_bold());
  EXPECT_GT(area_of(bold, U'l'), 1.3 * area_of(Face({{"DejaVu Sans"}}), U'l'));
}

TEST(Face, KerningBringsLettersNearer) {
  if (const char* why = missing()) GTEST_SKIP() << why;
  const Face face({{"DejaVu Sans"}});
  EXPECT_LT(face.kerning(U'A', U'V'), 0);
  EXPECT_EQ(face.kerning(U'H', U'H'), 0);
  Lettering lettering;
  EXPECT_NEAR(lettering.set_line(face, U"AV").width,
              face.advance(U'A') + face.advance(U'V') + face.kerning(U'A', U'V'), 1e-12);
}

TEST(Face, AnUnknownFamilyAndMissingLettersAreNamed) {
  if (const char* why = missing()) GTEST_SKIP() << why;
  Lettering lettering;
  const Face& face = lettering.face({{"No Such Family"}, false, false});
  EXPECT_EQ(face.family(), "");
  lettering.set_line(face, U"A\U000F1234");
  Diagnostics diagnostics;
  lettering.report(diagnostics, "plate.svg");
  ASSERT_EQ(diagnostics.items().size(), 2U);
  EXPECT_EQ(diagnostics.items()[0].severity, Severity::kWarning);
  EXPECT_NE(diagnostics.items()[0].what.find("'No Such Family' is drawn with " + face.file_name()),
            std::string::npos);
  EXPECT_EQ(diagnostics.items()[0].what.find('/'), std::string::npos);
  EXPECT_EQ(diagnostics.items()[1].severity, Severity::kSkipped);
  EXPECT_NE(diagnostics.items()[1].what.find("are left out"), std::string::npos);
}

TEST(Face, AWholeWordMirroredAndStretchedKeepsItsArea) {
  if (const char* why = missing()) GTEST_SKIP() << why;
  Lettering lettering;
  const Face& face = lettering.face({{"DejaVu Sans"}, false, false});
  double sum = 0;
  for (const char32_t letter : {U'O', U'p', U'R'}) sum += area_of(face, letter);
  TextLoops loops;
  loops.add(face, lettering.set_line(face, U"OpR"), Affine::rotation(0.3) * Affine::scaling(-30, 20));
  Diagnostics diagnostics;
  const double all = area(repair(loops.take("text", Compound{0, true}), {}, diagnostics));
  EXPECT_NEAR(all, sum * 600, 2e-4 * sum * 600);
}

}  // namespace
}  // namespace clearcut::read
#endif
