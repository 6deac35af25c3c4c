#include "read/common/foreign_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "read/job/read_part.h"

namespace clearcut::read {
namespace {

std::string refusal_of(const std::string& text, const std::string& file) {
  try {
    read_part_text(text, file, {});
  } catch (const InputError& error) {
    return error.what();
  }
  return "read";
}

struct Case {
  std::string file;
  std::string text;
  const char* what;
  const char* instead;
};

TEST(FileKind, IsToldByTheFirstBytesWhereNoNameDoes) {
  using K = FileKind;
  const std::pair<const char*, K> files[] = {{"ISO-10303-21;\n", K::kStep},
                                             {"\n {\"name\": 1}", K::kJson},
                                             {"M48\nMETRIC\n", K::kExcellon},
                                             {"%\nM48\nM72\n", K::kExcellon},
                                             {"G04 x*\n%FSLAX46Y46*%\n", K::kGerber},
                                             {"<svg><path d=\"\nM48 3 L9 9\"/></svg>", K::kSvg},
                                             {"0\nSECTION\n", K::kDxf},
                                             {"Dear Sir,\n", K::kUnknown}};
  for (const auto& [text, kind] : files) EXPECT_EQ(kind_of_content(text), kind) << text;
}

TEST(ForeignFiles, AreRefusedInOneLineWithWhatToDo) {
  using namespace std::string_literals;
  const std::string zip = "PK\3\4\24\0\0\0\10\0"s, stl = "solid x\nfacet normal 0 0 1\n";
  for (const Case& one : std::vector<Case>{{"a.3mf", zip, "mesh", "STEP"},
                                           {"a.zip", zip, "zip archive", "unpack"},
                                           {"a.fcstd", zip, "CAD program", "STEP"},
                                           {"a.stl", stl, "mesh", "STEP"},
                                           {"binary.stl", std::string(80, 'x') + "\1\0\0\0"s, "mesh", "STEP"},
                                           {"a.step", stl, "mesh", "STEP"},
                                           {"a.pdf", "%PDF-1.4\n", "printing", "SVG"},
                                           {"a.dxf", "%PDF-1.4\n", "printing", "SVG"},
                                           {"a.ai", "%PDF-1.5\n", "printing", "SVG"},
                                           {"a.png", "\x89PNG\r\n\x1a\n\0\0"s, "picture", "trace"},
                                           {"a.dwg", "AC1027\0\0\0"s, "DWG", "DXF"},
                                           {"a.igs", "S      1\n", "IGES", "STEP"},
                                           {"a.kicad_pcb", "(kicad_pcb (version 2))", "circuit board", "DXF"},
                                           {"a.scad", "cube([1,2,3]);\n", "OpenSCAD", "DXF"},
                                           {"a.nc", "G21\nG90\nM2\n", "program for a machine", "verify"}}) {
    const std::string refusal = refusal_of(one.text, one.file);
    EXPECT_THAT(refusal, ::testing::HasSubstr(one.what)) << one.file;
    EXPECT_THAT(refusal, ::testing::HasSubstr(one.instead)) << one.file;
    EXPECT_THAT(refusal, ::testing::StartsWith(one.file + ": this is "));
    EXPECT_EQ(refusal.find('\n'), std::string::npos);
  }
}

TEST(ForeignFiles, DrawingsWithoutATellingNameAreStillRead) {
  EXPECT_NO_THROW(refuse_foreign_content("  0\nSECTION\n", "drawing"));
  EXPECT_NO_THROW(refuse_foreign_content("<svg></svg>", "drawing.txt"));
  EXPECT_NO_THROW(refuse_foreign_name("drawing.txt"));
}

}  // namespace
}  // namespace clearcut::read
