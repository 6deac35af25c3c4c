// The page for the machine as PDF: the same as the page of HTML, on paper.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <pugixml.hpp>
#include <regex>

#include "base/error.h"
#include "base/file.h"
#include "report/sheet/sheet_writers.h"
#include "support/command.h"

namespace clearcut {
namespace {

namespace fs = std::filesystem;
using test_support::run_clearcut;
using test_support::ScratchFolder;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const fs::path kDrawer = fs::path(CLEARCUT_COMMAND).replace_filename("clearcut-sheet");

/// A plate with that many round pockets in rows of ten.
std::string plate(int pockets) {
  std::string text = "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
  for (int i = 0; i < pockets; ++i)
    text += "0\nCIRCLE\n8\nPOCKET_D2\n10\n" + std::to_string(20 * (i % 10)) + "\n20\n" +
            std::to_string(20 * (i / 10)) + "\n40\n7\n";
  return text + "0\nENDSEC\n0\nEOF\n";
}

const std::string kTool =
    "[[tool]]\nnumber = 3\nkind = \"endmill\"\nname = \"Schruppfräser <Ø8> größer, λ-Fase Ωµ\"\n"
    "diameter = 8\nfeed = 600\n";

/// What a program of poppler prints.
std::string printed(const std::string& command) {
  const ScratchFolder folder;
  EXPECT_EQ(std::system((command + " > '" + folder.path("out") + "'").c_str()), 0) << command;
  return read_file(folder.path("out"));
}

std::string in_one_line(const std::string& text) {
  return std::regex_replace(text, std::regex("[ \\n\\f]+"), " ");
}

std::string text_of(const std::string& pdf) {
  return in_one_line(printed("pdftotext -raw '" + pdf + "' -"));
}

int pages_of(const std::string& pdf) {
  const std::string info = printed("pdfinfo '" + pdf + "'");
  EXPECT_THAT(info, HasSubstr("A4"));
  return std::stoi(info.substr(info.find("Pages:") + 6));
}

/// Every text of a page of HTML but its picture's and its style.
void add_texts(const pugi::xml_node& node, std::vector<std::string>& texts) {
  for (const pugi::xml_node& child : node) {
    const std::string name = child.name();
    if (name == "svg" || name == "head") continue;
    if (child.type() == pugi::node_pcdata) texts.push_back(in_one_line(child.value()));
    add_texts(child, texts);
  }
}

std::vector<std::string> texts_of_page(const std::string& html) {
  pugi::xml_document page;
  EXPECT_TRUE(page.load_string(read_file(html).c_str()));
  std::vector<std::string> texts;
  add_texts(page, texts);
  return texts;
}

class SetupSheetPdf : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(kDrawer)) GTEST_SKIP() << "built without librsvg, pango and cairo";
    if (std::system("pdftotext -v > /dev/null 2>&1 && pdfinfo -v > /dev/null 2>&1") != 0)
      GTEST_SKIP() << "pdftotext is absent: install poppler-utils";
  }
  /// Plans a job with these pockets, and writes the sheet to files of these names.
  void plan(int pockets, const std::vector<std::string>& sheets) {
    folder.file("plate ΔΣ größer.dxf", plate(pockets));
    job = folder.file("job.toml", "[part]\nfile = \"plate ΔΣ größer.dxf\"\n" + kTool);
    program = folder.path("plate.ngc");
    for (const std::string& sheet : sheets) {
      const auto result =
          run_clearcut({"plan", job, "-o", program, "--setup-sheet", folder.path(sheet), "--quiet"});
      ASSERT_EQ(result.exit_code, 0) << result.err;
    }
  }

  ScratchFolder folder;
  std::string job, program;
};

TEST_F(SetupSheetPdf, SaysWhatThePageOfHtmlSays) {
  plan(3, {"sheet.html", "sheet.pdf"});
  const std::string text = text_of(folder.path("sheet.pdf"));
  const auto texts = texts_of_page(folder.path("sheet.html"));
  EXPECT_GT(texts.size(), 60U);
  for (const std::string& one : texts) EXPECT_NE(text.find(one), std::string::npos) << one;
  EXPECT_THAT(text, HasSubstr("endmill, Schruppfräser <Ø8> größer, λ-Fase Ωµ"));
  EXPECT_THAT(text, HasSubstr("plate ΔΣ größer"));
  EXPECT_EQ(pages_of(folder.path("sheet.pdf")), 1);
}

TEST_F(SetupSheetPdf, IsTheSameBytesEachTime) {
  plan(3, {"first.pdf", "second.PDF"});
  const std::string bytes = read_file(folder.path("first.pdf"));
  EXPECT_THAT(bytes, StartsWith("%PDF"));
  EXPECT_EQ(bytes, read_file(folder.path("second.PDF")));
  EXPECT_EQ(bytes.find("Date"), std::string::npos);
}

TEST_F(SetupSheetPdf, HasSeventeenOperationsOnOnePage) {
  plan(17, {"sheet.pdf"});
  EXPECT_EQ(pages_of(folder.path("sheet.pdf")), 1);
  EXPECT_THAT(text_of(folder.path("sheet.pdf")), HasSubstr(" 17 POCKET_D2"));
}

TEST_F(SetupSheetPdf, RepeatsTheHeadOfATableThatGoesOn) {
  plan(70, {"sheet.html", "sheet.pdf"});
  EXPECT_EQ(pages_of(folder.path("sheet.pdf")), 2);
  const std::string text = text_of(folder.path("sheet.pdf"));
  for (const std::string& one : texts_of_page(folder.path("sheet.html")))
    EXPECT_NE(text.find(one), std::string::npos) << one;
  const std::string second = in_one_line(printed("pdftotext -raw -f 2 '" + folder.path("sheet.pdf") + "' -"));
  EXPECT_THAT(second, StartsWith("Feature T Z from Z to Layers"));
  EXPECT_THAT(second, HasSubstr("page 2 of 2"));
}

TEST_F(SetupSheetPdf, HasASheetForEachSetUpWhereTheJobNamesIt) {
  folder.file("plate.dxf", plate(2));
  job = folder.file("job.toml",
                    "[stock]\nx = [-20, 40]\ny = [-20, 20]\nz = [-20, 0]\n[output]\nprogram = \"part.ngc\"\n"
                    "setup_sheet = \"sheet.pdf\"\n[[setup]]\nname = \"top\"\nfile = \"plate.dxf\"\n"
                    "[[setup]]\nname = \"underside\"\nfile = \"plate.dxf\"\nup = \"-Z\"\n" +
                        kTool);
  const auto result = run_clearcut({"plan", job, "--quiet"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(pages_of(folder.path("sheet.pdf")), 2);
  const std::string second = printed("pdftotext -raw -f 2 '" + folder.path("sheet.pdf") + "' -");
  EXPECT_THAT(second, StartsWith("plate, set-up 2 of 2 underside"));
}

TEST_F(SetupSheetPdf, OtherNamesAreHtml) {
  plan(1, {"sheet.pdf.txt"});
  EXPECT_THAT(read_file(folder.path("sheet.pdf.txt")), StartsWith("<!DOCTYPE html>"));
}

TEST_F(SetupSheetPdf, SaysThatNoFontIsInstalled) {
  plan(1, {});
  const std::string fonts =
      folder.file("none/fonts.conf", "<fontconfig><dir>/nonexistent</dir></fontconfig>");
  ::setenv("FONTCONFIG_FILE", fonts.c_str(), 1);
  const auto result = run_clearcut({"plan", job, "-o", program, "--setup-sheet", folder.path("sheet.pdf")});
  ::unsetenv("FONTCONFIG_FILE");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err,
              HasSubstr("sheet.pdf: no font is installed for its text; install fonts-dejavu-core"));
  EXPECT_FALSE(fs::exists(folder.path("sheet.pdf")) || fs::exists(program));
}

TEST_F(SetupSheetPdf, WritesNothingWhereItCannotBeWritten) {
  plan(1, {});
  const auto result =
      run_clearcut({"plan", job, "-o", program, "--setup-sheet", folder.path("absent/sheet.pdf")});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("absent/sheet.pdf: cannot be written"));
  EXPECT_FALSE(fs::exists(program));
}

TEST(SetupSheetWithoutPdf, IsRefusedBeforeAnythingIsPlanned) {
  try {  // as the command below, this program has none beside it
    report::require_pdf("sheet.pdf");
    GTEST_SKIP() << "clearcut-sheet is installed";
  } catch (const InputError&) {
  }
  const ScratchFolder folder;
  fs::copy_file(CLEARCUT_COMMAND, folder.path("clearcut"));
  folder.file("plate.dxf", plate(1));
  const std::string job = folder.file("job.toml", "[part]\nfile = \"plate.dxf\"\n" + kTool);
  const std::string line = "cd '" + folder.path("") + "' && ./clearcut plan job.toml -o plate.ngc " +
                           "--setup-sheet sheet.pdf 2> said; test $? -eq 2";
  EXPECT_EQ(std::system(line.c_str()), 0);
  EXPECT_EQ(read_file(folder.path("said")),
            "clearcut: sheet.pdf: this build writes no PDF; install librsvg2-dev, libpango1.0-dev and "
            "libcairo2-dev and build again, or name the set-up sheet .html, which any browser prints\n");
  EXPECT_THAT(folder.names(), ::testing::ElementsAre("clearcut", "job.toml", "plate.dxf", "said"));
}

}  // namespace
}  // namespace clearcut
